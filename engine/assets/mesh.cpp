#include "engine/assets/mesh.h"

#include <cmath>

#include "engine/core/check.h"
#include "engine/core/frames.h"

namespace luftpost::assets {
namespace {
constexpr float kTurn = static_cast<float>(2.0 * core::kPi);
constexpr float kHalfTurn = static_cast<float>(core::kPi);

/// Unit normal and tangent; at a pole (a vanishing derivative along u) those of a point a hair nearer the middle.
Vertex vertexOf(Surface const& surface, float u, float v) {
    SurfacePoint const here = surface(u, v);
    SurfacePoint slope = here;
    if (glm::length(here.alongU) < 1e-5f * glm::length(here.alongV))
        slope = surface(u, v + (v < 0.5f ? 1e-3f : -1e-3f));
    Vertex vertex;
    vertex.position = here.position;
    vertex.normal = glm::normalize(glm::cross(slope.alongU, slope.alongV));
    vertex.tangent = glm::vec4{glm::normalize(slope.alongU), 1.0f};
    vertex.uv = glm::vec2{u, 1.0f - v};
    return vertex;
}
}  // namespace

Mesh meshOf(Surface const& surface, int columns, int rows) {
    CHECK(columns > 0 && rows > 0, "a mesh of {} x {} cells", columns, rows);
    Mesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            mesh.vertices.push_back(vertexOf(surface, static_cast<float>(column) / static_cast<float>(columns),
                                             static_cast<float>(row) / static_cast<float>(rows)));
    auto const index = [&](int column, int row) { return static_cast<std::uint32_t>(row * (columns + 1) + column); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            std::uint32_t const a = index(column, row), b = index(column + 1, row);
            std::uint32_t const c = index(column + 1, row + 1), d = index(column, row + 1);
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    return mesh;
}

Surface sphere(float radius) {
    return [radius](float u, float v) {
        float const azimuth = kTurn * u, polar = kHalfTurn * v;  // polar from the south pole
        float const sa = std::sin(azimuth), ca = std::cos(azimuth), sp = std::sin(polar), cp = std::cos(polar);
        return SurfacePoint{radius * glm::vec3{sp * sa, -cp, sp * ca}, radius * kTurn * glm::vec3{sp * ca, 0.0f, -sp * sa},
                            radius * kHalfTurn * glm::vec3{cp * sa, sp, cp * ca}};
    };
}

Surface torus(float radius, float tube) {
    return [radius, tube](float u, float v) {
        float const around = kTurn * u, along = kTurn * v;
        float const sa = std::sin(around), ca = std::cos(around), st = std::sin(along), ct = std::cos(along);
        float const distance = radius + tube * ct;
        return SurfacePoint{{distance * sa, tube * st, distance * ca},
                            kTurn * distance * glm::vec3{ca, 0.0f, -sa},
                            kTurn * tube * glm::vec3{-st * sa, ct, -st * ca}};
    };
}

Surface grid(float width, float depth) {
    return [width, depth](float u, float v) {
        return SurfacePoint{{(u - 0.5f) * width, 0.0f, (0.5f - v) * depth}, {width, 0.0f, 0.0f}, {0.0f, 0.0f, -depth}};
    };
}
}  // namespace luftpost::assets
