#include "engine/terrain/chunk.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"

namespace luftpost::terrain {
std::size_t ChunkHash::operator()(ChunkKey const& key) const {
    auto const mix = [](std::uint64_t h) { return (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ull; };
    std::uint64_t const place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.x)) << 32 | static_cast<std::uint32_t>(key.y);
    return static_cast<std::size_t>(mix(mix(place) + static_cast<std::uint64_t>(key.level)) >> 7);
}

namespace {
/// Heights at (cells + 3)^2 points: the chunk's vertices and one more all round.
std::vector<double> paddedHeights(Land const& land, ChunkKey key, int cells) {
    auto const side = static_cast<std::size_t>(cells + 3);
    double const spacing = key.size() / cells;
    glm::dvec2 const corner = key.corner();
    std::vector<double> east(side), north(side), heights(side * side);
    for (std::size_t i = 0; i < side; ++i) east[i] = corner.x + (static_cast<double>(i) - 1.0) * spacing;
    for (std::size_t row = 0; row < side; ++row) {
        std::fill(north.begin(), north.end(), corner.y + (static_cast<double>(row) - 1.0) * spacing);
        land.heights(east, north, {heights.data() + row * side, side});
    }
    return heights;
}
}  // namespace

Chunk makeChunk(Land const& land, ChunkKey key, int step) {
    CHECK(step >= 1 && kChunkCells % step == 0, "a step of {} cells", step);
    Chunk chunk;
    chunk.key = key;
    chunk.cells = kChunkCells / step;
    std::vector<double> const heights = paddedHeights(land, key, chunk.cells);
    auto const side = static_cast<std::size_t>(chunk.cells + 3), vertices = static_cast<std::size_t>(chunk.cells + 1);
    auto const perTwoSpacings = static_cast<float>(chunk.cells / (2.0 * key.size()));
    chunk.samples.resize(vertices * vertices);
    chunk.lowest = 1e9f, chunk.highest = -1e9f;
    for (std::size_t row = 0; row < vertices; ++row)
        for (std::size_t column = 0; column < vertices; ++column) {
            double const* at = heights.data() + (row + 1) * side + column + 1;
            float const slopeEast = static_cast<float>(at[1] - at[-1]) * perTwoSpacings;
            float const slopeNorth = static_cast<float>(at[side] - *(at - side)) * perTwoSpacings;
            float const up = 1.0f / std::sqrt(1.0f + slopeEast * slopeEast + slopeNorth * slopeNorth);
            auto const height = static_cast<float>(*at);
            chunk.samples[row * vertices + column] = glm::vec4{height, -slopeEast * up, up, slopeNorth * up};
            chunk.lowest = std::min(chunk.lowest, height);
            chunk.highest = std::max(chunk.highest, height);
        }
    return chunk;
}
}  // namespace luftpost::terrain
