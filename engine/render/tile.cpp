#include "engine/render/tile.h"

#include "engine/core/check.h"

namespace luftpost::render {
Tile withMargin(Tile const& tile, int margin) {
    glm::ivec2 const low = glm::max(tile.corner - margin, glm::ivec2{0});
    glm::ivec2 const high = glm::min(tile.corner + tile.size + margin, tile.picture);
    return {tile.picture, low, high - low};
}

std::vector<Tile> tilesOf(glm::ivec2 const& picture, int side) {
    CHECK(side > 0 && side % 2 == 0, "tiles of {} pixels", side);
    std::vector<Tile> tiles;
    for (int y = (picture.y - 1) / side * side; y >= 0; y -= side)
        for (int x = 0; x < picture.x; x += side) tiles.push_back({picture, {x, y}, glm::min(glm::ivec2{side}, picture - glm::ivec2{x, y})});
    return tiles;
}

glm::dmat4 tileFromPicture(Tile const& tile) {
    glm::dvec2 const size{tile.size}, picture{tile.picture};
    glm::dmat4 clip{1.0};
    clip[0][0] = picture.x / size.x;
    clip[1][1] = picture.y / size.y;
    clip[3][0] = (picture.x - 2.0 * tile.corner.x) / size.x - 1.0;
    clip[3][1] = (picture.y - 2.0 * tile.corner.y) / size.y - 1.0;
    return clip;
}
}  // namespace luftpost::render
