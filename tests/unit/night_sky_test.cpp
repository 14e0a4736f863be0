// Stars and discs: as many and as bright as there are.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/frames.h"
#include "engine/sky/light.h"
#include "engine/sky/stars.h"
#include "shaders/lib/night_sky.glsl"

namespace {
using namespace luftpost;

TEST(Stars, BrightestIsSiriusAndItsColourIsWhite) {
    auto const stars = sky::brightStars();
    EXPECT_GT(stars.size(), 100u);
    for (sky::Star const& star : stars) EXPECT_GE(star.magnitude, stars.front().magnitude);
    glm::vec3 const white = sky::starIrradiance(0.0f, 0.0f);
    EXPECT_NEAR(static_cast<double>(sky::luminance(white)) * sky::kSunIlluminance_lx, 2.54e-6, 1e-7);
    glm::vec3 const betelgeuse = sky::starIrradiance(0.5f, 1.85f);
    EXPECT_GT(betelgeuse.x, 2.0f * betelgeuse.z);
    EXPECT_GT(white.z, white.x);
}

TEST(Stars, BeltOfOrionIsStraightAndTheBearPointsToThePole) {
    auto const find = [](float ra, float dec) {
        for (sky::Star const& star : sky::brightStars())
            if (std::abs(star.ra_h - ra) < 0.01f && std::abs(star.dec_deg - dec) < 0.1f) return sky::starDirection(star);
        ADD_FAILURE() << ra << " " << dec;
        return glm::vec3{0.0f};
    };
    glm::vec3 const mintaka = find(5.533f, -0.299f), alnilam = find(5.604f, -1.202f), alnitak = find(5.679f, -1.943f);
    EXPECT_GT(glm::dot(glm::normalize(alnilam - mintaka), glm::normalize(alnitak - alnilam)), 0.98f);
    glm::vec3 const merak = find(11.031f, 56.382f), dubhe = find(11.062f, 61.751f), polaris = find(2.530f, 89.264f);
    EXPECT_LT(std::abs(glm::dot(glm::normalize(glm::cross(merak, dubhe)), polaris)), 0.06f);
}

TEST(Stars, GridFindsEveryStarWhereItStands) {
    sky::StarGrid const grid = sky::starGrid();
    for (sky::Star const& star : sky::brightStars()) {
        int const column = static_cast<int>(star.ra_h / 24.0f * sky::kStarColumns);
        int const row = static_cast<int>((star.dec_deg + 90.0f) / 180.0f * sky::kStarRows);
        glm::ivec2 const cell = grid.cells[static_cast<std::size_t>(row * sky::kStarColumns + column)];
        bool found = false;
        for (int i = 0; i < cell.y; ++i)
            found = found || glm::distance(glm::vec3{grid.stars[static_cast<std::size_t>(2 * (cell.x + i))]},
                                           sky::starDirection(star)) < 1e-6f;
        EXPECT_TRUE(found) << star.ra_h << " " << star.dec_deg;
    }
}

TEST(Stars, FaintOnesGrowInNumberAsTheyAreCounted) {
    int brighterThanFive = 0;
    constexpr int kDrawn = 9000;
    for (int i = 0; i < kDrawn; ++i) {
        float const magnitude = glsl::drawnMagnitude((static_cast<float>(i) + 0.5f) / kDrawn, 2.6f, 6.5f);
        EXPECT_GE(magnitude, 2.59f);
        EXPECT_LE(magnitude, 6.51f);
        brighterThanFive += magnitude < 5.0f;
    }
    EXPECT_NEAR(brighterThanFive, 1500, 200);  // 1600 stars are brighter than magnitude 5 (Allen)
}

TEST(Stars, SpotKeepsTheLightOfItsStar) {
    for (float pixel : {0.0001f, 0.001f, 0.004f}) {
        double sum = 0.0;
        float const step = 0.02f * pixel + 1e-5f;
        for (float angle = 0.5f * step; angle < 0.02f; angle += step)
            sum += static_cast<double>(glsl::starSpot(angle, pixel) * 6.2831853f * angle * step);
        EXPECT_NEAR(sum, 1.0, 0.01);
    }
}

TEST(Discs, SunsLimbDarkensAndKeepsItsLight) {
    double sum = 0.0;
    constexpr int kRings = 1000;
    for (int i = 0; i < kRings; ++i) sum += static_cast<double>(glsl::limbDarkening(std::sqrt((static_cast<float>(i) + 0.5f) / kRings)).y);
    EXPECT_NEAR(sum / kRings, 1.0, 0.01);
    EXPECT_LT(glsl::limbDarkening(0.95f).z, 0.7f * glsl::limbDarkening(0.0f).z);
}

TEST(Discs, MoonGivesAQuarterLuxWhenFullAndIsHalfDarkAtTheQuarter) {
    constexpr double kRadius = 0.00452;
    auto const lux = [](glm::vec3 sun) {
        double sum = 0.0;
        constexpr int kGrid = 200;
        for (int y = 0; y < kGrid; ++y)
            for (int x = 0; x < kGrid; ++x) {
                glm::vec2 const p{(static_cast<float>(x) + 0.5f) * 2.0f / kGrid - 1.0f,
                                  (static_cast<float>(y) + 0.5f) * 2.0f / kGrid - 1.0f};
                if (glm::dot(p, p) < 1.0f) sum += static_cast<double>(sky::luminance(glsl::moonRadiance(p, sun)));
            }
        return sum * 4.0 / (kGrid * kGrid) * kRadius * kRadius * sky::kSunIlluminance_lx;
    };
    EXPECT_NEAR(lux({0.0f, 0.0f, 1.0f}), 0.267, 0.06);
    EXPECT_EQ(glsl::moonRadiance({-0.5f, 0.0f}, {1.0f, 0.0f, 0.0f}).x, 0.0f);
    EXPECT_GT(glsl::moonRadiance({0.5f, 0.0f}, {1.0f, 0.0f, 0.0f}).x, 0.005f);
}
}  // namespace
