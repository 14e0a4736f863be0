// The surface's reflection and the tone map as C++: energy, limits, monotony.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/frames.h"
#include "shaders/lib/camera.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/tone.glsl"

namespace {
using namespace luftpost;

/// Sums f(direction) cos over the hemisphere about +z.
template <class F>
double overHemisphere(F f, int rings = 400, int sectors = 64) {
    double sum = 0.0;
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < sectors; ++k) {
            double const c = std::sqrt((i + 0.5) / rings), s = std::sqrt(1.0 - c * c);  // equal parts of cos d omega
            double const a = 2.0 * core::kPi * (k + 0.5) / sectors;
            sum += f(glm::vec3{s * std::cos(a), s * std::sin(a), c});
        }
    return sum * core::kPi / (rings * sectors);
}

TEST(Surface, FacetDensityIntegratesToOneOverTheProjectedHemisphere) {
    for (float roughness : {0.3f, 0.6f, 1.0f})
        EXPECT_NEAR(overHemisphere([&](glm::vec3 const& h) { return glsl::facetDensity(h.z, roughness * roughness); }), 1.0,
                    0.01)
            << roughness;
}

TEST(Surface, NeverReflectsMoreThanItGets) {
    glm::vec3 const normal{0.0f, 0.0f, 1.0f};
    for (float metallic : {0.0f, 1.0f})
        for (float roughness : {0.3f, 0.6f, 1.0f})
            for (float cosine : {0.2f, 0.5f, 1.0f}) {
                auto const white = glsl::surfaceMaterial(glm::vec3{1.0f}, metallic, roughness);
                glm::vec3 const light{std::sqrt(1.0f - cosine * cosine), 0.0f, cosine};
                double const out = overHemisphere(
                    [&](glm::vec3 const& eye) { return glsl::reflectedLight(white, normal, eye, light).x; });
                EXPECT_LT(out, 1.02 * cosine) << metallic << " " << roughness << " " << cosine;
                EXPECT_GT(out, 0.25 * cosine) << metallic << " " << roughness << " " << cosine;
            }
}

TEST(Surface, ReflectsTheSameBothWays) {
    glm::vec3 const normal{0.0f, 0.0f, 1.0f}, a = glm::normalize(glm::vec3{0.3f, 0.2f, 0.9f}),
                    b = glm::normalize(glm::vec3{-0.6f, 0.1f, 0.4f});
    auto const copper = glsl::surfaceMaterial({0.9f, 0.6f, 0.5f}, 1.0f, 0.4f);
    glm::vec3 const there = glsl::reflectedLight(copper, normal, a, b) / b.z;
    glm::vec3 const back = glsl::reflectedLight(copper, normal, b, a) / a.z;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(there[i], back[i], 1e-5f);
}

TEST(Surface, EvenReflectanceIsNearTheIntegralOfTheFacets) {
    glm::vec3 const normal{0.0f, 0.0f, 1.0f};
    for (float roughness : {0.4f, 0.7f, 1.0f})
        for (float cosine : {0.3f, 0.6f, 1.0f}) {
            glm::vec3 const eye{std::sqrt(1.0f - cosine * cosine), 0.0f, cosine};
            for (float straight : {0.04f, 0.9f}) {
                glsl::SurfaceMaterial const mirror{glm::vec3{0.0f}, glm::vec3{straight}, roughness};
                double const integral = overHemisphere(
                    [&](glm::vec3 const& light) { return glsl::reflectedLight(mirror, normal, eye, light).x / light.z; });
                glm::vec2 const fit = glsl::evenReflectance(cosine, roughness);
                EXPECT_NEAR(straight * fit.x + fit.y, integral, 0.06) << roughness << " " << cosine << " " << straight;
            }
        }
}

TEST(ToneMap, KeepsTheMiddleGrowsAndNeverClipsALitCloud) {
    EXPECT_NEAR(glsl::toneChannel(0.18f), 0.18f, 1e-5f);
    float previous = -1.0f;
    for (float stop = -10.0f; stop < 8.0f; stop += 0.25f) {
        float const shown = glsl::toneChannel(0.18f * std::exp2(stop));
        EXPECT_GT(shown, previous);
        EXPECT_LT(shown, 1.0f);
        previous = shown;
    }
    EXPECT_GT(glsl::toneChannel(16.0f) - glsl::toneChannel(4.0f), 0.03f);
}

TEST(ToneMap, KeepsGreysGreyAndTheOrderOfChannels) {
    for (float x : {0.01f, 0.18f, 1.0f, 10.0f}) {
        glm::vec3 const grey = glsl::toneMapped(glm::vec3{x});
        EXPECT_NEAR(grey.x, grey.z, 1e-6f);
        glm::vec3 const orange = glsl::toneMapped(glm::vec3{1.0f, 0.5f, 0.1f} * x);
        EXPECT_GT(orange.x, orange.y);
        EXPECT_GT(orange.y, orange.z);
    }
}

TEST(ToneMap, ShowsMoonlightBluishDimAndDaylightAsItIs) {
    glm::vec3 const warm{1.08f, 1.0f, 0.86f};  // the moon's light on white
    glm::vec3 const day = glsl::seenInTheDark(warm, 5000.0f), night = glsl::seenInTheDark(warm, 0.01f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(day[i], warm[i], 1e-6f);
    EXPECT_GT(night.z, 1.2f * night.x);
    EXPECT_NEAR((night.x + night.y + night.z) / 3.0f, 1.0f, 0.1f);  // colour goes, light stays
}

TEST(ToneMap, EncodesAsSrgb) {
    EXPECT_NEAR(glsl::encodedChannel(0.0f), 0.0f, 1e-6f);
    EXPECT_NEAR(glsl::encodedChannel(1.0f), 1.0f, 1e-5f);
    EXPECT_NEAR(glsl::encodedChannel(0.2140f), 0.5f, 2e-4f);
}

TEST(ToneMap, DitherHasNoMeanAndStaysWithinAStep) {
    double sum = 0.0;
    for (unsigned y = 0; y < 128; ++y)
        for (unsigned x = 0; x < 128; ++x) {
            float const noise = glsl::ditherNoise({x, y}, 3u) * 255.0f;
            EXPECT_LE(std::abs(noise), 1.0f);
            sum += noise;
        }
    EXPECT_NEAR(sum / (128 * 128), 0.0, 0.02);
}

TEST(CameraRays, PanoramaHasItsInverse) {
    for (float x = 0.05f; x < 1.0f; x += 0.1f)
        for (float y = 0.05f; y < 1.0f; y += 0.1f) {
            glm::vec2 const back = glsl::panoramaUnit(glsl::panoramaRay({x, y}));
            EXPECT_NEAR(back.x, x, 1e-5f);
            EXPECT_NEAR(back.y, y, 1e-5f);
        }
    EXPECT_NEAR(glsl::panoramaRay({0.25f, 0.5f}).x, 1.0f, 1e-6f) << "a quarter from the left is east";
}

TEST(CameraRays, DomeIsEqualAreaWithNorthUpAndEastLeft) {
    EXPECT_NEAR(glsl::domeRay({0.5f, 0.5f}).y, 1.0f, 1e-6f);
    EXPECT_NEAR(glsl::domeRay({0.5f, 1.0f}).z, -1.0f, 1e-6f);
    EXPECT_NEAR(glsl::domeRay({0.0f, 0.5f}).x, 1.0f, 1e-6f);
    for (float x = 0.1f; x < 1.0f; x += 0.2f) {  // solid angle per area of the picture: d omega = 2 pi (1 - cos)
        glm::vec3 const a = glsl::domeRay({x, 0.45f}), du = glsl::domeRay({x + 1e-3f, 0.45f}) - a,
                        dv = glsl::domeRay({x, 0.451f}) - a;
        EXPECT_NEAR(glm::length(glm::cross(du, dv)), 8e-6f, 4e-7f) << x;
        EXPECT_NEAR(glm::length(a), 1.0f, 1e-5f);
    }
}
}  // namespace
