// The shadow that land throws on land where the sun is low: for each place the altitude below which it lies in the dark.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "engine/terrain/land.h"

namespace luftpost::terrain {
inline constexpr int kShadowSide = 256;            // texels a side
inline constexpr double kShadowWidth = 40'000.0;   // m

/// Rows from south to north. x: the altitude that the light's middle just clears, m above sea level (far below the land
/// where nothing stands in the way); y: the height of the half shadow there, m.
struct ShadowMap {
    glm::dvec2 corner{0.0};   // south-west, m east and north of the origin
    glm::dvec3 towardLight{0.0, 1.0, 0.0};
    std::vector<glm::vec2> texels;
};

/// The camera's place in whole steps of an eighth of the map, so that maps made nearby are the same.
glm::dvec2 shadowCorner(glm::dvec2 camera);

/// Marches from every texel toward the light over the land's heights and its curvature. Pure; a tenth of a second.
ShadowMap makeShadowMap(Land const& land, glm::dvec2 corner, glm::dvec3 const& towardLight);
}  // namespace luftpost::terrain
