// What the land does to the wind, against what is published of ridges and hills.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/weather/slope_wind.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
/// A ridge of bell shape that runs north, its crest at east 0. m.
struct Ridge {
    double height, width;
    Relief relief{[h = height, w = width](double east, double) {
        core::GroundSample sample;
        sample.height = 300.0 + h * std::exp(-east * east / (2.0 * w * w));
        return sample;
    }};
    SlopeWind at(double east, double above, glm::dvec2 wind, double stable = 0.0) const {
        return slopeWind(relief.bands(east, 0.0), wind, above, stable);
    }
    double best(double above, glm::dvec2 wind) const {
        double most = 0.0;
        for (double east = -3000.0; east <= 3000.0; east += 50.0) most = std::max(most, at(east, above, wind).lift);
        return most;
    }
};
constexpr glm::dvec2 kWest{10.0, 0.0};
}  // namespace

// "With winds of 20 to 25 knots it is possible to soar up to two times the height of the obstacle" (Wikipedia, "Lift (soaring)"), with gliders that
// sink at about 0.8 m/s.
TEST(SlopeWind, ARidgeCarriesAGliderUpToTwiceItsHeight) {
    for (double const height : {150.0, 300.0}) {
        Ridge const ridge{height, 2.0 * height};
        EXPECT_GT(ridge.best(100.0, kWest), 1.0) << height;
        EXPECT_LT(ridge.best(100.0, kWest), 3.0) << height;
        EXPECT_GT(ridge.best(height, kWest), 0.7) << height;
        EXPECT_LT(ridge.best(2.0 * height, kWest), 0.85) << height;
        EXPECT_LT(ridge.best(4.0 * height, kWest), 0.25) << height;
    }
}

TEST(SlopeWind, LiftsBeforeTheCrestAndSinksBehindAndSumsToNothing) {
    Ridge const ridge{300.0, 600.0};
    double sum = 0.0, sizes = 0.0;
    for (double east = -20000.0; east < 20000.0; east += 40.0) {
        double const lift = ridge.at(east, 100.0, kWest).lift;
        bool const onSlope = std::abs(east) > 100.0 && std::abs(east) < 1500.0;
        EXPECT_TRUE(!onSlope || (lift > 0.0) == (east < 0.0)) << east;
        sum += lift;
        sizes += std::abs(lift);
    }
    EXPECT_GT(sizes, 10.0);
    EXPECT_LT(std::abs(sum), 0.01 * sizes);
}

TEST(SlopeWind, IsNothingInCalmOverFlatLandHighUpAndAlongTheRidge) {
    Ridge const ridge{300.0, 600.0};
    SlopeWind const calm = ridge.at(-600.0, 50.0, {0.0, 0.0});
    EXPECT_EQ(calm.lift, 0.0);
    EXPECT_EQ(calm.variance, 0.0);
    EXPECT_EQ(glm::length(calm.wind), 0.0);
    EXPECT_NEAR(ridge.at(-600.0, 50.0, {0.0, 10.0}).lift, 0.0, 1e-9);
    EXPECT_EQ(finestFelt(2500.0), kReliefBands);
    Relief const flat{[](double, double) { return core::GroundSample{316.0, {0.0, 1.0, 0.0}, core::Surface::grass}; }};
    SlopeWind const level = slopeWind(flat.bands(1234.0, 567.0), {20.0, 5.0}, 30.0, 1.0);
    EXPECT_LT(std::abs(level.lift) + glm::length(level.wind) + level.variance, 1e-9);
}

// Taylor and Lee (1984): over the crest of a ridge the wind gains 2 H/L of itself, L half the width at half the height, near the
// ground; the outer flow less. For a bell of 600 m, L is 706 m.
TEST(SlopeWind, IsFasterOverTheCrestAndSlowerAtTheFoot) {
    double const height = 100.0, length = 706.0;
    Ridge const ridge{height, 600.0};
    double const gain = ridge.at(0.0, 20.0, kWest).wind.x / 10.0;
    EXPECT_GT(gain, 0.5 * 2.0 * height / length);
    EXPECT_LT(gain, 1.1 * 2.0 * height / length);
    EXPECT_LT(ridge.at(-1500.0, 20.0, kWest).wind.x, -0.2);
}

TEST(SlopeWind, ASteepLeeIsRoughInAStrongWindAndARotorNeedsBoth) {
    Ridge const steep{350.0, 400.0}, gentle{60.0, 600.0};
    double const lee = std::sqrt(steep.at(400.0, 80.0, {15.0, 0.0}).variance), before = std::sqrt(steep.at(-400.0, 80.0, {15.0, 0.0}).variance);
    EXPECT_GT(lee, 2.0);
    EXPECT_GT(lee, 1.7 * before);
    EXPECT_LT(lee, 5.0);
    EXPECT_LT(std::sqrt(gentle.at(400.0, 80.0, {15.0, 0.0}).variance), 0.5);
    EXPECT_LT(std::sqrt(steep.at(400.0, 80.0, {4.0, 0.0}).variance), 0.5);
}

TEST(SlopeWind, StableAirLiftsLessNearTheGround) {
    Ridge const ridge{300.0, 600.0};
    EXPECT_LT(ridge.at(-600.0, 40.0, kWest, 1.0).lift, 0.6 * ridge.at(-600.0, 40.0, kWest, 0.0).lift);
    EXPECT_NEAR(ridge.at(-600.0, 400.0, kWest, 1.0).lift, ridge.at(-600.0, 400.0, kWest, 0.0).lift, 1e-12);
}

TEST(SlopeWind, ChangesByLittleFromMetreToMetre) {
    Ridge const ridge{400.0, 350.0};
    SlopeWind last = ridge.at(-2000.0, 60.0, {15.0, 3.0});
    for (double east = -1999.0; east < 2000.0; east += 1.0) {
        SlopeWind const now = ridge.at(east, 60.0, {15.0, 3.0});
        ASSERT_LT(std::abs(now.lift - last.lift), 0.04) << east;
        ASSERT_LT(glm::length(now.wind - last.wind), 0.06) << east;
        last = now;
    }
}

TEST(Relief, WaterAndSnowAreColdGround) {
    Relief const half{[](double east, double) {
        return core::GroundSample{300.0, {0.0, 1.0, 0.0}, east < 0.0 ? core::Surface::water : core::Surface::grass};
    }};
    EXPECT_LT(half.warmth(-3000.0, 0.0), 0.3);
    EXPECT_NEAR(half.warmth(3000.0, 0.0), 1.0, 1e-6);
}
