// The bend of the Earth for the picture: closed forms and the inverse.
#include <gtest/gtest.h>

#include <cmath>

#include "shaders/lib/curvature.glsl"

namespace luftpost::glsl {
namespace {
double const kR = 6371000.0;

glm::dvec3 exact(glm::dvec3 flat, double camera) {
    double const distance = std::hypot(flat.x, flat.z), arc = distance / kR, r = kR + camera + flat.y;
    double const across = r * std::sin(arc);
    return {distance > 0 ? across * flat.x / distance : 0.0, r * std::cos(arc) - kR - camera, distance > 0 ? across * flat.z / distance : 0.0};
}

TEST(Curvature, BendsAsTheSphereDoes) {
    for (float distance : {0.0f, 1.0f, 300.0f, 20000.0f, 120000.0f, 390000.0f, 600000.0f, 2.0e6f})
        for (float drop : {-12000.0f, -1500.0f, 0.0f, 2500.0f})
            for (float bearing : {0.0f, 1.1f, 3.9f}) {
                vec3 const flat{distance * std::sin(bearing), drop, distance * std::cos(bearing)};
                vec3 const bent = curvedFromFlat(flat, 12000.0f);
                glm::dvec3 const wanted = exact(glm::dvec3{flat}, 12000.0);
                double const tolerance = 0.002 + 4e-7 * static_cast<double>(distance);  // a few float steps of the distance
                EXPECT_NEAR(bent.x, wanted.x, tolerance);
                EXPECT_NEAR(bent.y, wanted.y, tolerance);
                EXPECT_NEAR(bent.z, wanted.z, tolerance);
            }
}

TEST(Curvature, LeavesTheNearAlone) {
    vec3 const bent = curvedFromFlat(vec3{400.0f, -120.0f, -300.0f}, 900.0f);
    EXPECT_NEAR(bent.x, 400.0f, 0.05f);
    EXPECT_NEAR(bent.y, -120.0f - 500.0f * 500.0f / (2.0f * 6371000.0f), 0.001f);
}

TEST(Curvature, HasItsInverse) {
    for (float distance : {0.0f, 50.0f, 9000.0f, 390000.0f, 900000.0f, 2.5e6f})
        for (float drop : {-9000.0f, 0.0f, 15000.0f}) {
            vec3 const flat{distance * 0.8f, drop, distance * -0.6f};
            vec3 const back = flatFromCurved(curvedFromFlat(flat, 9100.0f), 9100.0f);
            float const tolerance = 0.01f + 6e-7f * distance;
            EXPECT_NEAR(back.x, flat.x, tolerance);
            EXPECT_NEAR(back.y, flat.y, tolerance);
            EXPECT_NEAR(back.z, flat.z, tolerance);
        }
}

TEST(Curvature, PutsTheHorizonWhereGeometrySaysItIs) {
    // From 10 km up the sea's horizon dips by acos(R / (R + h)) and lies 357 km of arc away.
    float steepest = -1e9f, at = 0.0f;
    for (float distance = 100000.0f; distance < 600000.0f; distance += 500.0f) {
        vec3 const p = curvedFromFlat(vec3{distance, -10000.0f, 0.0f}, 10000.0f);
        if (p.y / p.x > steepest) steepest = p.y / p.x, at = distance;
    }
    EXPECT_NEAR(std::atan(steepest), -std::acos(kR / (kR + 10000.0)), 1e-6);
    EXPECT_NEAR(at, kR * std::acos(kR / (kR + 10000.0)), 3000.0);
}
}  // namespace
}  // namespace luftpost::glsl
