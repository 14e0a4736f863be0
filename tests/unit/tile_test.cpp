// The parts of a large picture.
#include "engine/render/tile.h"

#include <gtest/gtest.h>

namespace {
using namespace luftpost::render;

TEST(Tile, TilesCoverEveryPixelOnceInRowsFromTheTop) {
    glm::ivec2 const picture{1300, 515};
    std::vector<Tile> const tiles = tilesOf(picture, 512);
    ASSERT_EQ(tiles.size(), 6u);
    EXPECT_EQ(tiles.front().corner, glm::ivec2(0, 512));
    EXPECT_EQ(tiles.front().size, glm::ivec2(512, 3));
    EXPECT_EQ(tiles.back().corner, glm::ivec2(1024, 0));
    int pixels = 0;
    for (Tile const& tile : tiles) pixels += tile.size.x * tile.size.y;
    EXPECT_EQ(pixels, picture.x * picture.y);
}

TEST(Tile, AMarginEndsWhereThePictureDoes) {
    Tile const tile{{1300, 515}, {0, 0}, {512, 512}};
    EXPECT_EQ(withMargin(tile, 8), (Tile{{1300, 515}, {0, 0}, {520, 515}}));
}

TEST(Tile, ItsClipSpaceHasItsCornersWhereTheyLieInThePicture) {
    Tile const tile{{1000, 500}, {200, 100}, {400, 300}};
    glm::dvec4 const corner{-0.6, -0.6, 0.5, 1.0}, opposite{0.2, 0.6, 0.5, 1.0};  // of the tile, in the picture's clip space
    glm::dvec4 const low = tileFromPicture(tile) * corner, high = tileFromPicture(tile) * opposite;
    EXPECT_NEAR(low.x, -1.0, 1e-12);
    EXPECT_NEAR(low.y, -1.0, 1e-12);
    EXPECT_EQ(low.z, 0.5);
    EXPECT_NEAR(high.x, 1.0, 1e-12);
    EXPECT_NEAR(high.y, 1.0, 1e-12);
}
}  // namespace
