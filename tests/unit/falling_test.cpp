// What falls: where a shaft stands under its cloud, where virga ends, and that the shaders' twin says the same as the air.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/fill.h"
#include "engine/weather/showers.h"
#include "shaders/lib/falling.glsl"
#include "tests/unit/cloud_air_sky.h"

namespace {
using namespace luftpost;
using namespace luftpost::weather;

/// Showers from clouds 2.2 km above dry land, in a wind that grows with height.
Weather dryShowers(double rate) {
    Weather weather;
    weather.layerCount = 1;
    weather.layers[0] = {.genus = Genus::Cb, .cover = 0.3f, .base = 2500.0f, .top = 11000.0f, .water = 1e-3f, .wind = {18.0, 4.0}, .pattern = 5};
    weather.windSurface = {4.0, 1.0};
    weather.temperature = 299.15;
    weather.dewPoint = 281.55;  // condensation 2200 m above the ground
    weather.condensationLevel = 2500.0;
    weather.precipitation = Precipitation::Rain;
    weather.precipitationRate = rate;
    weather.freezingLevel = 4000.0;
    return weather;
}

TEST(Virga, EndsWhereTheAirHasTakenAllOfItAndADownpourReachesTheGround) {
    Shower const shower = showersOf(dryShowers(1.0), {0.3})[0];
    ASSERT_TRUE(shower.falls());
    double const ground = 300.0;
    for (double const inside : {0.02, 0.1, 0.2}) {
        double const end = shower.from - std::sqrt(shower.root * std::sqrt(inside) / shower.drying);
        if (end < ground) continue;
        EXPECT_GT(shower.rate(inside, end + 30.0), 0.0) << inside;
        EXPECT_EQ(shower.rate(inside, end - 1.0), 0.0) << inside;
    }
    EXPECT_EQ(shower.rate(0.05, ground), 0.0) << "its rim is virga";
    EXPECT_GT(shower.rate(0.05, shower.from), 0.5);
    EXPECT_GT(shower.rate(1.0, ground), 5.0) << "its middle is not";
    EXPECT_LT(shower.rate(1.0, ground), 0.8 * shower.rate(1.0, shower.from));
    EXPECT_EQ(shower.rate(0.5, shower.from), shower.rate(0.5, shower.from + 500.0)) << "nothing is lost in saturated air";
    // Kessler's law (1969), of which ours is the root, integrated step by step: 10 mm/h from the base to the ground.
    double rate = 10.0 / 3.6;  // g/(m2 s)
    for (double depth = 0.5; depth < 2200.0; depth += 1.0) {
        double const celsius = 26.0, saturation = 610.94 * std::exp(17.625 * celsius / (celsius + 243.04)) / (461.5 * 299.15) * 1e3;
        double const deficit = 0.06 * saturation * 8e-3 * depth, water = std::pow(rate / 5.17, 1.0 / 1.125);
        rate -= 5.44e-4 * deficit * std::pow(water, 0.65);
        if (rate <= 0.0) break;
    }
    double const ours = std::pow(std::max(std::sqrt(10.0) - shower.drying * 2200.0 * 2200.0, 0.0), 2.0);
    EXPECT_NEAR(ours, std::max(rate, 0.0) * 3.6, 1.5);
}

TEST(Virga, LeavesTheReportsRateToTheGroundInTheMean) {
    for (double const rate : {0.3, 1.0, 4.0})
        for (double const cover : {0.15, 0.4, 0.9}) {
            Shower const shower = showersOf(dryShowers(rate), {cover})[0];
            Weather const weather = dryShowers(rate);
            double const ground = weather.condensationLevel - condensationHeight(weather.temperature, weather.dewPoint);
            double mean = 0.0;
            for (int i = 0; i < 4000; ++i) mean += shower.rate(showerInside(Genus::Cb, (i + 0.5) / 4000.0, cover).here, ground) / 4000.0;
            ASSERT_LT(shower.rate(1.0, 300.0), 149.0) << "no heavier than rain can be";
            EXPECT_NEAR(mean, rate, 0.04 * rate) << rate << " " << cover;
        }
}

TEST(Shaft, FallsFromTheStormAndNotFromTheCumulusBesideIt) {
    Weather weather = dryShowers(1.0);
    weather.layers[1] = weather.layers[0];
    weather.layers[1].genus = Genus::Cu;
    weather.layerCount = 2;
    auto const both = showersOf(weather, {0.3, 0.3});
    EXPECT_TRUE(both[0].falls());
    EXPECT_FALSE(both[1].falls());
    EXPECT_TRUE(showersOf(weather, {0.0, 0.3})[1].falls());
    // As the report's rate goes to nothing, so does what falls aloft.
    weather.precipitationRate = 1e-6;
    EXPECT_LT(showersOf(weather, {0.3, 0.3})[0].root, 0.02);
}

TEST(Shaft, LagsBehindTheCloudThatItsDropsFellFrom) {
    Shower const shower = showersOf(dryShowers(1.0), {0.3})[0];
    EXPECT_EQ(shower.source(2500.0, 2600.0), (glm::dvec2{0.0}));
    glm::dvec2 const low = shower.source(2500.0, 300.0), middle = shower.source(2500.0, 1400.0);
    // 14 m/s of shear over the 2200 m, half of it in the mean, for 2200 m / 6 m/s.
    EXPECT_NEAR(low.x, 0.5 * 14.0 * 2200.0 / 6.0, 20.0);
    EXPECT_NEAR(low.y, 0.5 * 3.0 * 2200.0 / 6.0, 5.0);
    EXPECT_NEAR(glm::length(middle) / glm::length(low), 0.25, 1e-9);
}

TEST(Shaft, IsWhereTheAirsRainIs) {
    // The pass asks the twin; the air asks showers. Both of the same ranks.
    tests::CloudAirSky const sky{"preset:storm", *core::parseUtc("2023-06-23T12:00Z")};
    std::vector<glsl::LayerFall> falls;
    std::vector<LayerPattern> patterns;
    weather::Weather const& weather = sky.clouds.weather;
    for (std::size_t i = 0; i < static_cast<std::size_t>(weather.layerCount); ++i) {
        Shower const& shower = sky.clouds.showers[i];
        falls.push_back({{static_cast<float>(shower.root), static_cast<float>(shower.drying), static_cast<float>(shower.from), shower.storm ? 1.0f : 0.0f},
                         {static_cast<float>(shower.lag.x), static_cast<float>(-shower.lag.y), 0.0f, 0.0f}, glm::vec4{0.0f}});
        patterns.emplace_back(weather.layers[i], 1);
    }
    ASSERT_TRUE(sky.clouds.showers[0].falls() && weather.layers[0].genus == Genus::Cb);
    double worst = 0.0, mean = 0.0;
    int wet = 0;
    for (int i = 0; i < 1200; ++i) {
        double const east = (i % 40) * 911.0, north = (i / 40) * 797.0, height = 50.0 + (i % 7) * 80.0;
        CloudEffect const air = sky.at(east, north, height, 290.0);
        float const altitude = static_cast<float>(tests::kFlatGround + height);
        float seen = 0.0f;
        for (std::size_t k = 0; k < falls.size(); ++k) {
            glm::vec2 const lag = glsl::fallLag(falls[k], weather.layers[k].base - altitude);
            float const rank = patterns[k].rank(east + static_cast<double>(lag.x), north - static_cast<double>(lag.y));
            seen += glsl::rateBelow(falls[k], falls[k].shower.x, glsl::showerDepth(rank, weather.layers[k].cover, falls[k].shower.w, 0.0f), altitude);
        }
        double const felt = air.rain + air.snow + air.hail;
        worst = std::max(worst, std::abs(static_cast<double>(seen) - felt));
        mean += std::abs(static_cast<double>(seen) - felt) / 1200.0;
        wet += felt > 1.0;
    }
    ASSERT_GT(wet, 200);
    EXPECT_LT(mean, 1.0) << "mm/h; the air remembers ranks on a lattice";
    EXPECT_LT(worst, 15.0);
}

TEST(Shaft, TheTwinSplitsAndDimsAsTheAirDoes) {
    Weather const weather = dryShowers(3.0);
    glsl::FallAll const all{{static_cast<float>(weather.freezingLevel), 1.0f, 300.0f, 3.0f}};
    for (double altitude = 320.0; altitude < 5000.0; altitude += 130.0) {
        double const temperature = 273.15 + 0.0065 * (weather.freezingLevel - altitude);
        Falling const fall = fallingOf(weather, 1.0, 0.0, altitude - 300.0, altitude, temperature);
        EXPECT_NEAR(static_cast<double>(glsl::liquidShare(all, static_cast<float>(altitude))), fall.rain / (fall.rain + fall.snow), 0.02) << altitude;
    }
    for (double const rate : {0.1, 1.0, 10.0, 100.0}) {
        EXPECT_NEAR(static_cast<double>(glsl::fallingExtinction(static_cast<float>(rate), 0.0f)), fallExtinction(rate, 0.0), 2e-3 * fallExtinction(rate, 0.0));
        EXPECT_NEAR(static_cast<double>(glsl::fallingExtinction(0.0f, static_cast<float>(rate))), fallExtinction(0.0, rate), 2e-3 * fallExtinction(0.0, rate));
    }
    for (double cover = 0.05; cover <= 1.0; cover += 0.05)
        for (double rank = 0.0; rank <= 1.0; rank += 0.04)
            for (Genus genus : {Genus::Cb, Genus::Ns})
                EXPECT_NEAR(static_cast<double>(glsl::showerDepth(static_cast<float>(rank), static_cast<float>(cover), genus == Genus::Cb ? 1.0f : 0.0f, 0.0f)),
                            showerInside(genus, rank, cover).here, 1e-4);
}
}  // namespace
