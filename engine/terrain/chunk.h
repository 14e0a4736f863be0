// One square of terrain at one level of detail: its place in the world-aligned quadtree, and its heights and normals.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "engine/terrain/land.h"

namespace luftpost::terrain {
inline constexpr int kChunkCells = 240;             // 241 x 241 vertices
inline constexpr double kFinestChunk = 480.0;       // m a side at level 0; each level is twice as wide
inline constexpr int kResidentLevel = 7;            // chunks of 61.44 km and more stay resident all round
inline constexpr int kTopLevel = 9;                 // 245.76 km: nothing coarser is needed below 12 km of altitude

inline double chunkSize(int level) { return kFinestChunk * static_cast<double>(1 << level); }

/// Column `x` counts east and row `y` north from the origin, in chunks of this level.
struct ChunkKey {
    std::int32_t level = 0, x = 0, y = 0;
    bool operator==(ChunkKey const&) const = default;
    ChunkKey parent() const { return {level + 1, x >> 1, y >> 1}; }
    /// Which quarter of its parent: bit 0 east, bit 1 north.
    int quarter() const { return (x & 1) | (y & 1) << 1; }
    /// South-west corner, m east and north of the origin.
    glm::dvec2 corner() const { return glm::dvec2{x, y} * chunkSize(level); }
    double size() const { return chunkSize(level); }
};
struct ChunkHash {
    std::size_t operator()(ChunkKey const& key) const;
};

/// Heights above sea level and normals at (cells + 1)^2 vertices, rows from south to north, vertices from west to east:
/// (height m, normal east, normal up, normal south). Under water it is the lake's bed.
struct Chunk {
    ChunkKey key;
    int cells = kChunkCells;
    float lowest = 0.0f, highest = 0.0f;  // m above sea level
    std::vector<glm::vec4> samples;

    std::size_t bytes() const { return samples.size() * sizeof(glm::vec4); }
};
inline std::size_t chunkBytes(int cells) { return static_cast<std::size_t>((cells + 1) * (cells + 1)) * sizeof(glm::vec4); }

/// Samples the land at every `step`-th of the 240 cells' vertices (1, 2, 3, 4, 5 or 6), with one further vertex all
/// round so that each normal comes from its four neighbours and chunks meet without a seam in height or light. Pure; any thread.
Chunk makeChunk(Land const& land, ChunkKey key, int step = 1);
}  // namespace luftpost::terrain
