// Cloud columns: ranks are uniform, cover is the cover, density follows the margin.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

#include "engine/weather/cloud_column.h"
#include "engine/weather/cloud_depth.h"
#include "engine/weather/cloud_map.h"
#include "engine/weather/genera.h"
#include "engine/weather/noise_volume.h"
#include "shaders/lib/cloud.glsl"
#include "shaders/lib/cloud_light.glsl"

namespace {
using namespace luftpost;
using namespace luftpost::weather;

NoiseVolumes const& noise() {
    static NoiseVolumes const volumes = makeNoise(kNoiseSeed, 2);
    return volumes;
}

Weather weatherOf(Genus genus, float cover, float thickness, unsigned pattern = 7) {
    Weather weather;
    weather.layerCount = 1;
    weather.layers[0] = {.genus = genus, .cover = cover, .base = 1000.0f, .top = 1000.0f + thickness,
                         .water = static_cast<float>(genusRow(genus).water), .wind = {7.0, -4.0},
                         .drift = {12345.0, 6789.0}, .phase = 3.7, .pattern = pattern};
    return weather;
}

/// Share of a 120 km square, sampled on a grid, where the clouds are thick enough to count.
double shareUnder(Weather const& weather) {
    CloudColumns const columns{weather, 1};
    glsl::CloudShape const shape = cloudShape(weather, 1, glm::dvec2{0.0});
    int const n = 60;
    int covered = 0;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            double const east = (x + 0.5) * 2000.0 - 60000.0, north = (y + 0.5) * 2000.0 - 60000.0;
            glm::vec2 const place{static_cast<float>(east), static_cast<float>(-north)};
            covered += columnDepth(columns.at(east, north), shape, place, noise()) > coverDepth(weather.layers[0].genus);
        }
    return static_cast<double>(covered) / (n * n);
}

double measuredCover(Genus genus, float cover, float thickness, unsigned pattern) { return shareUnder(weatherOf(genus, cover, thickness, pattern)); }

TEST(CloudPattern, EveryRankIsAsLikelyAsAnyOther) {
    for (int genus = 0; genus < kGenera; ++genus)
        for (PatternDetail detail : {PatternDetail::Whole, PatternDetail::Coarse}) {
            std::array<int, 10> tenths{};
            for (unsigned pattern = 0; pattern < 20; ++pattern) {
                Weather const weather = weatherOf(static_cast<Genus>(genus), 0.5f, 500.0f, 1000u + pattern);
                LayerPattern const ranks{weather.layers[0], 3, detail};
                for (int i = 0; i < 1000; ++i)
                    ++tenths[static_cast<std::size_t>(std::min(9.0f, 10.0f * ranks.rank(i % 40 * 26173.0, i / 40 * 31337.0)))];
            }
            for (int count : tenths) EXPECT_NEAR(count / 20000.0, 0.1, 0.015) << genusName(static_cast<Genus>(genus));
        }
}

TEST(CloudPattern, GivesTheSameBitsForOnePointAndForMany) {
    // Many points are vector code where the processor has it; a single point is scalar code.
    for (int genus = 0; genus < kGenera; ++genus)
        for (PatternDetail detail : {PatternDetail::Whole, PatternDetail::Coarse})
            for (unsigned pattern = 0; pattern < 6; ++pattern) {
                Layer layer = weatherOf(static_cast<Genus>(genus), 0.5f, 500.0f, pattern).layers[0];
                layer.phase = 0.7 * pattern;
                LayerPattern const ranks{layer, 3, detail};
                std::vector<double> east, north;
                // Over the end of a period, so that cells wrap on both sides of it; 333 leaves a part of a
                // block.
                for (int i = 0; i < 333; ++i)
                    east.push_back(i * 61.7 - 9000.0), north.push_back(i * 3.7 * i - 200000.0);
                std::vector<float> many(east.size());
                ranks.drifting(east, north, many);
                for (std::size_t i = 0; i < east.size(); ++i)
                    ASSERT_EQ(many[i], ranks.drifting(east[i], north[i])) << i;
            }
}

TEST(CloudPattern, DriftsWithItsLayer) {
    Layer layer = weatherOf(Genus::Sc, 0.5f, 400.0f).layers[0];
    float const before = LayerPattern{layer, 1}.rank(1000.0, 2000.0);
    layer.drift += glm::dvec2{5000.0, -300.0};
    EXPECT_NEAR((LayerPattern{layer, 1}.rank(6000.0, 1700.0)), before, 1e-3);
}

TEST(CloudPattern, ChangesSlowlyWithItsPhase) {
    Layer layer = weatherOf(Genus::Cu, 0.5f, 900.0f).layers[0];
    LayerPattern const now{layer, 1};
    layer.phase += 0.01;
    LayerPattern const soon{layer, 1};
    double worst = 0.0, mean = 0.0;
    for (int i = 0; i < 400; ++i) {
        double const change = std::abs(now.rank(i * 731.0, i * 397.0) - soon.rank(i * 731.0, i * 397.0));
        worst = std::max(worst, change);
        mean += change / 400.0;
    }
    EXPECT_GT(mean, 1e-4);
    EXPECT_LT(mean, 0.03);
    EXPECT_LT(worst, 0.15);
}

TEST(CloudColumn, CoverIsTheShareOfTheGroundUnderCloud) {
    struct Case { Genus genus; float thickness; };
    for (Case const& c : {Case{Genus::Cu, 900.0f}, Case{Genus::Sc, 450.0f}, Case{Genus::St, 350.0f}, Case{Genus::Ac, 450.0f},
                          Case{Genus::Ci, 1200.0f}, Case{Genus::Cb, 9000.0f}})
        for (float cover : {0.1f, 0.25f, 0.5f, 0.75f, 0.9f})
            EXPECT_NEAR(measuredCover(c.genus, cover, c.thickness, 11u), cover, 0.03) << genusName(c.genus) << " " << cover;
}

TEST(CloudColumn, NoCoverIsEmptyAndFullCoverIsClosed) {
    for (int genus = 0; genus < kGenera; ++genus) {
        EXPECT_EQ(measuredCover(static_cast<Genus>(genus), 0.0f, 800.0f, 5u), 0.0) << genusName(static_cast<Genus>(genus));
        EXPECT_EQ(measuredCover(static_cast<Genus>(genus), 1.0f, 800.0f, 5u), 1.0) << genusName(static_cast<Genus>(genus));
    }
}

TEST(CloudColumn, ThresholdRisesWithCover) {
    for (int genus = 0; genus < kGenera; ++genus)
        for (float thickness : {100.0f, 700.0f, 5000.0f}) {
            float before = calibratedCover(static_cast<Genus>(genus), 0.0f, thickness);
            for (int i = 1; i <= 50; ++i) {
                float const now = calibratedCover(static_cast<Genus>(genus), static_cast<float>(i) / 50.0f, thickness);
                EXPECT_GT(now, before) << genusName(static_cast<Genus>(genus)) << " " << i;
                before = now;
            }
        }
}

TEST(CloudColumn, DensityNeverFallsAsTheCoverRises) {
    for (Genus genus : {Genus::Cu, Genus::Sc, Genus::St, Genus::Cb}) {
        Weather const weather = weatherOf(genus, 0.5f, 1000.0f);
        glsl::LayerShape const shape = cloudShape(weather, 1, glm::dvec2{0.0}).layers[0];
        for (int i = 0; i < 300; ++i) {
            glm::vec3 const p{static_cast<float>(i) * 313.0f, 1030.0f + static_cast<float>(i % 30) * 32.0f, static_cast<float>(i) * 171.0f};
            float before = 0.0f;
            for (float cover = 0.30f; cover < 0.70f; cover += 0.01f) {
                glsl::LayerColumn const column{0.45f, cover, 1000.0f, 2000.0f, 5e-4f, 0.45f};
                float const now = glsl::layerSample(p, column, shape, noise().shape.sampler(), noise().detail.sampler(),
                                                    noise().curl.plane(), 0.0f).extinction;
                EXPECT_GE(now, before - 2e-3f) << genusName(genus);
                before = now;
            }
        }
    }
}

/// Share of the plane with cloud at a share of the layer's height, and the mean extinction of it.
struct Level { double share = 0.0, extinction = 0.0; };
Level levelOf(Weather const& weather, float height) {
    CloudColumns const columns{weather, 1};
    glsl::LayerShape const shape = cloudShape(weather, 1, glm::dvec2{0.0}).layers[0];
    Level level;
    int const n = 60;
    int found = 0;
    for (int i = 0; i < n * n; ++i) {
        double const east = i % n * 1900.0, north = i / n * 1900.0;
        glsl::LayerColumn const column = columns.at(east, north).layers[0];
        glm::vec3 const p{static_cast<float>(east), column.base + height * (column.top - column.base), static_cast<float>(-north)};
        float const extinction = glsl::layerSample(p, column, shape, noise().shape.sampler(), noise().detail.sampler(), noise().curl.plane(), 0.0f).extinction;
        if (extinction < 1e-5f) continue;
        ++found;
        level.extinction += static_cast<double>(extinction);
    }
    level.share = static_cast<double>(found) / (n * n);
    level.extinction /= std::max(found, 1);
    return level;
}

TEST(Anvil, IsThinIceThatSpreadsOverItsTowersUnderTheTropopause) {
    for (float cover : {0.15f, 0.3f, 0.6f}) {
        Weather const weather = weatherOf(Genus::Cb, cover, 10000.0f);
        Level const tower = levelOf(weather, 0.45f), anvil = levelOf(weather, 0.91f), over = levelOf(weather, 0.97f);
        EXPECT_GT(tower.share, 0.07 * cover) << cover;
        EXPECT_GT(anvil.share, 1.6 * tower.share) << cover;
        EXPECT_GT(anvil.share, cover) << "its rim is too thin to count as cover";
        EXPECT_LT(over.share, tower.share) << "only the strongest tops shoot over it";
        EXPECT_LT(anvil.extinction, 0.4 * tower.extinction) << cover;
    }
    EXPECT_NEAR(levelOf(weatherOf(Genus::Cb, 0.3f, 1500.0f), 0.91f).share, 0.0, 0.1) << "a low cumulonimbus is bald";
}

/// Extinction of the first layer, 1/m.
double extinctionAt(CloudColumns const& columns, glsl::LayerShape const& shape, double east, double north, float height) {
    glsl::LayerColumn const column = columns.at(east, north).layers[0];
    glm::vec3 const p{static_cast<float>(east), column.base + height * (column.top - column.base), static_cast<float>(-north)};
    return static_cast<double>(glsl::layerSample(p, column, shape, noise().shape.sampler(), noise().detail.sampler(), noise().curl.plane(), 0.0f).extinction);
}

constexpr double kAway = 3000.0;  // m, of storms in cells of 8 km

TEST(Anvil, LiesOverItsTowersAndFarDownwindOfThemWhereverTheWindBlows) {
    for (glm::dvec2 const& wind : {glm::dvec2{0.0, 0.0}, glm::dvec2{9.0, 0.0}, glm::dvec2{-3.0, 6.0}, glm::dvec2{0.0, -25.0}}) {
        Weather weather = weatherOf(Genus::Cb, 0.25f, 9000.0f);
        weather.layers[0].wind = wind;
        CloudColumns const columns{weather, 1};
        glsl::LayerShape const shape = cloudShape(weather, 1, glm::dvec2{0.0}).layers[0];
        glm::dvec2 const way = glm::length(wind) > 0.0 ? glm::normalize(wind) : glm::dvec2{1.0, 0.0};
        int towers = 0, over = 0, ahead = 0, behind = 0;
        for (int i = 0; i < 10000; ++i) {
            double const east = i % 100 * 1130.0, north = i / 100 * 1130.0;
            if (extinctionAt(columns, shape, east, north, 0.5f) < 0.02) continue;
            ++towers;
            auto const ice = [&](double metres) { return extinctionAt(columns, shape, east + metres * way.x, north + metres * way.y, 0.9f) > 0.001; };
            over += ice(0.0);
            ahead += ice(kAway);
            behind += ice(-kAway);
        }
        ASSERT_GT(towers, 100);
        EXPECT_GT(over, 0.95 * towers) << wind.x << " " << wind.y;
        EXPECT_GT(ahead, 0.75 * towers) << wind.x << " " << wind.y;
        EXPECT_LT(behind, 0.4 * ahead) << wind.x << " " << wind.y;
    }
}

TEST(Anvil, DoesNotTouchTheCoverWhateverTheWind) {
    for (glm::dvec2 const& wind : {glm::dvec2{0.0, 0.0}, glm::dvec2{-20.0, 5.0}})
        for (float cover : {0.1f, 0.25f, 0.5f, 0.75f}) {
            for (float thickness : {2100.0f, 9000.0f}) {
                Weather weather = weatherOf(Genus::Cb, cover, thickness, 11u);
                weather.layers[0].wind = wind;
                EXPECT_NEAR(shareUnder(weather), cover, 0.03) << cover << " " << wind.x << " " << thickness;
            }
        }
}

TEST(Tower, IsWiderBelowThanAbove) {
    for (float cover : {0.15f, 0.3f, 0.6f}) {
        Weather const weather = weatherOf(Genus::Cb, cover, 10000.0f);
        double const foot = levelOf(weather, 0.1f).share, middle = levelOf(weather, 0.45f).share;
        EXPECT_GT(foot, 1.2 * middle) << cover;
        EXPECT_GT(middle, 0.25 * foot) << cover;
    }
}

TEST(Anvil, IsStreakedAlongItsWindAndTurnsWithItWithoutAStep) {
    // Mean square difference of the streaks over 120 m, along the wind and across it.
    auto const roughness = [](glsl::LayerShape const& shape, glm::dvec2 step) {
        double sum = 0.0;
        for (int i = 0; i < 400; ++i) {
            glm::vec3 const p{static_cast<float>(i) * 731.0f, 10000.0f, static_cast<float>(i % 20) * 1330.0f};
            glm::vec3 const q = p + glm::vec3{static_cast<float>(step.x), 0.0f, static_cast<float>(-step.y)};
            double const change = static_cast<double>(glsl::anvilStreaks(p, shape, noise().curl.plane(), 0.0f) - glsl::anvilStreaks(q, shape, noise().curl.plane(), 0.0f));
            sum += change * change / 400.0;
        }
        return sum;
    };
    for (int degrees = 0; degrees < 360; degrees += 15) {
        Weather weather = weatherOf(Genus::Cb, 0.3f, 10000.0f);
        glm::dvec2 const way{std::cos(degrees * 0.0174532925), std::sin(degrees * 0.0174532925)};
        weather.layers[0].wind = 20.0 * way;
        glsl::LayerShape const shape = cloudShape(weather, 1, glm::dvec2{0.0}).layers[0];
        double smoothest = 1e9, along = 0.0;
        for (int angle = 0; angle < 180; angle += 4) {
            double const rough = roughness(shape, 120.0 * glm::dvec2{std::cos(angle * 0.0174532925), std::sin(angle * 0.0174532925)});
            if (rough < smoothest) smoothest = rough, along = angle;
        }
        double const off = std::remainder(along - degrees, 180.0);
        EXPECT_LT(std::abs(off), 18.0) << "the eight ways lie up to 27 degrees apart; wind " << degrees;
        EXPECT_LT(smoothest, 0.6 * roughness(shape, 120.0 * glm::dvec2{-way.y, way.x})) << degrees;
        Weather turned = weather;
        turned.layers[0].wind = 20.0 * glm::dvec2{std::cos((degrees + 0.02) * 0.0174532925), std::sin((degrees + 0.02) * 0.0174532925)};
        glsl::LayerShape const next = cloudShape(turned, 1, glm::dvec2{0.0}).layers[0];
        for (int i = 0; i < 50; ++i) {
            glm::vec3 const p{static_cast<float>(i) * 731.0f, 10000.0f, static_cast<float>(i) * 1330.0f};
            EXPECT_NEAR(glsl::anvilStreaks(p, shape, noise().curl.plane(), 0.0f), glsl::anvilStreaks(p, next, noise().curl.plane(), 0.0f), 0.03) << degrees;
        }
    }
}

TEST(CloudColumn, IsTheSameFunctionForTheSameArguments) {
    Weather const weather = weatherOf(Genus::Cu, 0.4f, 900.0f);
    glsl::CloudColumn const a = CloudColumns{weather, 9}.at(4321.0, 1234.0);
    glsl::CloudColumn const b = CloudColumns{weather, 9}.at(4321.0, 1234.0);
    EXPECT_EQ(a.layers[0].rank, b.layers[0].rank);
    EXPECT_NE(a.layers[0].rank, (CloudColumns{weather, 10}.at(4321.0, 1234.0).layers[0].rank));
    EXPECT_EQ(a.layers[1].cover, -1.0f);
}

TEST(CloudMap, HoldsTheRanksOfItsTexelsCentres) {
    Layer const layer = weatherOf(Genus::Cu, 0.4f, 900.0f).layers[0];
    glm::dvec2 const camera{3000.0, -2000.0};
    for (int level : {0, 1}) {
        MapKey const key = mapKey(layer, level, camera, 4, 1.0f);
        MapTile const tile = makeTile(key);
        double const texel = kMapWidths[static_cast<std::size_t>(level)] / kMapSize;
        Layer moment = layer;
        moment.phase = key.moment * (level == 0 ? 0.01 : 0.03);
        LayerPattern const pattern{moment, 4};
        for (int i = 3; i < kMapSize; i += 97) {
            double const east = tile.corner.x + (i + 0.5) * texel, south = tile.corner.y + (200 + 0.5) * texel;
            float const stored = static_cast<float>(tile.ranks[static_cast<std::size_t>(200 * kMapSize + i)]) / 65535.0f;
            EXPECT_NEAR(stored, pattern.drifting(east, -south), 2e-5f);
        }
        // The camera stands within a sixteenth of the middle.
        glm::dvec2 const inLayer{camera.x - layer.drift.x, layer.drift.y - camera.y};
        glm::dvec2 const off = (inLayer - tile.corner) / kMapWidths[static_cast<std::size_t>(level)] - 0.5;
        EXPECT_LT(std::max(std::abs(off.x), std::abs(off.y)), 1.0 / 16.0);
    }
}

// Time may run before the first report, too: drift and phase are then negative.
TEST(CloudMap, HoldsTheRanksOfAnHourBeforeTheFirstReport) {
    Layer layer = weatherOf(Genus::Cu, 0.4f, 900.0f).layers[0];
    layer.phase = -37.5;
    layer.drift = {-9.0e5, 1.0e5};
    MapKey const key = mapKey(layer, 0, {0.0, 0.0}, 4, 1.0f);
    MapTile const tile = makeTile(key);
    LayerPattern const pattern{layer, 4};
    double const texel = kMapWidths[0] / kMapSize;
    for (int i = 3; i < kMapSize; i += 97) {
        double const east = tile.corner.x + (i + 0.5) * texel, south = tile.corner.y + (200 + 0.5) * texel;
        EXPECT_NEAR(static_cast<float>(tile.ranks[static_cast<std::size_t>(200 * kMapSize + i)]) / 65535.0f, pattern.drifting(east, -south), 0.02f);
    }
}

TEST(CloudMap, HandsOverWhatIsWantedAndNothingTwice) {
    CloudMap map{2};
    MapLayers layers{};
    layers[1] = weatherOf(Genus::St, 0.5f, 300.0f).layers[0];
    map.want(layers, {0.0, 0.0}, 1, 1.0f, true);
    int tiles = 0;
    while (auto const ready = map.take()) {
        EXPECT_EQ(ready->slot, 1);
        ++tiles;
    }
    EXPECT_EQ(tiles, kMapLevels);
    map.want(layers, {100.0, 0.0}, 1, 1.0f, true);
    EXPECT_FALSE(map.take());
}

TEST(CloudLight, PhaseFunctionsIntegrateToOne) {
    for (float g : {0.0f, 0.5f, 0.85f, 0.95f}) {
        double henyey = 0.0, droplets = 0.0;
        int const n = 20000;
        for (int i = 0; i < n; ++i) {
            float const cosine = -1.0f + 2.0f * (static_cast<float>(i) + 0.5f) / n;
            henyey += static_cast<double>(glsl::henyeyGreenstein(cosine, g)) * 4.0 * 3.14159265358979 / n;
            droplets += static_cast<double>(glsl::cloudPhase(cosine, g)) * 4.0 * 3.14159265358979 / n;
        }
        EXPECT_NEAR(henyey, 1.0, 1e-3) << g;
        EXPECT_NEAR(droplets, 1.0, 1e-3) << g;
    }
}

constexpr float kEvenTurns = 0.2f;  // 1 less the mean cosine

TEST(CloudLight, LeavesTheDarkFaceOfASlabAFewthOfTheLitOneAndOfANarrowCloudLess) {
    auto const lit = [](float toLight, float wide) {
        return glsl::litByBeam(glsl::rayPhase(0.0f, 0.85f), toLight, glsl::closedGlow(toLight, toLight, 60.0f - toLight, wide, 6.0f, 1.0f, kEvenTurns).x);
    };
    EXPECT_GT(lit(0.5f, 600.0f) / lit(59.5f, 600.0f), 4.0f);
    EXPECT_LT(lit(0.5f, 600.0f) / lit(59.5f, 600.0f), 16.0f);
    EXPECT_GT(lit(55.0f, 600.0f), 3.0f * lit(55.0f, 60.0f));
    // It takes some turns to become even: the most is an even turn below the lit face.
    for (float t = 10.5f; t < 55.0f; t += 5.0f) EXPECT_GT(lit(t, 100.0f), lit(t + 5.0f, 100.0f));
    EXPECT_GT(lit(5.5f, 600.0f), lit(0.5f, 600.0f));
}

// Of a slab that the light barely grazes the top is lit, of a tower its side.
TEST(CloudLight, LightsASheetFromAboveAndAWallFromItsSide) {
    auto const glow = [](float toLight, float above, float wide) { return glsl::closedGlow(toLight, above, 20.0f - above, wide, 3.0f, 0.2f, kEvenTurns).x; };
    EXPECT_GT(glow(5.0f, 1.0f, 2000.0f), 3.0f * glow(95.0f, 19.0f, 2000.0f));
    EXPECT_NEAR(glow(5.0f, 1.0f, 20.0f) / glow(5.0f, 19.0f, 20.0f), 1.0f, 0.2f);
    EXPECT_GT(glow(1.0f, 10.0f, 20.0f), 3.0f * glow(19.0f, 10.0f, 20.0f));
}

TEST(CloudLight, PutsRightWhatAGridSmears) {
    auto const contrast = [](float toLight, float depth, float width) { return glsl::gridContrast(toLight, depth, glsl::narrowness(width), 0.8f, kEvenTurns); };
    EXPECT_GT(contrast(1.0f, 9.0f, 300.0f), 1.0f);
    EXPECT_LT(contrast(30.0f, 9.0f, 300.0f), 0.95f * contrast(1.0f, 9.0f, 300.0f)) << "too much gets through to the far side";
    EXPECT_LT(contrast(1.0f, 0.0f, 300.0f), 0.95f * contrast(1.0f, 9.0f, 300.0f)) << "and too little out at an edge";
    for (float const toLight : {0.5f, 10.0f, 60.0f}) EXPECT_NEAR(contrast(toLight, 0.5f, 20000.0f), 1.0f, 1e-2f) << "but not of a sheet";
}

TEST(CloudLight, IsLessTheDeeperTowardTheLightAndInProportionToTheGlow) {
    auto const lit = [](float toLight, float glow) { return glsl::litByBeam(glsl::rayPhase(0.0f, 0.85f), toLight, glow); };
    for (float t = 4.5f; t < 40.0f; t += 4.0f) EXPECT_GT(lit(t, 0.05f), lit(t + 4.0f, 0.05f));
    EXPECT_NEAR(lit(3.0f, 0.10f) - lit(3.0f, 0.05f), glsl::kGlow * 0.05f, 1e-5f);
    EXPECT_LT(lit(900.0f, 0.0f), 1e-6f);
    EXPECT_NEAR(glsl::litBySky(glm::vec3{1.0f}, glm::vec3{9.0f}, 1.0f).x, glsl::kGlowAbove, 1e-6f);
    EXPECT_NEAR(glsl::litBySky(glm::vec3{9.0f}, glm::vec3{1.0f}, 0.0f).x, glsl::kGlowBelow, 1e-6f);
    EXPECT_NEAR(glsl::glowAhead(0.85f), 3.8f, 0.05f);
    EXPECT_EQ(glsl::glowAhead(0.0f), 0.0f);
}

// Two streams: what falls on a slab comes out above or below, or straight through; and below where the beam reaches its mean radiance
// falls evenly. What a sky lights from above and one from below together are 1 everywhere.
TEST(CloudLight, LosesNothingInASlab) {
    double const pi = 3.14159265358979;
    for (float const m : {0.2f, 0.6f, 1.0f})
        for (float const all : {0.5f, 4.0f, 30.0f}) {
            double const out = 2.0 * pi * static_cast<double>(glsl::slabGlow(0.0f, all, m) + glsl::slabGlow(all, all, m));
            EXPECT_NEAR(out + static_cast<double>(m * std::exp(-all / m)), static_cast<double>(m), 1e-5) << m << ' ' << all;
            for (float const at : {0.0f, 0.3f, 1.0f})
                EXPECT_NEAR(glsl::slabSkyGlow(at * all, all) + glsl::slabSkyGlow((1.0f - at) * all, all), 1.0f, 1e-5f);
        }
    auto const deep = [](float front) { return glsl::slabGlow(front, 30.0f, 0.6f); };
    EXPECT_NEAR(deep(20.0f), 0.5f * (deep(15.0f) + deep(25.0f)), 1e-6f);
    EXPECT_EQ(glsl::slabSkyGlow(0.0f, 0.0f), 0.5f);
    EXPECT_NEAR(glsl::slabSkyGlow(20.0f, 20.0f), 0.5f * glsl::diffused(20.0f / kEvenTurns, kEvenTurns), 1e-6f);
}
}  // namespace
