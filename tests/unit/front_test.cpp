// Fronts: found in reports, joined to a line, seen earlier and later by where one stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/core/time.h"
#include "engine/weather/fill.h"
#include "engine/weather/source.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
constexpr double kHour = 3600.0;
core::UtcSeconds const kStart = *core::parseUtc("2024-03-01T00:00Z");
core::UtcSeconds utc(char const* text) { return *core::parseUtc(text); }
constexpr double kLat = 47.0, kLon = 8.0;

struct Spot {
    double east, north;  // m
};

/// Before the front 20 C, wind from 200 degrees; behind it 13 C, from 290 degrees and closed rain cloud.
Report reportAt(double time, bool behind) {
    Report r;
    r.time = time;
    r.speed_mps = behind ? 12.0 : 6.0;
    r.from_deg = behind ? 290.0 : 200.0;
    r.gust_mps = behind ? 19.0 : 8.0;
    r.temperature_c = behind ? 13.0 : 20.0;
    r.dew_point_c = 11.0;
    r.pressure_hpa = behind ? 1008.5 : 1006.0;
    r.visibility_m = 30000.0;
    r.thunder = false;
    r.precipitationKind = behind ? Precipitation::Rain : Precipitation::None;
    r.rate_mm_h = behind ? 4.0 : 0.0;
    r.layers.emplace();
    r.layers->push_back({behind ? Genus::Ns : Genus::Cu, behind ? 1.0 : 0.3, 1200.0, behind ? 4000.0 : 2000.0});
    return r;
}

Site siteAt(std::string name, Spot spot, double passage, double step) {
    double const degree = core::radians(1.0) * core::kEarthRadius;
    Site site{std::move(name), kLat + spot.north / degree, kLon + spot.east / (degree * std::cos(core::radians(kLat))), 300.0, {}};
    for (double t = 0.0; t <= 12.0 * kHour; t += step) site.reports.push_back(reportAt(kStart + t, kStart + t > passage));
    return site;
}

Field fieldOf(std::vector<Site> sites) {
    Recording recording;
    recording.name = "test";
    recording.sites = std::move(sites);
    return fieldFrom(std::move(recording), {SourceMode::Recorded, "test", "test", "", "", 0.0}, PlaceWish{kLat, kLon, 300.0});
}

/// A line that moves toward 110 degrees at 15 m/s and passes the world's origin at 6:10.
constexpr double kSpeed = 15.0;
double passageAt(Spot spot) {
    double const toward = core::radians(110.0);
    return kStart + 6.0 * kHour + 600.0 + (spot.east * std::sin(toward) + spot.north * std::cos(toward)) / kSpeed;
}

/// When the temperature at a place goes through the middle, and how long it takes from 10 to 90 %.
struct Seen {
    double middle = 0.0, seconds = 0.0;
};
Seen passageSeen(Field const& field, Spot spot) {
    double ten = 0.0, fifty = 0.0, ninety = 0.0;
    for (double t = kStart; t < kStart + 12.0 * kHour; t += 10.0) {
        double const share = (20.0 + 273.15 - field.at(spot.east, spot.north, t).temperature) / 7.0;
        if (share >= 0.1 && ten == 0.0) ten = t;
        if (share >= 0.5 && fifty == 0.0) fifty = t;
        if (share >= 0.9 && ninety == 0.0) ninety = t;
    }
    return {fifty, ninety - ten};
}

std::vector<Spot> const kTriangle{{-60'000.0, -20'000.0}, {30'000.0, -45'000.0}, {10'000.0, 55'000.0}};
Field triangle(double step) {
    std::vector<Site> sites;
    for (Spot const& spot : kTriangle) sites.push_back(siteAt("site", spot, passageAt(spot), step));
    return fieldOf(std::move(sites));
}
}  // namespace

TEST(Front, OfThreeSitesPassesEveryInnerPointWithinFiveMinutes) {
    Field const field = triangle(600.0);
    ASSERT_EQ(field.passages().size(), 3u);
    for (double a = 0.1; a < 0.95; a += 0.2)
        for (double b = 0.1; a + b < 0.95; b += 0.2) {
            double const c = 1.0 - a - b;
            Spot const inner{a * kTriangle[0].east + b * kTriangle[1].east + c * kTriangle[2].east,
                             a * kTriangle[0].north + b * kTriangle[1].north + c * kTriangle[2].north};
            Seen const seen = passageSeen(field, inner);
            EXPECT_NEAR(seen.middle, passageAt(inner), 300.0) << inner.east << " " << inner.north;
            EXPECT_LE(seen.seconds, 600.0);
            EXPECT_GE(seen.seconds * kSpeed, 3000.0);
        }
}

TEST(Front, TwentyKilometresAheadOfItTheWeatherIsStillTheOneBefore) {
    Field const field = triangle(600.0);
    Spot const inner{-5000.0, 0.0};
    Weather const w = field.at(inner.east, inner.north, passageAt(inner) - 20'000.0 / kSpeed);
    EXPECT_NEAR(w.temperature, 20.0 + 273.15, 0.05);
    EXPECT_NEAR(windFrom_deg(w.windSurface), 200.0, 1.0);
    EXPECT_NEAR(w.precipitationRate, 0.0, 0.01);
    Weather const behind = field.at(inner.east, inner.north, passageAt(inner) + 20'000.0 / kSpeed);
    EXPECT_NEAR(behind.temperature, 13.0 + 273.15, 0.05);
    EXPECT_NEAR(windFrom_deg(behind.windSurface), 290.0, 1.0);
    EXPECT_NEAR(behind.gust, 19.0, 0.1);
    ASSERT_GE(behind.layerCount, 1);
    EXPECT_EQ(behind.layers[0].genus, Genus::Ns);
    EXPECT_GT(behind.precipitationRate, 3.0);
}

TEST(Front, FromHourlyReportsIsAsNarrowAndPassesInTheMiddleOfItsHour) {
    // Passes between 6:00 and 7:00 everywhere, so the hour is all that one knows: half an hour off at most.
    Field const field = triangle(3600.0);
    ASSERT_EQ(field.passages().size(), 3u);
    Spot const at = kTriangle[1];
    Seen const seen = passageSeen(field, at);
    EXPECT_NEAR(seen.middle, passageAt(at), 1800.0);
    EXPECT_LE(seen.seconds, 600.0);
}

TEST(Front, OfOneSiteMovesWithTheWindBehindIt) {
    Field const field = fieldOf({siteAt("a", {0.0, 0.0}, kStart + 6.0 * kHour + 300.0, 600.0)});
    ASSERT_EQ(field.passages().size(), 1u);
    Passage const& passage = field.passages()[0];
    EXPECT_NEAR(passage.speed, 12.0, 1e-9);
    EXPECT_NEAR(passage.toward.x, std::sin(core::radians(110.0)), 1e-9);
    double const there = passageSeen(field, {0.0, 0.0}).middle;
    for (double const away : {-30'000.0, -10'000.0, 10'000.0, 30'000.0}) {
        Spot const spot{away * passage.toward.x, away * passage.toward.y};
        EXPECT_NEAR(passageSeen(field, spot).middle - there, away / 12.0, 30.0);
    }
    auto const near = field.front(10'000.0, 0.0, there);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance, 10'000.0 * passage.toward.x, 400.0);
}

TEST(Front, KeepsTheSumOfItsHour) {
    Field const field = fieldOf({siteAt("a", {0.0, 0.0}, kStart + 6.0 * kHour + 300.0, 3600.0)});
    double sum = 0.0;
    for (int i = 0; i < 3600; ++i) sum += field.at(0, 0, kStart + 6.0 * kHour + i + 0.5).precipitationRate / kHour;
    EXPECT_NEAR(sum, 4.0, 0.04);
    EXPECT_LT(field.at(0, 0, kStart + 6.1 * kHour).precipitationRate, 0.05) << "it rains with the front and not before";
}

TEST(Front, WithoutAShiftOfTheWindOrIntoCalmIsNone) {
    Site turned = siteAt("a", {0.0, 0.0}, kStart + 6.0 * kHour, 600.0), calm = turned, warm = turned;
    for (Report& r : turned.reports) r.from_deg = 250.0;
    for (Report& r : calm.reports) r.speed_mps = 1.0;
    for (Report& r : warm.reports) r.temperature_c = 15.0, r.pressure_hpa = 1010.0;
    for (Site const& site : {turned, calm, warm}) EXPECT_TRUE(fieldOf({site}).passages().empty());
}

TEST(Front, OfBaselIsReproducedAtTheSiteAndSeenEarlierUpwind) {
    Field const field = loadWeather(std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/basel_2023-06-21_23.json");
    auto const& passages = field.passages();
    auto const gustFront = std::find_if(passages.begin(), passages.end(), [](Passage const& p) {
        return p.time > utc("2023-06-22T17:00Z") && p.time < utc("2023-06-22T18:00Z");
    });
    ASSERT_NE(gustFront, passages.end());
    EXPECT_NEAR(gustFront->time, utc("2023-06-22T17:25Z"), 301.0);
    for (Report const& r : field.recording().sites[0].reports) {
        if (r.time < utc("2023-06-22T16:00Z") || r.time > utc("2023-06-22T19:00Z")) continue;
        Weather const w = field.at(0.0, 0.0, r.time);
        ASSERT_TRUE(r.temperature_c && r.speed_mps && r.from_deg);
        EXPECT_NEAR(w.temperature, *r.temperature_c + 273.15, 0.05) << core::formatUtc(r.time);
        EXPECT_NEAR(glm::length(w.windSurface - windVector(*r.speed_mps, *r.from_deg)), 0.0, 0.1) << core::formatUtc(r.time);
    }
    auto const falls = [&](glm::dvec2 at) {
        double best = 0.0, when = 0.0;
        for (double t = utc("2023-06-22T16:00Z"); t < utc("2023-06-22T19:00Z"); t += 10.0) {
            double const fall = field.at(at.x, at.y, t).temperature - field.at(at.x, at.y, t + 60.0).temperature;
            if (fall > best) best = fall, when = t;
        }
        return when;
    };
    double const here = falls({0.0, 0.0}), upwind = falls(-15'000.0 * gustFront->toward);
    EXPECT_NEAR(here - upwind, 15'000.0 / gustFront->speed, 60.0);
}

TEST(Front, TimeIsReadForwardOnlyAndWithoutAJumpWhereverOneStands) {
    Field const field = triangle(600.0);
    for (Spot const spot : {Spot{0.0, 0.0}, {-80'000.0, 0.0}, {120'000.0, 40'000.0}}) {
        double before = field.at(spot.east, spot.north, kStart).temperature;
        for (double t = kStart; t < kStart + 12.0 * kHour; t += 20.0) {
            double const now = field.at(spot.east, spot.north, t).temperature;
            EXPECT_LE(now, before + 1e-6) << "it only ever cools";
            EXPECT_LT(before - now, 0.6);
            before = now;
        }
    }
}
