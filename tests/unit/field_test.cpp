#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/error.h"
#include "engine/core/frames.h"
#include "engine/core/time.h"
#include "engine/weather/source.h"
#include "engine/weather/presets.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
constexpr double kHour = 3600.0;
core::UtcSeconds const kStart = 1687400000.0;

std::string const kBasel = std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/basel_2023-06-21_23.json";
std::string const kMelbourne = std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/melbourne_2024-01-16.json";
core::UtcSeconds utc(char const* text) { return *core::parseUtc(text); }

Report plainReport(double hours) {
    Report report;
    report.time = kStart + hours * kHour;
    report.speed_mps = 5.0;
    report.from_deg = 270.0;
    report.gust_mps = 8.0;
    report.temperature_c = 15.0;
    report.dew_point_c = 8.0;
    report.pressure_hpa = 1013.0;
    report.visibility_m = 20000.0;
    report.precipitationKind = Precipitation::None;
    report.rate_mm_h = 0.0;
    report.thunder = false;
    report.layers.emplace();
    return report;
}

Site siteOf(std::string name, double lat, double lon, std::vector<Report> reports) { return {std::move(name), lat, lon, 300.0, std::move(reports)}; }

Field fieldOf(std::vector<Site> sites, std::optional<PlaceWish> place = {}) {
    Recording recording;
    recording.name = "test";
    recording.sites = std::move(sites);
    return fieldFrom(std::move(recording), {SourceMode::Recorded, "test", "test", "", ""}, place);
}
Field fieldOf(std::vector<Report> reports) { return fieldOf({siteOf("a", 47.0, 8.0, std::move(reports))}); }

/// The largest cover step over a second anywhere between two times.
double largestCoverStep(Field const& field, double from, double to) {
    double largest = 0.0;
    auto const coverOf = [](Weather const& w, unsigned pattern) {
        for (int i = 0; i < w.layerCount; ++i)
            if (w.layers[static_cast<std::size_t>(i)].pattern == pattern) return static_cast<double>(w.layers[static_cast<std::size_t>(i)].cover);
        return 0.0;
    };
    for (double t = from; t < to; t += 7.0) {
        Weather const a = field.at(0, 0, t), b = field.at(0, 0, t + 1.0);
        for (unsigned const pattern : field.patterns()) largest = std::max(largest, std::abs(coverOf(a, pattern) - coverOf(b, pattern)));
    }
    return largest;
}
}  // namespace

TEST(Field, BlendsEachQuantityAmongTheSitesThatKnowItAndIsExactAtASite) {
    Report thermometer = plainReport(0), eye = plainReport(0);
    thermometer.layers.reset();
    thermometer.temperature_c = 10.0;
    eye.temperature_c.reset();
    eye.dew_point_c.reset();
    eye.layers->push_back({Genus::St, 1.0, 700.0, 1100.0});
    eye.speed_mps = 9.0;
    Field const field = fieldOf({siteOf("a", 47.0, 8.0, {thermometer}), siteOf("b", 47.0, 8.5, {eye})}, PlaceWish{47.0, 8.0, 300.0});
    double const apart = core::radians(0.5) * core::kEarthRadius * std::cos(core::radians(47.0));
    for (double const share : {0.0, 0.3, 0.5, 1.0}) {
        Weather const w = field.at(share * apart, 0.0, kStart);
        EXPECT_NEAR(w.temperature, 10.0 + 273.15, 1e-6) << "only one has a thermometer";
        ASSERT_EQ(w.layerCount, 1) << "only one looks up";
        EXPECT_NEAR(w.layers[0].cover, 1.0, 1e-6);
        EXPECT_NEAR(w.layers[0].base, 700.0, 1e-3);
    }
    EXPECT_NEAR(glm::length(field.at(0.0, 0.0, kStart).windSurface), 5.0, 1e-6);
    EXPECT_NEAR(glm::length(field.at(apart, 0.0, kStart).windSurface), 9.0, 1e-6);
    EXPECT_NEAR(glm::length(field.at(0.5 * apart, 0.0, kStart).windSurface), 7.0, 1e-6);
    double const near = 1.0 / (0.25 * 0.25), far = 1.0 / (0.75 * 0.75);
    EXPECT_NEAR(glm::length(field.at(0.25 * apart, 0.0, kStart).windSurface), (5.0 * near + 9.0 * far) / (near + far), 1e-6) << "1/d2";
}

TEST(Field, AMetarSaysNothingOfCirrus) {
    Report metar = plainReport(0), model = plainReport(0);
    metar.layersTo_m = 300.0 + 1524.0;
    model.layers->push_back({Genus::Ci, 0.6, 9000.0, 10000.0});
    Field const field = fieldOf({siteOf("a", 47.0, 8.0, {metar}), siteOf("b", 47.0, 8.5, {model})}, PlaceWish{47.0, 8.0, 300.0});
    Weather const w = field.at(10.0, 0.0, kStart);
    ASSERT_EQ(w.layerCount, 1);
    EXPECT_NEAR(w.layers[0].cover, 0.6, 1e-6) << "the one that sees so high is asked";
}

TEST(Field, MeetsTheReportsAtTheirTimes) {
    Field const field = loadWeather(kBasel);
    Weather const w = field.at(0, 0, utc("2023-06-22T17:30Z"));
    EXPECT_NEAR(glm::length(w.windSurface), 9.3, 1e-9);
    EXPECT_NEAR(w.gust, 22.0, 1e-9);
    EXPECT_NEAR(w.temperature, 16.6 + 273.15, 1e-9);
    EXPECT_NEAR(w.dewPoint, 15.4 + 273.15, 1e-9);
    EXPECT_NEAR(w.pressureSea, 101880.0, 1e-6);
    EXPECT_TRUE(w.thunder);
    EXPECT_EQ(w.precipitation, Precipitation::Rain);
    ASSERT_EQ(w.layerCount, 1);
    EXPECT_EQ(w.layers[0].genus, Genus::Cb);
    EXPECT_NEAR(w.layers[0].cover, 1.0, 1e-6);
}

TEST(Field, TheSumOfEveryTenMinutesOfTheStormIsKept) {
    Field const field = loadWeather(kBasel);
    struct Fall {
        char const* end;
        double sum;
    };
    for (Fall const fall : {Fall{"2023-06-22T17:20Z", 0.2}, {"2023-06-22T17:30Z", 18.2}, {"2023-06-22T17:40Z", 4.5}, {"2023-06-22T17:50Z", 0.5}, {"2023-06-22T17:10Z", 0.0}}) {
        double sum = 0.0;
        for (int i = 0; i < 2400; ++i) sum += field.at(0, 0, utc(fall.end) - 600.0 + (i + 0.5) * 0.25).precipitationRate * 0.25 / kHour;
        EXPECT_NEAR(sum, fall.sum, 0.01 * fall.sum + 1e-9) << fall.end;
    }
}

TEST(Field, AnIntervalShorterThanTheTimeBetweenReportsCountsForItselfAlone) {
    Report a = plainReport(0), b = plainReport(1);
    b.rate_mm_h = 6.0;
    b.precipitationKind = Precipitation::Rain;
    b.interval_s = 600.0;
    Field const field = fieldOf({a, b});
    double sum = 0.0;
    for (int i = 0; i < 6000; ++i) sum += field.at(0, 0, b.time - 600.0 + (i + 0.5) * 0.1).precipitationRate * 0.1 / kHour;
    EXPECT_NEAR(sum, 1.0, 0.01);
}

TEST(Field, WindTurnsThroughNorthAndNotThroughSouth) {
    Report a = plainReport(0), b = plainReport(1);
    a.from_deg = 350.0;
    b.from_deg = 10.0;
    Field const field = fieldOf({a, b});
    glm::dvec2 const middle = field.at(0, 0, kStart + 0.5 * kHour).windSurface;
    EXPECT_NEAR(middle.x, 0.0, 1e-9);
    EXPECT_NEAR(middle.y, -5.0 * std::cos(core::radians(10.0)), 1e-9);
}

TEST(Field, NothingJumpsFromOneSecondToTheNext) {
    for (std::string const& file : {kBasel, kMelbourne}) {
        Field const field = loadWeather(file);
        for (double t = field.start() - 100.0; t < field.end() + 100.0; t += 97.0) {
            // Around the next report, where a jump would be.
            for (double const at : {t, std::ceil(t / 600.0) * 600.0 - 0.5}) {
                Weather const a = field.at(0, 0, at), b = field.at(0, 0, at + 1.0);
                ASSERT_LT(glm::length(a.windSurface - b.windSurface), 0.03) << at;
                ASSERT_LT(std::abs(a.gust - b.gust), 0.3) << at;
                ASSERT_LT(std::abs(a.temperature - b.temperature), 0.03) << at;
                ASSERT_LT(std::abs(a.precipitationRate - b.precipitationRate), 1.5) << at;
                ASSERT_LT(std::abs(std::log(a.visibility / b.visibility)), 0.02) << at;
                ASSERT_LT(std::abs(a.pressureSea - b.pressureSea), 2.0) << at;
            }
        }
        EXPECT_LT(largestCoverStep(field, field.start(), field.end()), 0.01) << file;
    }
}

TEST(Field, ALayerWithoutAPartnerChangesItsCoverAndNeverItsBase) {
    Report a = plainReport(0), b = plainReport(1), c = plainReport(2);
    a.layers = {{Genus::Sc, 0.6, 1000.0, 1500.0}};
    b.layers = {{Genus::Ac, 0.4, 3500.0, 3900.0}};
    c.layers = {{Genus::Ac, 0.4, 3900.0, 4300.0}};
    Field const field = fieldOf({a, b, c});
    for (double h = 0.02; h < 1.0; h += 0.02)
        for (int i = 0, n = field.at(0, 0, kStart + h * kHour).layerCount; i < n; ++i) {
            Layer const layer = field.at(0, 0, kStart + h * kHour).layers[static_cast<std::size_t>(i)];
            EXPECT_EQ(layer.base, layer.genus == Genus::Sc ? 1000.0f : 3500.0f) << h;
        }
    // The pair of the next hour moves from one base to the other.
    Weather const later = field.at(0, 0, kStart + 1.5 * kHour);
    ASSERT_EQ(later.layerCount, 1);
    EXPECT_NEAR(later.layers[0].base, 3700.0, 60.0);
}

TEST(Field, ASkyThatChangesItsGenusStaysAsCovered) {
    Report a = plainReport(0), b = plainReport(1);
    a.layers = {{Genus::Cu, 0.9, 1000.0, 2000.0}};
    b.layers = {{Genus::Sc, 0.9, 1000.0, 1500.0}};
    Field const field = fieldOf({a, b});
    for (double h = 0.0; h <= 1.0; h += 0.05) {
        Weather const w = field.at(0, 0, kStart + h * kHour);
        double gap = 1.0;
        for (int i = 0; i < w.layerCount; ++i) gap *= 1.0 - static_cast<double>(w.layers[static_cast<std::size_t>(i)].cover);
        EXPECT_NEAR(1.0 - gap, 0.9, 0.03) << h;
    }
}

TEST(Field, ALayersPatternStaysAndItsDriftIsTheIntegralOfItsWind) {
    for (std::string const& source : {kBasel, kMelbourne, std::string{"preset:broken"}}) {
        Field const field = loadWeather(source);
        int compared = 0;
        for (double t = field.start() - kHour; t < field.end() + 2 * kHour; t += 1777.0) {
            Weather const before = field.at(0, 0, t - 0.5), now = field.at(0, 0, t), after = field.at(0, 0, t + 0.5);
            if (before.layerCount != now.layerCount || after.layerCount != now.layerCount) continue;
            for (std::size_t i = 0; i < static_cast<std::size_t>(now.layerCount); ++i) {
                EXPECT_EQ(before.layers[i].pattern, now.layers[i].pattern);
                EXPECT_LT(glm::length(after.layers[i].drift - before.layers[i].drift - now.layers[i].wind), 0.02) << source << " " << t;
                EXPECT_NEAR(after.layers[i].phase - before.layers[i].phase, 1.0 / kHour, 1e-9);
                ++compared;
            }
        }
        EXPECT_GT(compared, 2) << source;
    }
}

TEST(Field, TheDriftIsNothingAtTheRecordingsStart) {
    Report a = plainReport(0), b = plainReport(1);
    a.layers = b.layers = {{Genus::Sc, 0.6, 1000.0, 1500.0}};
    Field const field = fieldOf({a, b});
    Weather const start = field.at(0, 0, field.start()), end = field.at(0, 0, field.end());
    ASSERT_EQ(start.layerCount, 1);
    ASSERT_EQ(end.layerCount, 1);
    EXPECT_EQ(glm::length(start.layers[0].drift), 0.0);
    EXPECT_NEAR(glm::length(end.layers[0].drift), kHour * glm::length(end.layers[0].wind), 1.0);
    EXPECT_GT(glm::length(end.layers[0].drift), kHour * 5.0) << "it blows harder up there than below";
    EXPECT_EQ(glm::length(field.boundaryDrift(field.start())), 0.0);
}

TEST(Field, HoldsItsNearestEndOutsideAndSaysSo) {
    Field const field = loadWeather(kMelbourne);
    EXPECT_TRUE(field.covers(field.start()) && field.covers(field.end()));
    EXPECT_FALSE(field.covers(field.start() - 1.0) || field.covers(field.end() + 1.0));
    Weather const end = field.at(0, 0, field.end()), later = field.at(0, 0, field.end() + 1e6);
    EXPECT_EQ(end.temperature, later.temperature);
    EXPECT_EQ(end.windSurface, later.windSurface);
    EXPECT_EQ(end.layerCount, later.layerCount);
    EXPECT_EQ(end.layers[0].cover, later.layers[0].cover);
    EXPECT_EQ(field.at(0, 0, field.start() - 1e6).temperature, field.at(0, 0, field.start()).temperature);
}

TEST(Field, BetweenTwoSitesTheNearerCountsMoreAndNothingJumps) {
    Report cold = plainReport(0), warm = plainReport(0);
    cold.temperature_c = 10.0;
    warm.temperature_c = 20.0;
    cold.layers = {{Genus::Cu, 0.8, 1000.0, 1800.0}};
    Field const field = fieldOf({siteOf("west", 47.0, 8.0, {cold}), siteOf("east", 47.0, 9.0, {warm})});
    double const away = core::radians(1.0) * core::kEarthRadius * std::cos(core::radians(47.0));
    EXPECT_NEAR(field.at(0, 0, kStart).temperature, 283.15, 0.1);
    EXPECT_NEAR(field.at(away, 0, kStart).temperature, 293.15, 0.1);
    EXPECT_NEAR(field.at(away / 2, 0, kStart).temperature, 288.15, 0.01);
    EXPECT_NEAR(field.at(away / 2, 0, kStart).layers[0].cover, 0.4, 0.01);
    for (double x = -20000.0; x < away + 20000.0; x += 500.0)
        EXPECT_LT(std::abs(field.at(x, 0, kStart).temperature - field.at(x + 10.0, 0, kStart).temperature), 0.05);
}

TEST(Field, ThePlaceIsTheFirstSiteOrTheWishWithTheNearestSitesElevation) {
    Field const own = loadWeather(kBasel);
    EXPECT_EQ(own.place().lat_deg, 47.541);
    EXPECT_EQ(own.place().altitude_m, 316.0);
    EXPECT_EQ(loadWeather(kBasel, PlaceWish{46.0, 7.0, {}}).place().altitude_m, 316.0);
    EXPECT_EQ(loadWeather(kBasel, PlaceWish{46.0, 7.0, 1200.0}).place().altitude_m, 1200.0);
}

TEST(Field, WhatNobodyReportedIsListedAsFilled) {
    Report bare;
    bare.time = kStart;
    Field const field = fieldOf({bare});
    Filled const& filled = field.reports()[0][0].filled;
    for (char const* place : {"wind.speed_mps", "wind.gust_mps", "wind.from_deg", "visibility_m", "temperature_c", "dew_point_c", "pressure_hpa",
                              "precipitation.kind", "precipitation.rate_mm_h", "thunder"})
        EXPECT_TRUE(filled.contains(place)) << place;
    EXPECT_EQ(field.at(0, 0, kStart).layerCount, 0);
}

TEST(Field, AMinimumVisibilityIsNotTakenForTheFigure) {
    Report report = plainReport(0);
    report.visibility_m = 10000.0;
    report.visibilityIsMinimum = true;
    report.dew_point_c = -5.0;
    Field const field = fieldOf({report});
    EXPECT_GT(field.at(0, 0, kStart).visibility, 20000.0);
    EXPECT_TRUE(field.reports()[0][0].filled.contains("visibility_m"));
}

TEST(Field, GeneraComeFromCoverByLevelWhereNoLayerWasReported) {
    auto const generaOf = [](double low, double mid, double high, int code, double rate, double cape) {
        Report report = plainReport(0);
        report.time = utc("2023-06-23T11:00Z");
        report.layers.reset();
        report.coverLow = low;
        report.coverMid = mid;
        report.coverHigh = high;
        report.weatherCode = code;
        report.rate_mm_h = rate;
        report.cape_j_kg = cape;
        report.thunder.reset();
        Field const field = fieldOf({report});
        Weather const w = field.at(0, 0, report.time);
        std::vector<Genus> genera;
        for (int i = 0; i < w.layerCount; ++i) genera.push_back(w.layers[static_cast<std::size_t>(i)].genus);
        return genera;
    };
    using enum Genus;
    EXPECT_EQ(generaOf(0.4, 0.0, 0.3, 2, 0.0, 300.0), (std::vector{Cu, Ci}));
    EXPECT_EQ(generaOf(0.9, 0.5, 0.0, 3, 0.0, 0.0), (std::vector{Sc, Ac}));
    EXPECT_EQ(generaOf(0.9, 1.0, 0.9, 63, 2.0, 0.0), (std::vector{Ns, Cs}));
    EXPECT_EQ(generaOf(0.8, 0.9, 1.0, 95, 5.0, 900.0), (std::vector{Cb, As, Cs}));
    EXPECT_EQ(generaOf(0.0, 0.9, 0.0, 3, 0.0, 0.0), (std::vector{As}));
    EXPECT_EQ(generaOf(0.8, 0.0, 0.0, 45, 0.0, 0.0), (std::vector{Fog}));
    EXPECT_EQ(generaOf(0.0, 0.0, 0.0, 0, 0.0, 0.0), (std::vector<Genus>{}));
}

TEST(Field, NoMoreLayersThanAWeatherHoldsAndNoneFlashesWhenTheyChangeRanks) {
    Report a = plainReport(0), b = plainReport(1);
    using enum Genus;
    a.layers = {{St, 0.5, 500.0, 700.0}, {Sc, 0.6, 1200.0, 1600.0}, {Cu, 0.3, 2500.0, 3000.0}, {Ac, 0.4, 4000.0, 4300.0}, {As, 0.2, 5500.0, 6500.0}, {Ci, 0.7, 9000.0, 9900.0}};
    b.layers = {{St, 0.2, 500.0, 700.0}, {Sc, 0.6, 1200.0, 1600.0}, {Cu, 0.4, 2500.0, 3000.0}, {Ac, 0.1, 4000.0, 4300.0}, {As, 0.6, 5500.0, 6500.0}, {Ci, 0.3, 9000.0, 9900.0}};
    Field const field = fieldOf({a, b});
    for (double h = 0.0; h < 1.0; h += 0.01) EXPECT_LE(field.at(0, 0, kStart + h * kHour).layerCount, kMaxLayers);
    EXPECT_LT(largestCoverStep(field, kStart, kStart + kHour), 0.01);
}

TEST(Field, ReportsInTheShapeOfAReportWhatItUsesBetweenTwo) {
    Field const field = loadWeather(kBasel);
    FieldReport const between = field.reportAt(0, field.instant(utc("2023-06-23T18:45Z")));
    EXPECT_TRUE(between.said.temperature_c && between.said.pressure_hpa && between.said.speed_mps);
    EXPECT_FALSE(between.said.visibility_m);
    EXPECT_TRUE(between.filled.contains("visibility_m"));
    ASSERT_TRUE(between.said.layers && between.said.layers->size() == 1);
    EXPECT_FALSE((*between.said.layers)[0].base_m);
    EXPECT_EQ(std::get<std::string>(between.filled.at("layers[0].genus")), "Cu");
    EXPECT_NEAR(std::get<double>(between.filled.at("layers[0].cover")), 0.13, 0.02);
    FieldReport const seen = field.reportAt(0, field.instant(utc("2023-06-23T17:50Z")));
    EXPECT_EQ((*seen.said.layers)[0].genus, Genus::Cu);
    EXPECT_NEAR(*(*seen.said.layers)[0].cover, 0.125, 1e-6);
}

TEST(Field, ThePresetsAreWhatTheirNamesSay) {
    ASSERT_EQ(presetNames().size(), 10u);
    for (PresetName const& name : presetNames()) {
        Field const field = loadWeather("preset:" + std::string{name.name});
        Weather const w = field.at(0, 0, utc("2023-06-23T12:00Z"));
        EXPECT_TRUE(field.covers(0.0));
        EXPECT_EQ(field.place().lat_deg, 47.541);
        for (int i = 1; i < w.layerCount; ++i) EXPECT_GE(w.layers[static_cast<std::size_t>(i)].base, w.layers[static_cast<std::size_t>(i - 1)].base);
    }
    Weather const calm = loadWeather("preset:calm").at(0, 0, 0.0), storm = loadWeather("preset:storm").at(0, 0, 0.0);
    EXPECT_EQ(calm.layerCount, 0);
    EXPECT_EQ(calm.gust, 0.0);
    EXPECT_TRUE(storm.thunder && storm.precipitationRate > 10.0 && storm.layers[0].genus == Genus::Cb);
    EXPECT_EQ(loadWeather("preset:overcast").at(0, 0, 0.0).layers[0].cover, 1.0f);
}

TEST(Field, UnknownSourcesAreAnsweredInOneLine) {
    for (char const* source : {"live", "preset:nice", "preset:", "recorded:", "recorded:/nowhere/at/all.json", ""}) {
        try {
            loadWeather(source);
            ADD_FAILURE() << source << " was taken";
        } catch (core::Error const& error) {
            EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos);
        }
    }
}

TEST(Field, TheStripNamesSourceModeAndAge) {
    Field const field = loadWeather(kBasel);
    EXPECT_EQ(field.strip(utc("2023-06-23T18:47Z")), "Basel, 21-23 June 2023 · recorded · report 7 min old");
    EXPECT_EQ(field.age(utc("2023-06-23T18:47Z")), 420.0);
    EXPECT_EQ(loadWeather("preset:fair").strip(0.0), "preset:fair");
}
