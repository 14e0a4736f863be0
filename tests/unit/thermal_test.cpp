// Thermals under cumulus and without: where they stand, how they lean, when there are none.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/cloud_column.h"
#include "engine/weather/cloud_depth.h"
#include "engine/weather/convection.h"
#include "engine/weather/noise_volume.h"
#include "tests/unit/cloud_air_sky.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
using Sky = luftpost::tests::CloudAirSky;
constexpr double kGround = luftpost::tests::kFlatGround;
core::UtcSeconds at(std::string_view time) { return *core::parseUtc(time); }
constexpr std::string_view kNoon = "2023-06-23T12:00Z";
}  // namespace

TEST(Thermals, SumToNothingOverAHundredKilometresOfFlatLand) {
    for (char const* preset : {"preset:fair", "preset:clear", "preset:broken", "preset:storm"}) {
        Sky const sky{preset, at(kNoon)};
        for (double const height : {200.0, 900.0}) {
            double sum = 0.0, squares = 0.0;
            int const n = 90;
            for (int i = 0; i < n * n; ++i) {
                double const lift = sky.lift((i % n) * 1117.0 - 50000.0, (i / n) * 1109.0 - 50000.0, height);
                sum += lift;
                squares += lift * lift;
            }
            double const rms = std::sqrt(squares / (n * n));
            EXPECT_GT(rms, 0.1) << preset << height;
            EXPECT_LT(std::abs(sum / (n * n)), 0.05 * rms) << preset << height;
        }
    }
}

// Where the picture has cloud overhead (optical depth above 0.3), the air rises at its base; between the clouds it sinks.
TEST(Thermals, StandUnderTheVisibleOutlineOfTheCumulus) {
    static NoiseVolumes const noise = makeNoise(kNoiseSeed, 2);
    Sky const sky{"preset:fair", at(kNoon)};
    Weather const& weather = sky.clouds.weather;
    CloudColumns const columns{weather, 1};
    glsl::CloudShape const shape = cloudShape(weather, 1, glm::dvec2{0.0});
    double const base = static_cast<double>(weather.layers[0].base) - kGround;
    ASSERT_EQ(weather.layers[0].genus, Genus::Cu);
    int visible = 0, risingUnderCloud = 0, rising = 0, n = 5000;
    for (int i = 0; i < n; ++i) {
        double const east = (i % 71) * 613.0, north = (i / 71) * 587.0;
        float const depth = layerDepth(columns.at(east, north).layers[0], shape.layers[0], {static_cast<float>(east), static_cast<float>(-north)}, noise);
        bool const lifts = sky.lift(east, north, base - 5.0) > 0.0;
        visible += depth > 0.3f;
        rising += lifts;
        risingUnderCloud += depth > 0.3f && lifts;
    }
    EXPECT_NEAR(static_cast<double>(visible) / n, 0.35, 0.05);
    EXPECT_GT(risingUnderCloud, 0.9 * rising) << "what rises is under cloud that one sees";
    EXPECT_GT(risingUnderCloud, 0.6 * visible) << "and most of what is under it rises";
}

TEST(Thermals, LeanWithTheWindByItsIntegralOverTheWayToTheBase) {
    Sky const sky{"preset:fair", at(kNoon)};
    Layer const& cumulus = sky.clouds.weather.layers[0];
    double const base = static_cast<double>(cumulus.base) - kGround, foot = 350.0;
    double const speed = riseSpeed(static_cast<double>(cumulus.top - cumulus.base));
    glm::dvec2 drift{0.0};
    for (double z = foot + 5.0; z < base - 5.0; z += 10.0) drift += 10.0 / speed * sky.field.windAt(0.0, 0.0, kGround + z, kGround, sky.time);
    ASSERT_GT(glm::length(drift), 300.0);
    // How alike the lift at the base and that lower down are, when the latter is looked for so far upwind.
    auto const likeness = [&](double share) {
        double both = 0.0, low = 0.0, high = 0.0;
        for (int i = 0; i < 1500; ++i) {
            double const east = (i % 40) * 353.0, north = (i / 40) * 367.0;
            double const a = sky.lift(east, north, base - 5.0), b = sky.lift(east - share * drift.x, north - share * drift.y, foot);
            both += a * b;
            low += b * b;
            high += a * a;
        }
        return both / std::sqrt(low * high);
    };
    EXPECT_GT(likeness(1.0), 0.9);
    EXPECT_LT(likeness(0.0), 0.6);
    EXPECT_LT(likeness(-1.0), 0.5);
}

TEST(Thermals, AreAsStrongAsTheSunAndNoneByNightInRainAndInTheStandardAtmosphere) {
    double const noon = Sky{"preset:fair", at(kNoon)}.strongest(500.0);
    EXPECT_GT(noon, 1.0);
    EXPECT_LT(noon, 3.0);
    double const morning = Sky{"preset:fair", at("2023-06-23T06:30Z")}.strongest(500.0);
    EXPECT_GT(morning, 0.0);
    EXPECT_LT(morning, 0.6 * noon);
    EXPECT_LT(Sky("preset:fair", at("2023-12-21T12:00Z")).strongest(500.0), 0.6 * noon);
    EXPECT_LT(Sky("preset:fair", at(kNoon), core::Surface::water).strongest(500.0), 0.4 * noon);
    EXPECT_EQ(Sky("preset:fair", at("2023-06-23T23:00Z")).strongest(500.0), 0.0);
    EXPECT_EQ(Sky("preset:overcast", at(kNoon)).strongest(300.0), 0.0);
}

TEST(Thermals, OfAHotDayNeedNoCloudAndEndAtTheMixingHeight) {
    Sky const noon{"preset:clear", at(kNoon)};
    EXPECT_GT(noon.strongest(400.0), 1.0);
    EXPECT_LT(noon.strongest(400.0), 3.0);
    EXPECT_EQ(noon.strongest(noon.clouds.stirring.depth + 10.0), 0.0);
    EXPECT_EQ(Sky("preset:clear", at("2023-06-23T23:00Z")).strongest(400.0), 0.0);
    EXPECT_EQ(Sky("preset:calm", at(kNoon)).strongest(400.0), 0.0);
}
