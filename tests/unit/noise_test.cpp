// The noise library, compiled as C++: what the volumes and the patterns of the clouds stand on.
#include <gtest/gtest.h>

#include "shaders/lib/noise.glsl"

namespace {
namespace g = luftpost::glsl;
using glm::ivec2, glm::vec2, glm::vec3;

TEST(Noise, WrapsNegativeCellsIntoThePeriod) {
    for (int cell = -20; cell < 20; ++cell) {
        int const wrapped = g::wrapCell(cell, 7);
        EXPECT_GE(wrapped, 0);
        EXPECT_LT(wrapped, 7);
        EXPECT_EQ((wrapped - cell) % 7, 0);
    }
}

TEST(Noise, WrapsLargeCellsExactly) {
    for (int period : {1, 3, 127, 131, 2834, 4096, 5519, 1048573})
        for (int turn = -1000; turn <= 1000; ++turn)
            for (int step : {-1, 0, 1}) {
                int const cell = turn * period + step;
                if (std::abs(cell) >= 1 << 24 ||
                    std::abs(static_cast<std::int64_t>(turn) * period) >= 1 << 24)
                    continue;
                EXPECT_EQ(g::wrapCell(cell, period), (step + period) % period) << cell << " in " << period;
            }
}

TEST(Noise, HashesAreSpreadEvenly) {
    std::array<int, 16> bins{};
    for (int x = -200; x < 200; ++x)
        for (int y = 0; y < 100; ++y) ++bins[static_cast<size_t>(g::unitFromHash(g::hashOf2(x, y, 5u)) * 16.0f)];
    for (int count : bins) EXPECT_NEAR(count, 2500, 250);  // five standard deviations
}

TEST(Noise, TurnsAreUnitVectors) {
    for (int i = 0; i < 800; ++i) {
        float const turns = static_cast<float>(i) * 0.0173f;
        vec2 const v = g::turned(turns);
        EXPECT_NEAR(v.x, std::cos(6.2831853f * turns), 4e-4f);
        EXPECT_NEAR(v.y, std::sin(6.2831853f * turns), 4e-4f);
    }
}

TEST(Noise, RepeatsAfterItsPeriodWithoutASeam) {
    for (int i = 0; i < 200; ++i) {
        vec3 const unit{static_cast<float>(i) / 200.0f - 0.3f, static_cast<float>(i) * 0.37f / 200.0f, 0.25f};
        vec3 const next = unit + vec3{1.0f, -1.0f, 2.0f};
        for (int channel = 0; channel < 4; ++channel)
            EXPECT_NEAR(g::shapeNoise(unit, 1u)[channel], g::shapeNoise(next, 1u)[channel], 2e-3f);
        EXPECT_NEAR(g::detailNoise(unit, 1u), g::detailNoise(next, 1u), 2e-3f);
        vec2 const plane{unit.x, unit.y};
        EXPECT_NEAR(g::curlNoise(plane, 1u).x, g::curlNoise(plane + vec2{-1.0f, 3.0f}, 1u).x, 2e-2f);
    }
}

TEST(Noise, IsContinuousAcrossCells) {
    float worst = 0.0f;
    for (int i = 0; i < 4000; ++i) {
        vec2 const p{static_cast<float>(i) * 0.005f - 10.0f, static_cast<float>(i) * 0.0031f - 6.0f};
        vec2 const q = p + vec2{1e-3f, 0.0f};
        worst = std::max(worst, std::abs(g::flowNoise(p, ivec2{64}, 0.3f, 3u) - g::flowNoise(q, ivec2{64}, 0.3f, 3u)));
        worst = std::max(worst, std::abs(g::flowWorley(p, ivec2{64}, 0.3f, 3u) - g::flowWorley(q, ivec2{64}, 0.3f, 3u)));
    }
    EXPECT_LT(worst, 5e-3f);
}

// A slice through a 3D gradient noise is flat on the lattice and rough between; the flow noise must not be.
TEST(Noise, KeepsItsSpreadWhileItEvolves) {
    for (float turns : {0.0f, 0.25f, 0.5f, 1.0f, 7.3f}) {
        double sum = 0.0, squares = 0.0;
        int const n = 300;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                double const v = g::flowNoise(vec2{static_cast<float>(x) * 0.37f, static_cast<float>(y) * 0.37f},
                                              ivec2{4096}, turns, 9u);
                sum += v;
                squares += v * v;
            }
        EXPECT_NEAR(sum / (n * n), 0.0, 0.01);
        EXPECT_NEAR(std::sqrt(squares / (n * n)), 0.216, 0.006);
    }
}

TEST(Noise, CurlHasNoDivergence) {
    float const e = 1.0f / 512.0f;
    double flux = 0.0, size = 0.0;
    for (int i = 0; i < 400; ++i) {
        vec2 const p{static_cast<float>(i) * 0.0371f, static_cast<float>(i) * 0.0193f};
        float const dx = g::curlNoise(p + vec2{e, 0.0f}, 2u).x - g::curlNoise(p - vec2{e, 0.0f}, 2u).x;
        float const dy = g::curlNoise(p + vec2{0.0f, e}, 2u).y - g::curlNoise(p - vec2{0.0f, e}, 2u).y;
        flux += std::abs(dx + dy);
        size += std::abs(dx) + std::abs(dy);
    }
    EXPECT_LT(flux, 0.01 * size);
}

TEST(Noise, VolumesUseTheirRange) {
    glm::vec4 low{2.0f}, high{-1.0f}, sum{0.0f};
    float lowDetail = 2.0f, highDetail = -1.0f, sumDetail = 0.0f;
    int const n = 24;
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                glm::vec4 const v = g::shapeNoise((vec3{x, y, z} + 0.5f) / static_cast<float>(n), 1u);
                low = glm::min(low, v);
                high = glm::max(high, v);
                sum += v / static_cast<float>(n * n * n);
                float const wisps = g::detailNoise((vec3{x, y, z} + 0.5f) / static_cast<float>(n), 1u);
                lowDetail = std::min(lowDetail, wisps);
                highDetail = std::max(highDetail, wisps);
                sumDetail += wisps / static_cast<float>(n * n * n);
            }
    EXPECT_EQ(lowDetail, 0.0f);
    EXPECT_EQ(highDetail, 1.0f);
    EXPECT_NEAR(sumDetail, 0.57f, 0.03f);  // what is left of a face where they are not asked for has a half in their place
    for (int channel = 0; channel < 4; ++channel) {
        EXPECT_LT(low[channel], 0.1f) << channel;
        EXPECT_GT(high[channel], 0.85f) << channel;
        EXPECT_NEAR(sum[channel], 0.45f, 0.17f) << channel;
    }
}
}  // namespace
