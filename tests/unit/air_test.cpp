#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/air.h"
#include "engine/weather/convection.h"
#include "engine/weather/source.h"
#include "engine/weather/turbulence.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
core::GroundSample flatGround(double, double) { return {316.0, {0.0, 1.0, 0.0}, core::Surface::grass}; }
core::UtcSeconds noon() { return *core::parseUtc("2023-06-23T12:00Z"); }
Air airOf(Field const& field, unsigned seed = 1) { return Air{field, flatGround, seed}; }
}  // namespace

TEST(Air, IsTheStandardAtmosphereInThePresetCalm) {
    Field const field = loadWeather("preset:calm");
    AirInstant const air = airOf(field).instant(noon());
    // ISO 2533: altitude, temperature, pressure, density.
    double const table[][4] = {{0, 288.15, 101325, 1.22500}, {1000, 281.65, 89874.6, 1.11164}, {2000, 275.15, 79495.2, 1.00649},
                               {3000, 268.65, 70108.5, 0.90912}, {5000, 255.65, 54019.9, 0.73612}, {8000, 236.15, 35599.8, 0.52517},
                               {11000, 216.65, 22632.0, 0.36392}, {15000, 216.65, 12044.5, 0.19367}};
    for (auto const& row : table) {
        core::AirSample const sample = air.at({0.0, row[0], 0.0});
        EXPECT_NEAR(sample.temperature, row[1], 1e-9);
        EXPECT_NEAR(sample.pressure, row[2], 0.5);
        EXPECT_NEAR(sample.density, row[3], 0.00002) << row[0];
    }
}

TEST(Air, StandsStillInThePresetCalm) {
    Field const field = loadWeather("preset:calm");
    Air const air = airOf(field);
    for (int i = 0; i < 200; ++i) {
        core::AirSample const sample = air.at({i * 137.0, 300.0 + i * 25.0, i * -91.0}, noon() + i * 7.0);
        EXPECT_EQ(glm::length(sample.windWorld), 0.0);
        EXPECT_EQ(sample.turbulence, 0.0);
    }
}

TEST(Air, HasTheSameBitsFromAnyInstantAndAnyOrderOfAsking) {
    Field const field = loadWeather("preset:fair");
    Air const one = airOf(field), other = airOf(field);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 300; ++i) points.push_back({i * 61.0 - 9000.0, 320.0 + i * 7.0, 4000.0 - i * 83.0});
    AirInstant const instant = one.instant(noon());
    std::vector<core::AirSample> first;
    for (glm::dvec3 const& point : points) first.push_back(instant.at(point));
    for (std::size_t i = points.size(); i-- > 0;) {
        core::AirSample const again = other.at(points[i], noon());
        EXPECT_EQ(again.windWorld, first[i].windWorld);
        EXPECT_EQ(again.density, first[i].density);
        EXPECT_EQ(again.turbulence, first[i].turbulence);
    }
}

TEST(Air, TheMeanWindGrowsWithHeightAndVeers) {
    Field const field = loadWeather("preset:clear");
    double const ground = field.place().altitude_m;
    glm::dvec2 const low = field.windAt(0, 0, ground + 10.0, ground, noon()), high = field.windAt(0, 0, ground + 800.0, ground, noon());
    EXPECT_NEAR(glm::length(low), 3.0, 0.02);
    EXPECT_GT(glm::length(high), 1.7 * glm::length(low));
    // Turned to the right, seen along the wind: the cross product points down.
    EXPECT_LT(low.x * high.y - low.y * high.x, 0.0);
    EXPECT_NEAR(glm::length(field.windAt(0, 0, ground, ground, noon())), 0.0, 1e-9);
}

TEST(Air, TheWindBacksWithHeightInTheSouth) {
    Field const field = loadWeather("preset:clear", PlaceWish{-37.75, 144.875, 19.0});
    glm::dvec2 const low = field.windAt(0, 0, 29.0, 19.0, noon()), high = field.windAt(0, 0, 819.0, 19.0, noon());
    EXPECT_GT(low.x * high.y - low.y * high.x, 0.0);
}

TEST(Air, DrydensFiguresAreThoseOfTheSpecification) {
    // At 500 ft: rms of w a tenth of W20 (25, 50, 75 ft/s give 2.5, 5.05, 7.6 ft/s).
    for (double const w20 : {25.0, 50.0, 75.0}) EXPECT_NEAR(drydenGustiness(w20 * 0.3048, 152.4).sigmaVertical / 0.3048, 0.1 * w20, 0.1);
    Gustiness const g = drydenGustiness(10.0, 152.4);
    EXPECT_NEAR(g.lengthVertical, 152.4, 1e-9);
    EXPECT_NEAR(g.lengthHorizontal, 152.4 / std::pow(0.177 + 0.000823 * 500.0, 1.2), 1e-6);
    EXPECT_NEAR(g.sigmaHorizontal, 1.0 / std::pow(0.177 + 0.000823 * 500.0, 0.4), 1e-9);
    EXPECT_NEAR(drydenGustiness(10.0, 610.0).lengthVertical, 533.4, 1.0);
}

TEST(Air, GustsHaveTheRmsAskedForAndNoMean) {
    for (double const height : {60.0, 150.0, 600.0}) {
        Gustiness const g = drydenGustiness(10.0, height);
        glm::dvec3 sum{0.0}, squares{0.0};
        int const n = 60000;
        for (int i = 0; i < n; ++i) {
            glm::dvec3 const gust = gustAt({(i % 245) * 713.3, (i / 245 % 7) * 431.7, (i / 1715) * 1511.9}, g, 7);
            sum += gust;
            squares += gust * gust;
        }
        EXPECT_NEAR(std::sqrt(squares.y / n), g.sigmaVertical, 0.06 * g.sigmaVertical) << height;
        EXPECT_NEAR(std::sqrt(squares.x / n), g.sigmaHorizontal, 0.06 * g.sigmaHorizontal) << height;
        EXPECT_NEAR(sum.y / n, 0.0, 0.06 * g.sigmaVertical);
    }
}

TEST(Air, GustsAreSmoothAlongAFlight) {
    Field const field = loadWeather("preset:broken");
    Air const air = airOf(field);
    glm::dvec3 last{0.0};
    double way = 0.0;
    for (int tick = 0; tick < 2400; ++tick) {
        double const t = tick / 240.0;
        glm::dvec3 const wind = air.at({50.0 * t, 600.0, 0.0}, noon() + t).windWorld;
        double const change = tick == 0 ? 0.0 : glm::length(wind - last);
        EXPECT_LT(change, 0.15) << tick;
        way += change;
        last = wind;
    }
    EXPECT_GT(way, 2.0) << "there are gusts to be smooth";
}

TEST(Air, LiftUnderCumulusSumsToNothingOverThePlane) {
    for (float const cover : {0.05f, 0.35f, 0.8f, 1.0f}) {
        UnderCloud at;
        at.threshold = cover;
        at.ground = 300.0;
        at.base = 1500.0;
        at.top = 2400.0;
        at.altitude = 1000.0;
        at.heating = 1.0;
        double sum = 0.0, strongest = 0.0, weakest = 0.0;
        for (int i = 0; i < 10000; ++i) {
            at.rank = (i + 0.5) / 10000.0;
            double const lift = cumulusConvection(at).lift;
            sum += lift;
            strongest = std::max(strongest, lift);
            weakest = std::min(weakest, lift);
        }
        EXPECT_NEAR(sum / 10000.0, 0.0, 1e-4) << cover;
        EXPECT_LT(strongest, 3.0) << cover;
        EXPECT_GT(weakest, -2.1) << cover;
        EXPECT_GE(strongest, cover < 0.5f ? 1.0 : 0.0) << cover;
    }
}

TEST(Air, NoWindGoesThroughTheGround) {
    Field const field = loadWeather("preset:storm");
    AirInstant const air = airOf(field).instant(noon());
    for (int i = 0; i < 100; ++i) EXPECT_EQ(air.at({i * 777.0, 316.0, 0.0}).windWorld.y, 0.0);
}
