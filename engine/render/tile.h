// A large picture in parts: pure.
#pragma once
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::render {
/// A part of a picture, pixels. GL's rows: the corner is the lower left one, from the picture's lower left.
struct Tile {
    glm::ivec2 picture{0};
    glm::ivec2 corner{0};
    glm::ivec2 size{0};
    bool operator==(Tile const&) const = default;
};
inline Tile wholeOf(glm::ivec2 const& picture) { return {picture, glm::ivec2{0}, picture}; }

/// The tile with so many pixels around it as the picture has there.
Tile withMargin(Tile const& tile, int margin);
/// Squares of `side` (even) and what is left at the right and the upper edge, in rows from the top, each from the left. Every corner lies an
/// even number of pixels from the picture's: derivatives are taken over the same pairs of pixels as in the whole.
std::vector<Tile> tilesOf(glm::ivec2 const& picture, int side);
/// Clip space of the tile from that of the picture.
glm::dmat4 tileFromPicture(Tile const& tile);
}  // namespace luftpost::render
