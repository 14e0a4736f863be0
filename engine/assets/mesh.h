// Meshes as plain data, and parametric ones f(u, v) with analytic normals.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::assets {
struct Vertex {
    glm::vec3 position{0.0f};  // m
    glm::vec3 normal{0.0f, 1.0f, 0.0f};
    glm::vec2 uv{0.0f};        // (0, 0) is the upper left of the texture, as glTF has it
    glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};  // xyz along growing u; w: sign of the bitangent
};

/// Triangles, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// A point of a surface and its derivatives there.
struct SurfacePoint {
    glm::vec3 position{0.0f};
    glm::vec3 alongU{0.0f};  // d position / du
    glm::vec3 alongV{0.0f};  // d position / dv
};
/// u and v run over 0..1.
using Surface = std::function<SurfacePoint(float u, float v)>;

/// (columns + 1) x (rows + 1) vertices over the surface; normals are alongU x alongV. Where that vanishes (poles), the
/// normal of a point a hair inside the surface is taken.
Mesh meshOf(Surface const& surface, int columns, int rows);

/// Around the origin; u goes round the y axis, v from the south pole to the north.
Surface sphere(float radius);
/// Around the y axis: `radius` of the ring, `tube` of its thickness.
Surface torus(float radius, float tube);
/// In the plane y = 0, normal up, `width` along x and `depth` along z, centred on the origin.
Surface grid(float width, float depth);
}  // namespace luftpost::assets
