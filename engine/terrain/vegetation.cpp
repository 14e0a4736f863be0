#include "engine/terrain/vegetation.h"

#include <algorithm>
#include <cmath>

#include "shaders/lib/terrain_colour.glsl"

namespace luftpost::terrain {
namespace {
constexpr int kSide = kTreeTile / kTreeSpacing;

/// Heights at the corners of the tile's places and one more row and column on each side.
std::vector<double> cornerHeights(Land const& land, glm::dvec2 corner) {
    constexpr std::size_t kCorners = kSide + 3;
    std::vector<double> east(kCorners), north(kCorners), heights(kCorners * kCorners);
    for (std::size_t i = 0; i < kCorners; ++i) east[i] = corner.x + (static_cast<double>(i) - 1.0) * kTreeSpacing;
    for (std::size_t row = 0; row < kCorners; ++row) {
        std::fill(north.begin(), north.end(), corner.y + (static_cast<double>(row) - 1.0) * kTreeSpacing);
        land.heights(east, north, {heights.data() + row * kCorners, kCorners});
    }
    return heights;
}

/// Metres outside the home airfield's grounds, as runway.glsl has it.
float airfieldDistance(Land const& land, glm::dvec2 at) {
    glm::dvec2 const place = glm::abs(land.runway().alongAcross(at.x, at.y));
    return static_cast<float>(glm::length(glm::max(place - glm::dvec2{620.0, 90.0}, glm::dvec2{0.0})));
}
}  // namespace

std::vector<Tree> treesOf(Land const& land, TreeTileKey key) {
    glm::ivec2 const origin{key.x * kTreeTile, key.y * kTreeTile};
    std::vector<double> const heights = cornerHeights(land, glm::dvec2{origin});
    std::vector<Tree> trees;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            glsl::uint const h = glsl::landCellHash(origin.x / kTreeSpacing + column, origin.y / kTreeSpacing + row, 71u);
            float const fx = glsl::lowShare(h), fy = glsl::highShare(h);
            auto const index = static_cast<std::size_t>((row + 1) * (kSide + 3) + column + 1);
            double const a = heights[index], b = heights[index + 1], c = heights[index + kSide + 3], d = heights[index + kSide + 4];
            double const altitude = glm::mix(glm::mix(a, b, static_cast<double>(fx)), glm::mix(c, d, static_cast<double>(fx)), static_cast<double>(fy));
            auto const slopeEast = static_cast<float>((b - a + d - c) / (2.0 * kTreeSpacing)), slopeNorth = static_cast<float>((c - a + d - b) / (2.0 * kTreeSpacing));
            glm::vec2 const offset = (glm::vec2{column, row} + glm::vec2{fx, fy}) * static_cast<float>(kTreeSpacing);
            glsl::LandPoint point;
            point.origin = origin;
            point.offset = offset;
            point.altitude = static_cast<float>(altitude);
            point.aboveWater = static_cast<float>(altitude - land.waterLevel());
            point.flatness = 1.0f / std::sqrt(1.0f + slopeEast * slopeEast + slopeNorth * slopeNorth);
            point.sunward = slopeNorth * point.flatness;
            point.clearing = airfieldDistance(land, glm::dvec2{origin} + glm::dvec2{offset});
            point.snowLine = static_cast<float>(kSnowLine);
            glsl::LandCover const cover = glsl::landCover(point, 4.0f);
            glsl::uint const chance = glsl::landHash(h + 1u);
            // Woods stand close; in the open a tree here and there, and hardly one in a field.
            float const open = point.clearing < 300.0f ? 0.0f : 0.012f * (1.0f - 0.75f * cover.fields) * (1.0f - glsl::landRamp(1500.0f, glsl::kTreeLine, point.altitude));
            float share = cover.forest > 0.5f ? 0.55f + 0.4f * cover.forest : open;
            bool hedge = false;
            if (cover.fields > 0.5f && cover.forest < 0.5f) {  // hedges: bushes, and trees among them
                glsl::FieldPlace const field = glsl::fieldPlace(point, cover);
                if (field.road < 6.0f) continue;
                hedge = field.hedged && field.border < 4.5f;
                if (hedge) share = 0.8f;
            }
            if (glsl::lowShare(chance) > share * (1.0f - cover.rock) * (1.0f - cover.snow) || point.aboveWater < 1.0f) continue;
            float const conifers = glsl::landRamp(500.0f, 1200.0f, point.altitude + 300.0f * cover.middling);
            float const kind = !hedge && glsl::highShare(chance) < 0.15f + 0.8f * conifers ? 1.0f : 0.0f;
            float const vigour = 1.0f - 0.55f * glsl::landRamp(1200.0f, 1900.0f, point.altitude);
            float const size = glsl::lowShare(glsl::landHash(chance));
            float const height = (hedge ? 3.2f + 12.0f * size * size * size : 9.0f + 13.0f * size + 4.0f * kind) * vigour;
            trees.push_back({offset.x, offset.y, static_cast<float>(altitude), height, kind, glsl::highShare(glsl::landHash(chance))});
        }
    return trees;
}
}  // namespace luftpost::terrain
