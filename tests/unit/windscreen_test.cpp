// Rain on the cockpit's glass: shaders/lib/windscreen.glsl, as C++.
#include <gtest/gtest.h>

#include <cmath>

#include "shaders/lib/windscreen.glsl"

namespace luftpost::glsl {
namespace {
/// Mean cover of a piece of the glass ahead.
double meanCover(float wet, float seconds) {
    double sum = 0.0;
    int count = 0;
    for (float x = -0.3f; x < 0.3f; x += 0.0011f)
        for (float y = -0.15f; y < 0.15f; y += 0.0013f, ++count) sum += static_cast<double>(glassDrop({x, y}, wet, {0.0f, 0.0f}, seconds).cover);
    return sum / count;
}

TEST(Windscreen, LooksStraightAheadInTheMiddleOfTheGlass) {
    EXPECT_NEAR(length(glassPlace({1.0f, 0.0f, 0.0f})), 0.0f, 1e-6f);
    EXPECT_GT(glassPlace({1.0f, 0.0f, 0.2f}).x, 0.1f);
    EXPECT_GT(glassPlace({1.0f, 0.2f, 0.0f}).y, 0.1f);
    vec2 const zenith = glassPlace({0.0f, 1.0f, 0.0f});
    EXPECT_TRUE(std::isfinite(zenith.x) && std::isfinite(zenith.y));
}

TEST(Windscreen, HasMoreDropsTheWetterItIsAndNoneWhenDry) {
    EXPECT_EQ(meanCover(0.0f, 3.0f), 0.0);
    double const little = meanCover(0.2f, 3.0f), much = meanCover(1.0f, 3.0f);
    EXPECT_GT(little, 0.005);
    EXPECT_GT(much, 2.5 * little);
    EXPECT_LT(much, 0.4) << "one has to see through";
}

TEST(Windscreen, CoversNoMoreThanThePlaceAndKnowsTheDropsRim) {
    for (float x = -1.5f; x < 1.5f; x += 0.0037f)
        for (float y : {-0.2f, 0.01f, 0.13f}) {
            GlassDrop const drop = glassDrop({x, y}, 1.0f, {0.7f, 0.3f}, 100.0f);
            ASSERT_GE(drop.cover, 0.0f);
            ASSERT_LE(drop.cover, 1.0f);
            ASSERT_TRUE(drop.cover == 0.0f || length(drop.slope) <= 1.0f + 1e-4f) << x << " " << y;
        }
}

TEST(Windscreen, AirDrivesDropsUpAheadAndBackAtTheSides) {
    EXPECT_GT(glassFlow({0.0f, 0.1f}).y, 0.5f);
    EXPECT_GT(glassFlow({1.0f, 0.1f}).x, 0.5f);
    EXPECT_LT(glassFlow({-1.0f, 0.1f}).x, -0.5f);
    // The slowest column goes half of `slid`: find how far one column's runners have moved.
    float const x = 0.01f, slid = 0.02f;
    auto const pattern = [&](float y, float by) { return glassRunner({x, y}, {0.0f, 1.0f}, 1.0f, by); };
    double best = 1e9;
    float moved = 0.0f;
    for (float shift = -0.04f; shift < 0.04f; shift += 0.0005f) {
        double apart = 0.0;
        for (float y = -0.4f; y < 0.4f; y += 0.001f) apart += std::abs(pattern(y, 0.0f).cover - pattern(y + shift, slid).cover);
        if (apart < best) best = apart, moved = shift;
    }
    EXPECT_GE(moved, 0.45f * slid);
    EXPECT_LE(moved, 1.55f * slid);
}

TEST(Windscreen, ADropShowsTheWorldUpsideDown) {
    EXPECT_GT(glassLens({0.0f, -0.8f}, 0.0f).x, 0.95f);  // sky below
    EXPECT_LT(glassLens({0.0f, 0.8f}, 0.0f).x, 0.05f);   // land above
    EXPECT_LT(glassLens({0.99f, 0.0f}, 0.0f).y, 0.5f);   // a dark rim
    EXPECT_EQ(glassLens({0.0f, 0.0f}, 0.0f).y, 1.0f);
}
}  // namespace
}  // namespace luftpost::glsl
