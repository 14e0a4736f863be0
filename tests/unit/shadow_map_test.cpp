// The shadow of land on land.
#include "engine/terrain/shadow_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::terrain {
namespace {
glm::dvec3 sunAt(double azimuth_deg, double elevation_deg) {
    double const a = core::radians(azimuth_deg), e = core::radians(elevation_deg);
    return {std::sin(a) * std::cos(e), std::sin(e), -std::cos(a) * std::cos(e)};
}

TEST(ShadowMap, AgreesWithRaysTracedOverTheLand) {
    Land const land{1, 316.0};
    glm::dvec2 const corner{-38000.0, -40000.0};  // mountains
    glm::dvec3 const sun = sunAt(240.0, 9.0);
    ShadowMap const map = makeShadowMap(land, corner, sun);
    int dark = 0, wrong = 0, all = 0;
    for (int i = 0; i < 500; ++i) {
        int const x = (i * 37) % kShadowSide, y = (i * 101) % kShadowSide;
        glm::dvec2 const at = corner + (glm::dvec2{x, y} + 0.5) * (kShadowWidth / kShadowSide);
        double const height = land.height(at.x, at.y) + 5.0;
        double rise = -1e9;
        for (double s = 40.0; s < 28000.0; s += 60.0) {
            double const up = land.height(at.x + s * std::sin(core::radians(240.0)), at.y + s * std::cos(core::radians(240.0)));
            rise = std::max(rise, up - s * std::tan(core::radians(9.0)) - s * s / (2.0 * core::kEarthRadius));
        }
        bool const shaded = rise > height, mapped = static_cast<double>(map.texels[static_cast<std::size_t>(y * kShadowSide + x)].x) > height;
        dark += shaded;
        wrong += shaded != mapped && std::abs(rise - height) > 25.0;
        ++all;
    }
    EXPECT_GT(dark, all / 20);
    EXPECT_LT(wrong, all / 50);
}

TEST(ShadowMap, IsEmptyUnderAHighSunAndLongUnderALowOne) {
    Land const land{1, 316.0};
    auto const darkShare = [&](double elevation) {
        ShadowMap const map = makeShadowMap(land, {-38000.0, -40000.0}, sunAt(130.0, elevation));
        int dark = 0;
        for (int y = 0; y < kShadowSide; y += 5)
            for (int x = 0; x < kShadowSide; x += 5) {
                glm::dvec2 const at = map.corner + (glm::dvec2{x, y} + 0.5) * (kShadowWidth / kShadowSide);
                dark += static_cast<double>(map.texels[static_cast<std::size_t>(y * kShadowSide + x)].x) > land.height(at.x, at.y) + 5.0;
            }
        return dark;
    };
    int const noon = darkShare(70.0), morning = darkShare(20.0), dawn = darkShare(4.0);
    EXPECT_EQ(noon, 0);
    EXPECT_GT(morning, noon);
    EXPECT_GT(dawn, 2 * morning);
}

TEST(ShadowMap, StaysInPlaceWhileTheCameraMovesALittle) {
    EXPECT_EQ(shadowCorner({100.0, 100.0}), shadowCorner({4900.0, 2000.0}));
    glm::dvec2 const corner = shadowCorner({7300.0, -9100.0});
    EXPECT_LT(std::abs(corner.x + 0.5 * kShadowWidth - 7300.0), kShadowWidth / 15.0);
}
}  // namespace
}  // namespace luftpost::terrain
