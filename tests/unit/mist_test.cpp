// Mist in valleys: what calm, nearly saturated air is by night and at dawn, where no report says otherwise.
#include <gtest/gtest.h>

#include "engine/core/time.h"
#include "engine/weather/fill.h"
#include "engine/weather/source.h"

namespace {
using namespace luftpost;
using namespace luftpost::weather;

/// An autumn dawn at Basel, sun 4 degrees up.
Site dawn() {
    Report report;
    report.time = *core::parseUtc("2023-10-10T06:10Z");
    report.speed_mps = 0.7;
    report.from_deg = 90.0;
    report.temperature_c = 6.0;
    report.dew_point_c = 5.7;
    report.pressure_hpa = 1024.0;
    report.precipitationKind = Precipitation::None;
    report.rate_mm_h = 0.0;
    report.coverLow = 0.0;
    report.coverMid = 0.0;
    report.coverHigh = 0.3;
    Site site;
    site.name = "dawn";
    site.lat_deg = 47.5;
    site.lon_deg = 7.6;
    site.elevation_m = 316.0;
    site.reports.push_back(report);
    return site;
}

double mist(Site const& site) {
    double cover = 0.0;
    for (FullLayer const& layer : fullReports(site)[0].layers)
        if (layer.genus == Genus::Fog) cover = layer.cover;
    return cover;
}
}  // namespace

TEST(Mist, FillsTheValleysOfACalmClearDawn) {
    FullReport const full = fullReports(dawn())[0];
    ASSERT_EQ(full.layers.size(), 2u);
    FullLayer const& layer = full.layers[1];
    EXPECT_EQ(layer.genus, Genus::Fog);
    EXPECT_GT(layer.cover, 0.3);
    EXPECT_LT(layer.base, 316.0) << "where the land is lower than the site";
    EXPECT_GT(layer.top, 316.0);
    EXPECT_LT(layer.top, 316.0 + 150.0) << "hills stand out of it";
    EXPECT_TRUE(full.filled.contains("layers[1].genus")) << "it is said that nobody said so";
}

TEST(Mist, NeedsCalmSaturatedAirANightSkyAndNobodyWhoSaysOtherwise) {
    double const usual = mist(dawn());
    auto const with = [](auto const& change) {
        Site site = dawn();
        change(site.reports[0]);
        return mist(site);
    };
    EXPECT_EQ(with([](Report& r) { r.speed_mps = 5.0; }), 0.0);
    EXPECT_EQ(with([](Report& r) { r.dew_point_c = 3.0; }), 0.0);
    EXPECT_EQ(with([](Report& r) { r.time = *core::parseUtc("2023-10-10T11:30Z"); }), 0.0) << "the sun has dissolved it";
    EXPECT_EQ(with([](Report& r) { r.coverLow = 1.0; }), 0.0) << "under cloud the ground does not cool";
    EXPECT_EQ(with([](Report& r) { r.precipitationKind = Precipitation::Rain, r.rate_mm_h = 1.0; }), 0.0);
    EXPECT_EQ(with([](Report& r) { r.visibility_m = 20000.0; }), 0.0);
    EXPECT_EQ(with([](Report& r) { r.layers.emplace(); }), 0.0) << "an observer saw none";
    EXPECT_LT(with([](Report& r) { r.speed_mps = 2.0; }), usual);
    EXPECT_LT(with([](Report& r) { r.dew_point_c = 5.0; }), usual);
}

TEST(Snow, LiesWhereTheReportSaysSo) {
    EXPECT_NEAR(loadWeather("preset:snow").at(0.0, 0.0, *core::parseUtc("2023-01-20T10:30Z")).snowDepth, 0.25, 1e-9);
    EXPECT_EQ(loadWeather("preset:fair").at(0.0, 0.0, *core::parseUtc("2023-01-20T10:30Z")).snowDepth, 0.0);
}
