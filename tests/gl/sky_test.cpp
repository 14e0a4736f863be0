// The sky on the GPU against the C++ build of the same library, and properties that a sky has.
#include <cmath>

#include "engine/sky/atmosphere.h"
#include "shaders/lib/atmosphere.glsl"
#include "tests/gl/sky_fixture.h"

namespace {
using namespace luftpost;
using test::skySnapshot;

class Sky : public test::GlTest {
protected:
    test::SkyRig& rig() {
        static test::SkyRig made{{64, 48}};
        return made;
    }
};

float luminanceAt(test::SkyPicture const& picture, int x, int y) { return sky::luminance(picture.at(x, y)); }

TEST_F(Sky, IsWhatTheSameLibraryComputesOnTheCpu) {
    sky::AtmosphereTables const tables{sky::atmosphere({})};
    for (double sun : {45.0, 5.0, -4.0}) {
        for (double azimuth : {0.0, 140.0}) {
            auto snapshot = skySnapshot(300.0, azimuth, 25.0, sun);
            auto const picture = rig().draw(snapshot);
            glm::dvec3 const ahead = sky::directionWorld(core::radians(azimuth), core::radians(25.0));
            glm::vec3 const cpu = tables.radiance(300.0, ahead, snapshot.sky.sunDirectionWorld);
            glm::vec3 const gpu = picture.at(32, 24);
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(gpu[i] / cpu[i], 1.0f, 0.08f) << sun << " " << azimuth << " " << i;
        }
    }
}

// Table six, of what is above and below a cloud: the level plane's light, and under it land through the air.
TEST_F(Sky, KnowsWhatIsAroundACloud) {
    sky::AtmosphereTables const tables{sky::atmosphere({})};
    for (double const sun : {60.0, 16.0, -3.0}) {
        auto snapshot = skySnapshot(300.0, 0.0, 25.0, sun);
        rig().draw(snapshot);
        std::vector<float> const around = rig().skyPass().around().readFloats();
        for (int const column : {0, 5, 8}) {
            double const altitude = static_cast<double>(glsl::aroundAltitude(static_cast<float>(column), 16.0f));
            glm::vec3 const level = tables.skyIrradiance(altitude, core::radians(sun)) / static_cast<float>(core::kPi);
            glm::vec3 const air = tables.radiance(altitude, {0.0, -1.0, 0.0}, snapshot.sky.sunDirectionWorld);
            glm::vec3 const down = air + rig().skyPass().light().groundRadiance * tables.transmittance(altitude, -0.5 * core::kPi, std::max(altitude, 1.0));
            for (int i = 0; i < 3; ++i) {
                float const above = around[static_cast<std::size_t>(4 * column + i)], below = around[static_cast<std::size_t>(4 * (16 + column) + i)];
                EXPECT_NEAR(above / level[i], 1.0f, 0.05f) << sun << " " << altitude << " " << i;
                EXPECT_GT(below / down[i], 0.97f) << sun << " " << altitude << " " << i << ": along the level there is more air";
                EXPECT_LT(below / down[i], sun > 0.0 ? 2.0f : 20.0f) << sun << " " << altitude << " " << i;
            }
        }
    }
}

TEST_F(Sky, IsFiniteAndNeverBlackFromTheGroundToTwelveKilometresByDayAndNight) {
    for (double altitude : {2.0, 3000.0, 12000.0})
        for (double sun : {60.0, 6.0, 0.0, -3.0, -12.0, -40.0})
            for (double azimuth : {0.0, 180.0}) {
                auto snapshot = skySnapshot(altitude, azimuth, 0.0, sun);
                auto const picture = rig().draw(snapshot);
                for (float value : picture.values) {
                    ASSERT_TRUE(std::isfinite(value));
                    ASSERT_GE(value, 0.0f);
                }
                EXPECT_GT(luminanceAt(picture, 10, 40), 5e-10f) << altitude << " " << sun;
                EXPECT_GT(luminanceAt(picture, 10, 5), 1e-10f) << altitude << " " << sun;
            }
}

TEST_F(Sky, GrowsDarkerFromHorizonToZenithWithoutAStep) {
    auto snapshot = skySnapshot(2.0, 0.0, 30.0, 45.0);
    auto const picture = rig().draw(snapshot);
    for (int y = 10; y < 47; ++y) {
        float const ratio = luminanceAt(picture, 32, y + 1) / luminanceAt(picture, 32, y);
        EXPECT_LT(ratio, 1.02f) << y;
        EXPECT_GT(ratio, 0.85f) << y;
    }
}

TEST_F(Sky, MeetsFarLandWithoutALine) {
    // A black wall 300 km away is all but air; the sky above it begins where it ends.
    for (double azimuth : {0.0, 90.0, 180.0}) {
        auto snapshot = skySnapshot(10000.0, azimuth, -3.2, 45.0);  // the horizon dips 3.2 degrees
        snapshot.camera.horizontalFov = 0.2;  // the two pixels lie 0.4 degrees apart: a true line, not the sky's own gradient
        auto const picture = rig().draw(snapshot, 300000.0f);
        float const below = luminanceAt(picture, 32, 23), above = luminanceAt(picture, 32, 25);
        EXPECT_NEAR(below / above, 1.0f, 0.15f) << azimuth;
    }
}

TEST_F(Sky, HasNoSeamOppositeTheSunOnAMoonlitNight) {
    auto snapshot = skySnapshot(300.0, 0.0, 20.0, -25.0);  // looks away from the sun, which stands at azimuth 180
    snapshot.camera.horizontalFov = 0.3;
    snapshot.sky.moonDirectionWorld = sky::directionWorld(1.2, 0.4);
    auto const picture = rig().draw(snapshot);
    auto const dimmest = [&](int x) {  // of a column: without the stars
        float least = luminanceAt(picture, x, 0);
        for (int y = 1; y < 48; ++y) least = std::min(least, luminanceAt(picture, x, y));
        return least;
    };
    for (int x = 0; x < 63; ++x) EXPECT_NEAR(dimmest(x + 1) / dimmest(x), 1.0f, 0.02f) << x;
}

TEST_F(Sky, VeilsTheLandMoreTheFartherItIs) {
    auto snapshot = skySnapshot(500.0, 0.0, -2.0, 45.0);
    float previous = 0.0f;
    for (float distance : {100.0f, 1000.0f, 10000.0f, 30000.0f, 100000.0f}) {
        float const light = luminanceAt(rig().draw(snapshot, distance), 32, 10);
        EXPECT_GT(light, previous) << distance;
        previous = light;
    }
}

TEST_F(Sky, ShowsTheSunsDiscWhereTheSunStands) {
    auto snapshot = skySnapshot(2.0, 180.0, 30.0, 30.0);
    snapshot.camera.horizontalFov = 0.05;
    auto const picture = rig().draw(snapshot);
    EXPECT_GT(luminanceAt(picture, 32, 24), 5000.0f);
    EXPECT_LT(luminanceAt(picture, 2, 2), 5.0f);
    float sum = 0.0f;
    float const pixel = 2.0f * std::tan(0.025f) / 64.0f;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) sum += luminanceAt(picture, x, y) * pixel * pixel;
    EXPECT_NEAR(sum, sky::luminance(rig().skyPass().light().sun), 0.08f);
}

TEST_F(Sky, HasStarsAtNightAndNoneByDay) {
    auto const spread = [&](double sun) {
        auto snapshot = skySnapshot(2.0, 30.0, 50.0, sun);
        auto const picture = rig().draw(snapshot);
        float brightest = 0.0f, sum = 0.0f;
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                brightest = std::max(brightest, luminanceAt(picture, x, y));
                sum += luminanceAt(picture, x, y) / (64.0f * 48.0f);
            }
        return brightest / sum;
    };
    EXPECT_GT(spread(-30.0), 5.0f);
    EXPECT_LT(spread(30.0), 4.0f);
}
}  // namespace
