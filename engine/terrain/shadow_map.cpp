#include "engine/terrain/shadow_map.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::terrain {
namespace {
constexpr double kTexel = kShadowWidth / kShadowSide;
constexpr double kFarthest = 30'000.0;    // m that a shadow is followed
constexpr double kHalfDisc = 0.00465;     // radians: the sun's radius from the Earth

/// Heights over the map and as far beyond it as a shadow may come from toward the light.
struct HeightField {
    HeightField(Land const& land, glm::dvec2 corner, glm::dvec2 toward) {
        glm::dvec2 const reach = toward * kFarthest;
        glm::dvec2 const south = glm::min(corner, corner + reach), north = glm::max(corner, corner + reach) + kShadowWidth;
        origin = south;
        size = glm::ivec2{(north - south) / kTexel} + 2;
        heights.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        std::vector<double> e(static_cast<std::size_t>(size.x)), n(e.size()), z(e.size());
        for (int x = 0; x < size.x; ++x) e[static_cast<std::size_t>(x)] = origin.x + x * kTexel;
        for (int y = 0; y < size.y; ++y) {
            std::fill(n.begin(), n.end(), origin.y + y * kTexel);
            land.heights(e, n, z);
            std::transform(z.begin(), z.end(), heights.begin() + static_cast<std::ptrdiff_t>(y) * size.x, [](double h) { return static_cast<float>(h); });
        }
    }
    float at(glm::dvec2 place) const {
        glm::dvec2 const p = glm::clamp((place - origin) / kTexel, glm::dvec2{0.0}, glm::dvec2{size} - 1.001);
        glm::ivec2 const i{p};
        glm::vec2 const f{p - glm::dvec2{i}};
        float const* row = heights.data() + static_cast<std::size_t>(i.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(i.x);
        return glm::mix(glm::mix(row[0], row[1], f.x), glm::mix(row[size.x], row[size.x + 1], f.x), f.y);
    }
    glm::dvec2 origin;
    glm::ivec2 size;
    std::vector<float> heights;
};
}  // namespace

glm::dvec2 shadowCorner(glm::dvec2 camera) {
    double const step = kShadowWidth / 8.0;
    return glm::floor(camera / step) * step - 0.5 * kShadowWidth + 0.5 * step;
}

ShadowMap makeShadowMap(Land const& land, glm::dvec2 corner, glm::dvec3 const& towardLight) {
    ShadowMap map{corner, towardLight, {}};
    map.texels.assign(static_cast<std::size_t>(kShadowSide) * kShadowSide, glm::vec2{-1.0e5f, 1.0f});
    glm::dvec2 const across{towardLight.x, -towardLight.z};
    double const length = glm::length(across);
    if (length < 0.02 || towardLight.y < -0.03 || towardLight.y > 0.9) return map;  // high noon throws no long shadow; night none
    glm::dvec2 const toward = across / length;
    double const climb = towardLight.y / length;
    HeightField const field{land, corner, toward};
    for (int y = 0; y < kShadowSide; ++y)
        for (int x = 0; x < kShadowSide; ++x) {
            glm::dvec2 const place = corner + (glm::dvec2{x, y} + 0.5) * kTexel;
            glm::vec2& texel = map.texels[static_cast<std::size_t>(y) * kShadowSide + static_cast<std::size_t>(x)];
            double step = 1.6 * kTexel;
            for (double s = step; s < kFarthest; s += step, step *= 1.06) {
                // The ray that just clears the land there, traced back; the Earth falls away below it.
                double const clears = static_cast<double>(field.at(place + toward * s)) - s * climb - s * s / (2.0 * core::kEarthRadius);
                if (clears > static_cast<double>(texel.x)) texel = {static_cast<float>(clears), static_cast<float>(std::max(s * 2.0 * kHalfDisc, 6.0))};
            }
        }
    return map;
}
}  // namespace luftpost::terrain
