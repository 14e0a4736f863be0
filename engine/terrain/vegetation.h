// Where trees stand: a pure function of the land, in tiles. The same cover decides it that colours the ground.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "engine/terrain/land.h"

namespace luftpost::terrain {
inline constexpr int kTreeTile = 256;    // m a side
inline constexpr int kTreeSpacing = 8;   // m between places where a tree may stand

/// A tile's place: column east and row north from the origin.
struct TreeTileKey {
    std::int32_t x = 0, y = 0;
    bool operator==(TreeTileKey const&) const = default;
};
struct TreeTileHash {
    std::size_t operator()(TreeTileKey const& key) const {
        return static_cast<std::size_t>(static_cast<std::uint32_t>(key.x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(key.y) * 0x85ebca77u);
    }
};

/// Metres east and north of the tile's south-west corner, of the foot above sea level; laid out for the GPU.
struct Tree {
    float east, north, altitude;
    float height;     // m
    float conifer;    // 0 broad-leaved, 1 conifer
    float shade;      // 0..1: its own tint
};

/// The trees of a tile, in a fixed order. Any thread; about a third of a millisecond.
std::vector<Tree> treesOf(Land const& land, TreeTileKey key);
}  // namespace luftpost::terrain
