// Where trees stand.
#include "engine/terrain/vegetation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luftpost::terrain {
namespace {
TEST(Vegetation, StandsOnTheLandAndNeverInWaterOrOnTheAirfield) {
    Land const land{1, 316.0};
    std::size_t trees = 0;
    for (int y = -12; y < 20; y += 3)
        for (int x = -12; x < 20; x += 3)
            for (Tree const& tree : treesOf(land, {x, y})) {
                double const east = x * kTreeTile + static_cast<double>(tree.east), north = y * kTreeTile + static_cast<double>(tree.north);
                ++trees;
                EXPECT_NEAR(static_cast<double>(tree.altitude), land.height(east, north), 0.8);
                EXPECT_NE(land.ground(east, north).surface, core::Surface::water);
                glm::dvec2 const place = glm::abs(land.runway().alongAcross(east, north));
                EXPECT_TRUE(place.x > 600.0 || place.y > 80.0) << "on the airfield";
                EXPECT_GT(tree.height, 3.0f);
                EXPECT_LT(tree.height, 30.0f);
            }
    EXPECT_GT(trees, 1000u);
}

TEST(Vegetation, IsTheSameEveryTime) {
    Land const land{3, 100.0};
    std::vector<Tree> const once = treesOf(land, {40, -13}), again = treesOf(land, {40, -13});
    ASSERT_GT(once.size(), 10u);
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].altitude, again[i].altitude);
}

TEST(Vegetation, GrowsDenserInSomePlacesThanInOthers) {
    Land const land{1, 316.0};
    std::size_t fewest = 100000, most = 0;
    for (int i = 0; i < 60; ++i) {
        std::size_t const count = treesOf(land, {i * 3, i * 2 - 40}).size();
        fewest = std::min(fewest, count);
        most = std::max(most, count);
    }
    EXPECT_LT(fewest, 20u);
    EXPECT_GT(most, 500u);
}
}  // namespace
}  // namespace luftpost::terrain
