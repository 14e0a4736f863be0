// The height function: one land for the eye and for the wheels.
#include "engine/terrain/land.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/core/frames.h"
#include "engine/terrain/raw_land.h"

namespace luftpost::terrain {
namespace {
TEST(Land, GivesTheSameBitsForOnePointAndForMany) {
    Land const land{1, 316.0};
    std::vector<double> east, north;
    for (int i = 0; i < 333; ++i) east.push_back(i * 137.31 - 9000.0), north.push_back(i * i * 3.7 - 20000.0);
    std::vector<double> heights(east.size());
    land.heights(east, north, heights);
    for (std::size_t i = 0; i < east.size(); ++i) EXPECT_EQ(heights[i], land.height(east[i], north[i])) << i;
}

TEST(Land, GivesTheSameBitsInVectorAndInScalarCode) {
    // The land's loop is vector code; this call, with this file's flags, is scalar.
    Land const land{5, 0.0};
    for (int i = 0; i < 500; ++i) {
        double const east = 60000.0 + i * 977.7, north = -i * 313.1;
        float const scalar = raw::height(east + land.homeInRawLand().x, north + land.homeInRawLand().y, 5);
        EXPECT_EQ(land.height(east, north), land.waterLevel() + static_cast<double>(scalar)) << i;
    }
}

TEST(Land, DependsOnItsSeed) {
    Land const one{1, 316.0}, again{1, 316.0}, two{2, 316.0};
    EXPECT_EQ(one.height(5000.0, 5000.0), again.height(5000.0, 5000.0));
    EXPECT_NE(one.height(5000.0, 5000.0), two.height(5000.0, 5000.0));
}

TEST(Land, RisesWithItsBase) {
    Land const low{3, 0.0}, high{3, 1250.0};
    for (double at : {0.0, 700.0, 12000.0, 80000.0}) EXPECT_NEAR(high.height(at, -at) - low.height(at, -at), 1250.0, 1e-9);
    EXPECT_NEAR(high.waterLevel() - low.waterLevel(), 1250.0, 1e-9);
}

TEST(Land, HasALevelHomeAirfieldAtTheBase) {
    for (unsigned seed = 1; seed < 12; ++seed) {
        Land const land{seed, 316.0};
        Runway const& runway = land.runway();
        EXPECT_EQ(land.height(0.0, 0.0), 316.0);
        for (double along = -449.0; along <= 449.0; along += 35.0)
            for (double across : {-14.0, 0.0, 14.0}) {
                glm::dvec2 const p = runway.directionEastNorth * along + glm::dvec2{runway.directionEastNorth.y, -runway.directionEastNorth.x} * across;
                core::GroundSample const ground = land.ground(p.x, p.y);
                EXPECT_EQ(ground.height, 316.0);
                EXPECT_EQ(ground.surface, core::Surface::runway);
                EXPECT_DOUBLE_EQ(ground.normalWorld.y, 1.0);
            }
        EXPECT_NEAR(glm::length(runway.threshold(false)), 450.0, 1e-6);
        EXPECT_NEAR(std::sin(runway.heading), runway.directionEastNorth.x, 1e-12);
        EXPECT_NEAR(std::cos(runway.heading), runway.directionEastNorth.y, 1e-12);
    }
}

TEST(Land, LeavesTheApproachesClearAndTheSurroundingsLow) {
    for (unsigned seed = 1; seed < 12; ++seed) {
        Land const land{seed, 316.0};
        for (double distance = 200.0; distance < 15000.0; distance += 400.0)
            for (int side : {-1, 1}) {
                glm::dvec2 const p = land.runway().directionEastNorth * (side * (450.0 + distance));
                EXPECT_LT(land.height(p.x, p.y) - 316.0, 12.0 + distance * 0.065) << seed << " at " << distance;
            }
        for (int i = 0; i < 2000; ++i) {
            double const angle = i * 2.399963, radius = 15000.0 * std::sqrt(i / 2000.0);
            EXPECT_LT(land.height(radius * std::cos(angle), radius * std::sin(angle)) - 316.0, 1000.0);
        }
    }
}

TEST(Land, HasPlainsRangesAndLakes) {
    Land const land{1, 316.0};
    int wet = 0, plain = 0, high = 0, all = 0;
    for (double east = -300000.0; east < 300000.0; east += 9700.0)
        for (double north = -300000.0; north < 300000.0; north += 9700.0) {
            core::GroundSample const ground = land.ground(east, north);
            ++all;
            wet += ground.surface == core::Surface::water;
            plain += ground.normalWorld.y > 0.998 && ground.height < 600.0;
            high += ground.height > 1300.0;
            EXPECT_GE(ground.height, land.waterLevel());
            EXPECT_LT(ground.height, 3900.0);
        }
    EXPECT_GT(wet, all / 100);
    EXPECT_LT(wet, all / 4);
    EXPECT_GT(plain, all / 4);
    EXPECT_GT(high, all / 100);
}

TEST(Land, IsSmoothEnoughForItsMeshesWhereOneCanLand) {
    // On slopes below 10 degrees linear interpolation over 12 m stays within 0.1 m, but for one point in 200 (crests).
    int bad = 0, gentle = 0;
    for (double origin : {0.0, 1.0e6, 1.0e7}) {
        Land const land{1, 316.0};
        for (int i = 0; i < 4000; ++i) {
            double const east = origin + (i % 63) * 1713.0, north = (i / 63) * 1517.0;
            double const left = land.height(east - 6.0, north), right = land.height(east + 6.0, north);
            if (land.ground(east, north).normalWorld.y < std::cos(core::radians(10.0))) continue;
            ++gentle;
            bad += std::abs(0.5 * (left + right) - land.height(east, north)) > 0.1;
        }
    }
    EXPECT_GT(gentle, 6000);
    EXPECT_LT(bad, gentle / 200);
}

TEST(Land, HasNoStepsAnywhere) {
    // The steepest crag climbs 4 m a metre; a step would show as more than that over a centimetre.
    for (double origin : {0.0, 3.0e6, -1.0e7}) {
        Land const land{2, 113.0};
        for (int i = 1; i < 20000; ++i) {
            double const east = origin + i * 29.3;
            ASSERT_LT(std::abs(land.height(east + 0.01, 777.0) - land.height(east, 777.0)), 0.05) << east;
        }
    }
}

TEST(Land, NormalsStandOnTheSlope) {
    Land const land{1, 316.0};
    double const h = 2.0;
    for (int i = 0; i < 300; ++i) {
        double const east = 40000.0 + i * 331.0, north = 9000.0 + i * 77.0;
        core::GroundSample const ground = land.ground(east, north);
        if (ground.surface == core::Surface::water) continue;
        EXPECT_NEAR(glm::length(ground.normalWorld), 1.0, 1e-12);
        double const slope = (land.height(east + h, north) - land.height(east - h, north)) / (2.0 * h);
        EXPECT_NEAR(-ground.normalWorld.x / ground.normalWorld.y, slope, 0.05);
    }
}
}  // namespace
}  // namespace luftpost::terrain
