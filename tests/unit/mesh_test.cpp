// Parametric meshes: normals against finite differences, winding, closedness.
#include "engine/assets/mesh.h"

#include <gtest/gtest.h>

#include <array>

#include "engine/core/frames.h"

namespace {
using namespace luftpost;

struct Case {
    char const* name;
    assets::Surface surface;
};
std::array<Case, 3> cases() {
    return {{{"sphere", assets::sphere(2.5f)}, {"torus", assets::torus(30.0f, 0.5f)}, {"grid", assets::grid(4.0f, 6.0f)}}};
}

glm::vec3 numericNormal(assets::Surface const& surface, float u, float v) {
    float const h = 2e-3f;
    glm::vec3 const alongU = surface(u + h, v).position - surface(u - h, v).position;
    glm::vec3 const alongV = surface(u, v + h).position - surface(u, v - h).position;
    return glm::normalize(glm::cross(alongU, alongV));
}

TEST(ParametricMesh, NormalsAreThoseOfFiniteDifferences) {
    for (Case const& c : cases())
        for (assets::Vertex const& vertex : assets::meshOf(c.surface, 12, 10).vertices) {
            float const u = vertex.uv.x, v = 1.0f - vertex.uv.y;
            EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-5f) << c.name;
            if (v < 0.01f || v > 0.99f) continue;  // a sphere's poles have no numeric derivative along u
            EXPECT_GT(glm::dot(vertex.normal, numericNormal(c.surface, u, v)), 0.9999f) << c.name << " " << u << " " << v;
            EXPECT_NEAR(glm::dot(vertex.normal, glm::vec3{vertex.tangent}), 0.0f, 1e-4f) << c.name;
        }
}

TEST(ParametricMesh, PointOutward) {
    for (assets::Vertex const& vertex : assets::meshOf(assets::sphere(2.0f), 16, 8).vertices)
        EXPECT_GT(glm::dot(vertex.normal, vertex.position), 1.99f);
    for (assets::Vertex const& vertex : assets::meshOf(assets::torus(10.0f, 1.0f), 16, 8).vertices) {
        glm::vec3 const ring = 10.0f * glm::normalize(glm::vec3{vertex.position.x, 0.0f, vertex.position.z});
        EXPECT_GT(glm::dot(vertex.normal, vertex.position - ring), 0.99f);
    }
}

TEST(ParametricMesh, TrianglesTurnCounterClockwiseAboutTheirNormals) {
    for (Case const& c : cases()) {
        assets::Mesh const mesh = assets::meshOf(c.surface, 12, 10);
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            assets::Vertex const& a = mesh.vertices[mesh.indices[i]];
            assets::Vertex const& b = mesh.vertices[mesh.indices[i + 1]];
            assets::Vertex const& d = mesh.vertices[mesh.indices[i + 2]];
            glm::vec3 const face = glm::cross(b.position - a.position, d.position - a.position);
            if (glm::length(face) < 1e-5f) continue;  // a triangle of a pole is a line
            EXPECT_GT(glm::dot(face, a.normal + b.normal + d.normal), 0.0f) << c.name;
        }
    }
}

TEST(ParametricMesh, EnclosesTheVolumeOfItsSphere) {
    assets::Mesh const mesh = assets::meshOf(assets::sphere(1.0f), 96, 48);
    double volume = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        auto const p = [&](std::size_t k) { return glm::dvec3{mesh.vertices[mesh.indices[i + k]].position}; };
        volume += glm::dot(p(0), glm::cross(p(1), p(2))) / 6.0;
    }
    EXPECT_NEAR(volume, 4.0 / 3.0 * core::kPi, 0.02);
}
}  // namespace
