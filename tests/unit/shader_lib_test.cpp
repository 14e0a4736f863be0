// What of shaders/lib no other test asks: the eye's exposure, streaks of rain, waves, the land's noise, cover and colour.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shaders/lib/exposure.glsl"
#include "shaders/lib/precipitation.glsl"
#include "shaders/lib/terrain_colour.glsl"
#include "shaders/lib/waves.glsl"

namespace luftpost::glsl {
namespace {
float luminanceOf(vec3 const& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

// ------------------------------------------------------------------------------------------------------ exposure

TEST(Exposure, ShowsDayAsMidGreyAndNightDarkerThanDay) {
    auto const shown = [](float candela) { return candela / kSunLux * exposureFor(candela / kSunLux); };
    EXPECT_GT(shown(4000.0f), 0.15f);
    EXPECT_LT(shown(4000.0f), 0.45f);
    float before = 0.0f;
    for (float candela = 1e-5f; candela < 3e4f; candela *= 2.0f) {
        EXPECT_GE(shown(candela), 0.999f * before) << candela;
        before = shown(candela);
    }
    EXPECT_LT(shown(0.001f), 0.35f * shown(4000.0f));
    EXPECT_TRUE(std::isfinite(exposureFor(0.0f)));
}

TEST(Exposure, BinsHoldTheirOwnMiddleAndClampTheEnds) {
    for (int bin = 0; bin < kExposureBins; ++bin) EXPECT_EQ(exposureBin(exposureOfBin(bin)), bin);
    EXPECT_EQ(exposureBin(0.0f), 0);
    EXPECT_EQ(exposureBin(1e30f), kExposureBins - 1);
}

TEST(Exposure, AdaptsToLightInThreeFifthsOfASecondAndToDarkInTwo) {
    float const e = 2.71828183f;
    EXPECT_FLOAT_EQ(adaptedExposure(8.0f, 2.0f, 0.0f), 8.0f);
    EXPECT_NEAR(std::log2(adaptedExposure(8.0f, 2.0f, 0.6f) / 2.0f), 2.0f / e, 1e-4f);
    EXPECT_NEAR(std::log2(adaptedExposure(2.0f, 8.0f, 2.0f) / 8.0f), -2.0f / e, 1e-4f);
    EXPECT_NEAR(adaptedExposure(2.0f, 8.0f, 60.0f), 8.0f, 1e-4f);
}

// ------------------------------------------------------------------------------------------------------- streaks

/// Mean cover of one sheet over directions around the one that is level and across the fall.
double meanStreaks(float share, float reach) {
    double sum = 0.0;
    int count = 0;
    for (float azimuth = -0.6f; azimuth < 0.6f; azimuth += 0.0017f)
        for (float up = -0.3f; up < 0.3f; up += 0.011f, ++count) {
            vec3 const direction = normalize(vec3{std::cos(azimuth), up, std::sin(azimuth)});
            float const cover = dropCover(direction, {0.0f, -1.0f, 0.0f}, 1.4f, 3.0f, 0.2f, 0.002f, share, 0.001f, reach);
            EXPECT_GE(cover, 0.0f);
            EXPECT_LE(cover, 1.0f);
            sum += static_cast<double>(cover);
        }
    return sum / count;
}

TEST(Streaks, AreManyInHeavyRainAndNoneWithoutOrBehindAWall) {
    EXPECT_EQ(meanStreaks(0.0f, 1e6f), 0.0);
    double const little = meanStreaks(0.1f, 1e6f);
    EXPECT_GT(little, 0.0);
    EXPECT_GT(meanStreaks(0.8f, 1e6f), 4.0 * little);
    EXPECT_EQ(meanStreaks(0.8f, 1.3f), 0.0);
}

TEST(Streaks, SlideAlongTheFallAndEndWhereItComesFrom) {
    vec3 const axis{0.0f, -1.0f, 0.0f};
    // A point of the sheet, and the same 0.1 m farther down when drops have fallen so far.
    for (float azimuth = 0.0f; azimuth < 6.2f; azimuth += 0.013f) {
        auto const at = [&](float y, float fallen) {
            return dropCover(normalize(vec3{std::cos(azimuth), y / 1.4f, std::sin(azimuth)}), axis, 1.4f, fallen, 0.2f, 0.002f, 0.8f, 0.0f, 1e6f);
        };
        ASSERT_NEAR(at(0.2f, 3.0f), at(0.1f, 3.1f), 0.02f) << azimuth;
    }
    EXPECT_EQ(dropCover(axis, axis, 1.4f, 3.0f, 0.2f, 0.002f, 1.0f, 0.001f, 1e6f), 0.0f);
    vec3 const side = acrossAxis(axis);
    EXPECT_NEAR(dot(side, axis), 0.0f, 1e-6f);
    EXPECT_NEAR(length(side), 1.0f, 1e-6f);
}

// --------------------------------------------------------------------------------------------------------- waves

TEST(Waves, HaveCoxAndMunksVarianceInWhatIsSeenAndWhatIsNot) {
    for (float wind : {2.0f, 6.0f, 12.0f})
        for (float footprint : {0.01f, 0.6f, 3.0f, 100.0f}) {
            std::mt19937 random{7};
            std::uniform_real_distribution<float> place{0.0f, static_cast<float>(kWavePeriod)};
            double variance = 0.0, hidden = 0.0;
            constexpr int kSamples = 20000;
            for (int i = 0; i < kSamples; ++i) {
                WaveFace const face = waveFace({place(random), place(random)}, {0.6f * wind, 0.8f * wind}, 17.0f, footprint);
                variance += static_cast<double>(dot(face.slope, face.slope)) / kSamples;
                hidden += static_cast<double>(face.unresolved) / kSamples;
            }
            double const asked = static_cast<double>(slopeVariance(wind));
            EXPECT_NEAR((variance + hidden) / asked, 1.0, 0.06) << wind << " " << footprint;
            EXPECT_TRUE(footprint < 50.0f || variance == 0.0);
        }
}

TEST(Waves, RepeatAndTravelDownwind) {
    for (float x : {3.0f, 400.5f}) {
        WaveFace const here = waveFace({x, 20.0f}, {5.0f, 2.0f}, 9.0f, 0.01f), there = waveFace({x + 1024.0f, 20.0f - 1024.0f}, {5.0f, 2.0f}, 9.0f, 0.01f);
        EXPECT_NEAR(here.slope.x, there.slope.x, 2e-3f);
        EXPECT_NEAR(here.slope.y, there.slope.y, 2e-3f);
    }
    // A moment later the face is more like itself seen a little upwind than a little downwind.
    double up = 0.0, down = 0.0;
    for (float x = 0.0f; x < 500.0f; x += 0.7f) {
        vec2 const wind{8.0f, 0.0f};
        float const now = waveFace({x, 3.0f}, wind, 1.05f, 0.5f).slope.x;
        up += std::abs(static_cast<double>(now - waveFace({x - 0.15f, 3.0f}, wind, 1.0f, 0.5f).slope.x));
        down += std::abs(static_cast<double>(now - waveFace({x + 0.15f, 3.0f}, wind, 1.0f, 0.5f).slope.x));
    }
    EXPECT_LT(up, 0.6 * down);
}

// ---------------------------------------------------------------------------------------------------------- land

TEST(LandNoise, IsTheSameFromWhicheverChunkAndCentredOnNothing) {
    double sum = 0.0;
    for (int i = 0; i < 4000; ++i) {
        vec2 const offset{static_cast<float>(i % 63) * 7.5f, static_cast<float>(i / 63) * 11.25f};
        float const value = landNoise({-4096, 8192}, offset, 6, 5u);
        ASSERT_LE(std::abs(value), 1.3f);
        ASSERT_EQ(value, landNoise({-4096 + 512, 8192 - 256}, {offset.x - 512.0f, offset.y + 256.0f}, 6, 5u));
        sum += static_cast<double>(value);
    }
    EXPECT_NEAR(sum / 4000.0, 0.0, 0.06);
}

TEST(LandNoise, HashesAreSpreadOverBothHalves) {
    double low = 0.0, high = 0.0, both = 0.0;
    constexpr int kCells = 10000;
    for (int i = 0; i < kCells; ++i) {
        uint const h = landCellHash(i % 100 - 50, i / 100 - 50, 3u);
        low += static_cast<double>(lowShare(h)), high += static_cast<double>(highShare(h));
        both += (static_cast<double>(lowShare(h)) - 0.5) * (static_cast<double>(highShare(h)) - 0.5);
    }
    EXPECT_NEAR(low / kCells, 0.5, 0.02);
    EXPECT_NEAR(high / kCells, 0.5, 0.02);
    EXPECT_NEAR(both / kCells, 0.0, 0.005);
}

LandPoint pointAt(float altitude) {
    LandPoint p;
    p.origin = {2048, -1024};
    p.offset = {77.0f, 31.0f};
    p.altitude = altitude;
    p.aboveWater = altitude - 250.0f;
    p.flatness = 1.0f;
    p.sunward = 0.0f;
    p.clearing = 1.0e4f;
    p.snowLine = 2500.0f;
    return p;
}

TEST(LandCover, HasSharesAndPutsSnowUpHighAndSandAtTheShore) {
    std::mt19937 random{3};
    std::uniform_real_distribution<float> unit{0.0f, 1.0f};
    double wooded = 0.0;
    for (int i = 0; i < 3000; ++i) {
        LandPoint p = pointAt(250.0f + 3500.0f * unit(random));
        p.offset = {4000.0f * unit(random), 4000.0f * unit(random)};
        p.flatness = 0.5f + 0.5f * unit(random);
        LandCover const c = landCover(p, 1.0f);
        for (float share : {c.fields, c.forest, c.rock, c.sand, c.snow, c.moisture}) {
            ASSERT_GE(share, 0.0f);
            ASSERT_LE(share, 1.0f);
        }
        ASSERT_TRUE(p.altitude < 2200.0f || c.forest == 0.0f) << "above the tree line";
        wooded += static_cast<double>(c.forest);
    }
    EXPECT_GT(wooded, 50.0);
    EXPECT_GT(landCover(pointAt(3200.0f), 1.0f).snow, 0.95f);
    EXPECT_EQ(landCover(pointAt(600.0f), 1.0f).snow, 0.0f);
    EXPECT_GT(landCover(pointAt(249.0f), 1.0f).sand, 0.9f);
    EXPECT_EQ(landCover(pointAt(300.0f), 1.0f).sand, 0.0f);
    LandPoint grounds = pointAt(400.0f);
    grounds.clearing = 0.0f;
    EXPECT_EQ(landCover(grounds, 1.0f).forest, 0.0f);
}

TEST(LandColour, HasTheLuminancesOfRealGround) {
    auto const mean = [](float LandCover::* share, float altitude) {
        double sum = 0.0;
        constexpr int kSamples = 1500;
        for (int i = 0; i < kSamples; ++i) {
            LandPoint p = pointAt(altitude);
            p.offset = {static_cast<float>(i % 40) * 23.0f, static_cast<float>(i / 40) * 31.0f};
            LandCover cover = landCover(p, 1.0f);
            cover.fields = cover.forest = cover.rock = cover.sand = cover.snow = 0.0f;
            if (share) cover.*share = 1.0f;
            LandColour const colour = landColour(p, cover, 1.0f);
            EXPECT_GT(luminanceOf(colour.albedo), 0.01f);
            EXPECT_LT(luminanceOf(colour.albedo), 0.95f);
            sum += static_cast<double>(luminanceOf(colour.albedo));
        }
        return sum / kSamples;
    };
    EXPECT_NEAR(mean(nullptr, 700.0f), 0.18, 0.05);               // meadow
    EXPECT_NEAR(mean(&LandCover::forest, 700.0f), 0.11, 0.03);
    EXPECT_NEAR(mean(&LandCover::rock, 1800.0f), 0.26, 0.06);
    EXPECT_NEAR(mean(&LandCover::snow, 3000.0f), 0.79, 0.04);
}

TEST(LandColour, LeavesOutWhatIsFinerThanAPixel) {
    EXPECT_EQ(visibleShare(1.0f, 100.0f), 0.0f);
    EXPECT_EQ(visibleShare(100.0f, 1.0f), 1.0f);
    EXPECT_EQ(detailNoise({0, 0}, {3.3f, 4.4f}, 3, 1u, 50.0f), 0.0f);
    EXPECT_EQ(detailNoise({0, 0}, {3.3f, 4.4f}, 3, 1u, 0.1f), landNoise({0, 0}, {3.3f, 4.4f}, 3, 1u));
    LandPoint p = pointAt(700.0f);
    LandCover const cover = landCover(p, 4000.0f);
    vec3 const here = landColour(p, cover, 4000.0f).albedo;
    p.offset += vec2{5.0f, 3.0f};
    EXPECT_EQ(here, landColour(p, cover, 4000.0f).albedo);
}
}  // namespace
}  // namespace luftpost::glsl
