// Lightning strikes from storms alone, the same for the same moment, and its thunder comes as late as sound is slow.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/cloud_pattern.h"
#include "engine/weather/lightning.h"
#include "engine/weather/source.h"
#include "shaders/lib/lightning.glsl"

namespace {
using namespace luftpost;
using namespace luftpost::weather;

core::UtcSeconds noon() { return *core::parseUtc("2023-06-23T12:00Z"); }
Weather stormWeather() { return loadWeather("preset:storm").at(0.0, 0.0, noon()); }
constexpr double kGround = 316.0;

std::vector<Flash> within(Weather const& weather, double from, double to, double reach = 30e3) {
    return flashes(weather, 1, noon() + from, noon() + to, {0.0, 0.0}, reach, kGround);
}
}  // namespace

TEST(Lightning, StrikesFromStormsThatThunderAboutEverySixSeconds) {
    Weather storm = stormWeather();
    auto const found = within(storm, 0.0, 600.0);
    EXPECT_GT(found.size(), 40u);
    EXPECT_LT(found.size(), 250u);
    int toGround = 0;
    LayerPattern const pattern{storm.layers[0], 1};
    for (Flash const& flash : found) {
        toGround += flash.toGround;
        EXPECT_GT(flash.sourceWorld.y, static_cast<double>(storm.layers[0].base));
        EXPECT_LT(flash.sourceWorld.y, static_cast<double>(storm.layers[0].top));
        EXPECT_EQ(flash.groundWorld.y, kGround);
        EXPECT_LT(pattern.rank(flash.sourceWorld.x, -flash.sourceWorld.z), storm.layers[0].cover) << "inside a cloud";
    }
    EXPECT_NEAR(static_cast<double>(toGround) / static_cast<double>(found.size()), 0.35, 0.15);
    storm.thunder = false;
    EXPECT_TRUE(within(storm, 0.0, 600.0).empty());
    EXPECT_TRUE(within(loadWeather("preset:fair").at(0.0, 0.0, noon()), 0.0, 600.0).empty());
}

TEST(Lightning, IsTheSameHoweverTheTimeIsCut) {
    Weather const storm = stormWeather();
    auto const whole = within(storm, 0.0, 120.0);
    std::size_t k = 0;
    for (double t = 0.0; t < 120.0; t += 0.5)
        for (Flash const& flash : within(storm, t, t + 0.5)) {
            ASSERT_LT(k, whole.size());
            EXPECT_EQ(flash.time, whole[k].time);
            EXPECT_EQ(flash.seed, whole[k++].seed);
        }
    EXPECT_EQ(k, whole.size());
}

TEST(Lightning, FlickersAndIsGoneWithinHalfASecond) {
    Flash flash;
    flash.seed = 3;  // four strokes
    EXPECT_EQ(flashLight(flash, -0.01), 0.0);
    EXPECT_EQ(flashLight(flash, 0.0), 1.0);
    EXPECT_LT(flashLight(flash, 0.069), 0.2);
    EXPECT_GT(flashLight(flash, 0.071), 0.6);
    EXPECT_EQ(flashLight(flash, kFlashSeconds + 0.01), 0.0);
}

TEST(Thunder, ComesASecondLaterForEvery340Metres) {
    Flash flash;
    flash.sourceWorld = {3400.0, 1500.0, 0.0};
    flash.groundWorld = {3400.0, 300.0, 0.0};
    EXPECT_NEAR(thunderDelay(flash, {0.0, 1500.0, 0.0}), 10.0, 1e-9);
    EXPECT_NEAR(thunderDelay(flash, {0.0, 300.0, 0.0}), std::hypot(3400.0, 1200.0) / 340.0, 1e-9);
    flash.toGround = true;
    EXPECT_NEAR(thunderDelay(flash, {0.0, 300.0, 0.0}), 10.0, 1e-9) << "from the foot of its channel";
    EXPECT_NEAR(thunderDelay(flash, {0.0, 900.0, 0.0}), 10.0, 1e-9) << "from beside it";
}

TEST(Thunder, IsHeardOnceForEveryFlashNearEnough) {
    Weather const storm = stormWeather();
    glm::dvec3 const ear{0.0, 600.0, 0.0};
    std::size_t heard = 0;
    for (double t = 100.0; t < 300.0; t += 1.0 / 60.0)
        for (Flash const& flash : thunders(storm, 1, noon() + t, noon() + t + 1.0 / 60.0, ear, kGround)) {
            double const arrives = flash.time + thunderDelay(flash, ear) - noon();
            EXPECT_GT(arrives, t - 1e-6);
            EXPECT_LT(arrives, t + 1.0 / 60.0 + 1e-6);
            ++heard;
        }
    std::size_t expected = 0;
    for (Flash const& flash : within(storm, 0.0, 300.0, 20e3)) {
        double const arrives = flash.time + thunderDelay(flash, ear) - noon();
        expected += arrives > 100.0 && arrives <= 300.0;
    }
    EXPECT_GT(heard, 5u);
    EXPECT_EQ(heard, expected);
}

TEST(Channel, LeadsFromTheCloudToTheGroundInSmallBends) {
    glm::vec3 const from{4000.0f, 1200.0f, -2000.0f}, to{4200.0f, 300.0f, -1900.0f};
    EXPECT_EQ(glsl::channelJoint(from, to, 77.0f, 0), from);
    EXPECT_EQ(glsl::channelJoint(from, to, 77.0f, glsl::kChannelJoints), to);
    float length = 0.0f, aside = 0.0f;
    for (int k = 1; k <= glsl::kChannelJoints; ++k) {
        glm::vec3 const a = glsl::channelJoint(from, to, 77.0f, k - 1), b = glsl::channelJoint(from, to, 77.0f, k);
        EXPECT_LT(glm::distance(a, b), 0.4f * glm::distance(from, to));
        length += glm::distance(a, b);
        glm::vec3 const way = glm::normalize(to - from), off = b - from;
        aside = std::max(aside, glm::length(off - way * glm::dot(off, way)));
    }
    EXPECT_GT(length, 1.05f * glm::distance(from, to)) << "bent";
    EXPECT_LT(length, 2.0f * glm::distance(from, to));
    EXPECT_GT(aside, 20.0f);
    float reach = 0.0f;
    EXPECT_NEAR(glsl::angleToStretch(glm::vec3{1.0f, 0.0f, 0.0f}, {100.0f, -50.0f, 10.0f}, {100.0f, 50.0f, 10.0f}, reach), 0.1f, 1e-3f);
    EXPECT_NEAR(reach, 100.0f, 1e-3f);
}
