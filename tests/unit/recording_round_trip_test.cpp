// Any source -> a recording's text -> the same recording, field by field, to the 6 decimals of the file.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/presets.h"
#include "engine/weather/source.h"
#include "tests/unit/grib_maker.h"
#include "tests/unit/source_files.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
constexpr double kDecimals = 0.6e-6;

void same(std::optional<double> once, std::optional<double> again, std::string const& what) {
    ASSERT_EQ(once.has_value(), again.has_value()) << what;
    if (once) {
        EXPECT_NEAR(*once, *again, kDecimals) << what;
    }
}

void sameLayers(Report const& once, Report const& again, std::string const& what) {
    ASSERT_EQ(once.layers.has_value(), again.layers.has_value()) << what;
    if (!once.layers) return;
    ASSERT_EQ(once.layers->size(), again.layers->size()) << what;
    for (std::size_t i = 0; i < once.layers->size(); ++i) {
        ReportedLayer const &a = (*once.layers)[i], &b = (*again.layers)[i];
        EXPECT_EQ(a.genus, b.genus) << what;
        same(a.cover, b.cover, what + " cover");
        same(a.base_m, b.base_m, what + " base");
        same(a.top_m, b.top_m, what + " top");
    }
}

void sameLevels(Report const& once, Report const& again, std::string const& what) {
    ASSERT_EQ(once.levels.size(), again.levels.size()) << what;
    for (std::size_t i = 0; i < once.levels.size(); ++i) {
        ReportedLevel const &a = once.levels[i], &b = again.levels[i];
        EXPECT_NEAR(a.altitude_m, b.altitude_m, kDecimals) << what;
        same(a.temperature_c, b.temperature_c, what + " level's temperature");
        same(a.dew_point_c, b.dew_point_c, what + " level's dew point");
        same(a.speed_mps, b.speed_mps, what + " level's speed");
        same(a.from_deg, b.from_deg, what + " level's direction");
        same(a.cover, b.cover, what + " level's cover");
    }
}

void sameFilled(Report const& once, Report const& again, std::string const& what) {
    ASSERT_EQ(once.filled.size(), again.filled.size()) << what;
    for (auto const& [place, value] : once.filled) {
        ASSERT_TRUE(again.filled.contains(place)) << what << " " << place;
        FilledValue const& other = again.filled.at(place);
        ASSERT_EQ(value.index(), other.index()) << what << " " << place;
        if (auto const* number = std::get_if<double>(&value)) {
            EXPECT_NEAR(*number, std::get<double>(other), kDecimals) << what << " " << place;
        } else {
            EXPECT_EQ(value, other) << what << " " << place;
        }
    }
}

void sameReport(Report const& a, Report const& b, std::string const& what) {
    EXPECT_EQ(a.time, b.time) << what;
    same(a.speed_mps, b.speed_mps, what + " speed");
    same(a.gust_mps, b.gust_mps, what + " gust");
    same(a.from_deg, b.from_deg, what + " direction");
    same(a.visibility_m, b.visibility_m, what + " visibility");
    EXPECT_EQ(a.visibilityIsMinimum, b.visibilityIsMinimum) << what;
    same(a.verticalVisibility_m, b.verticalVisibility_m, what + " vertical visibility");
    same(a.temperature_c, b.temperature_c, what + " temperature");
    same(a.dew_point_c, b.dew_point_c, what + " dew point");
    same(a.pressure_hpa, b.pressure_hpa, what + " pressure");
    EXPECT_EQ(a.precipitationKind, b.precipitationKind) << what;
    same(a.rate_mm_h, b.rate_mm_h, what + " rate");
    EXPECT_EQ(a.thunder, b.thunder) << what;
    sameLayers(a, b, what);
    same(a.layersTo_m, b.layersTo_m, what + " layers to");
    same(a.interval_s, b.interval_s, what + " interval");
    sameLevels(a, b, what);
    same(a.coverLow, b.coverLow, what + " low");
    same(a.coverMid, b.coverMid, what + " mid");
    same(a.coverHigh, b.coverHigh, what + " high");
    same(a.coverTotal, b.coverTotal, what + " total");
    EXPECT_NEAR(a.coverBounds.low_m, b.coverBounds.low_m, kDecimals) << what;
    EXPECT_NEAR(a.coverBounds.mid_m, b.coverBounds.mid_m, kDecimals) << what;
    same(a.cape_j_kg, b.cape_j_kg, what + " energy");
    same(a.freezingLevel_m, b.freezingLevel_m, what + " freezing level");
    same(a.snowDepth_m, b.snowDepth_m, what + " snow");
    same(a.radiation_w_m2, b.radiation_w_m2, what + " radiation");
    same(a.longwave_w_m2, b.longwave_w_m2, what + " long-wave");
    EXPECT_EQ(a.weatherCode, b.weatherCode) << what;
    sameFilled(a, b, what);
}

/// How many values were compared: reports, so that no test passes on nothing.
std::size_t sameAgain(Recording const& once) {
    Recording const again = parseRecording(recordingText(once), "again");
    EXPECT_EQ(once.name, again.name);
    EXPECT_EQ(once.source, again.source);
    EXPECT_EQ(once.licence, again.licence);
    EXPECT_TRUE(again.unknownKeys.empty());
    EXPECT_EQ(once.sites.size(), again.sites.size());
    std::size_t reports = 0;
    for (std::size_t i = 0; i < std::min(once.sites.size(), again.sites.size()); ++i) {
        Site const &a = once.sites[i], &b = again.sites[i];
        EXPECT_EQ(a.name, b.name);
        same(a.lat_deg, b.lat_deg, a.name);
        same(a.lon_deg, b.lon_deg, a.name);
        same(a.elevation_m, b.elevation_m, a.name);
        EXPECT_EQ(a.reports.size(), b.reports.size());
        for (std::size_t k = 0; k < std::min(a.reports.size(), b.reports.size()); ++k, ++reports)
            sameReport(a.reports[k], b.reports[k], a.name + " " + core::formatUtc(a.reports[k].time));
    }
    return reports;
}

std::string const kOpenMeteo =
    R"({"latitude":47.5,"longitude":7.5,"elevation":300,"generationtime_ms":1,"hourly_units":{"temperature_2m":"°F","wind_speed_10m":"km/h","wind_direction_10m":"°",
        "surface_pressure":"hPa","precipitation":"mm","snowfall":"cm","visibility":"ft","cloud_cover_low":"%","weather_code":"wmo code","wind_speed_850hPa":"kn",
        "wind_direction_850hPa":"°","relative_humidity_850hPa":"%","temperature_850hPa":"°F","geopotential_height_850hPa":"m"},
        "hourly":{"time":[1705395600,1705399200],"temperature_2m":[33,34],"wind_speed_10m":[11,0],"wind_direction_10m":[123,200],"surface_pressure":[978.3,null],
        "precipitation":[0.7,0],"snowfall":[0.49,0],"visibility":[79199.475,1234],"cloud_cover_low":[33,null],"weather_code":[73,3],"wind_speed_850hPa":[17,18],
        "wind_direction_850hPa":[210,211],"relative_humidity_850hPa":[71,0],"temperature_850hPa":[20,21],"geopotential_height_850hPa":[1450.5,1451.5]}})";

std::string gribOfEverything() {
    std::string bytes;
    auto const add = [&](int category, int number, int surface, double level, double value, int statistic = -1) {
        tests::GribMaker maker;
        maker.category = category, maker.number = number, maker.surface = surface, maker.level = level, maker.statistic = statistic;
        maker.values = {value, value, value, value * 1.001, value, value, value, value * 0.999, std::nullopt};
        bytes += maker.message();
    };
    add(0, 0, 103, 2, 288.17), add(1, 1, 103, 2, 63.0), add(2, 2, 103, 10, 3.3), add(2, 3, 103, 10, -4.7), add(3, 0, 1, 0, 97000.0),
        add(3, 5, 1, 0, 333.0);
    add(6, 1, 214, 0, 41.0, 0), add(6, 1, 224, 0, 13.0, 0), add(6, 1, 234, 0, 77.0, 0), add(3, 0, 212, 0, 90123.0, 0), add(3, 0, 213, 0, 85001.0, 0);
    add(1, 8, 1, 0, 7.0, 1), add(1, 192, 1, 0, 1.0, 0), add(3, 5, 100, 70000, 3100.0), add(0, 0, 100, 70000, 271.0), add(2, 2, 100, 70000, 20.0),
        add(2, 3, 100, 70000, 1.0);
    return bytes;
}
}  // namespace

TEST(RoundTrip, EverySourceIsTheSameAfterItWasSavedAsARecording) {
    SourceContext const context{.place = PlaceWish{47.2, 7.9, {}}};
    EXPECT_EQ(sameAgain(parseSource(kOpenMeteo, "x", context)), 2u);
    EXPECT_EQ(sameAgain(parseSource(gribOfEverything(), "x", context)), 9u);
    EXPECT_EQ(
        sameAgain(parseSource(
            R"({"metadata":{"modelrun_utc":"","latitude":49.19523,"longitude":16.60812,"height":226,"utc_timeoffset":2},"units":{"temperature":"F",
        "windspeed":"kn","precipitation":"inch"},"data_1h":{"time":["2026-04-20 00:00"],"temperature":[51.3],"relativehumidity":[77],"windspeed":[7],"precipitation":[0.03],
        "snowfraction":[0.5],"pictocode":[27],"lowclouds":[33]}})",
            "x", context)),
        1u);
    EXPECT_EQ(
        sameAgain(parseSource(
            "nat_abbr;termin;dkl010z0;fu3010z0;prestas0;rre150z0;tre200s0;ure200s0\nBAS;20230621000000;194;1.4;978.3;0.1;19.6;89.1\n", "x", context)),
        1u);
    EXPECT_EQ(sameAgain(parseSource("termin_utc,okta_nto,genus_cc1_wmo0500,vis_vho_wmo4377,ww_wmo4677\n20230622174000,7,9,15,95\n", "x", context)),
              1u);
    for (PresetName const& preset : presetNames())
        EXPECT_EQ(sameAgain(*presetRecording(preset.name, {})), presetRecording(preset.name, {})->sites[0].reports.size());
}

TEST(RoundTrip, TheRealFilesAreTheSameAfterTheyWereSavedAsRecordings) {
    struct Case {
        char const* file;
        std::size_t reports;
    };
    if (!std::filesystem::exists(tests::sharedWeather(LUFTPOST_SOURCE_DIR, "README.md"))) GTEST_SKIP() << "no real files beside the repo";
    for (Case const one : {Case{"open-meteo/melbourne_2024-01-16_hourly_cold_front_thunderstorm.json", 24},
                           {"open-meteo/multi_location_array_cities_2024-01-26.json", 2880},
                           {"meteoblue/brno_2026-04-20_basic-1h.json", 169},
                           {"meteoswiss/BAS_10min_2023-06-21_23_thunderstorm_front.csv", 432},
                           {"meteoswiss/BAS_observer_2023-01_07.csv", 288},
                           {"meteoswiss/radiosounding_PAY_2023-06-19_00Z.csv", 1},
                           {"grib/gfs_clouds_subset.grib2", 9}}) {
        auto const file = tests::sharedWeather(LUFTPOST_SOURCE_DIR, one.file);
        EXPECT_EQ(sameAgain(parseSource(core::readFile(file), file.string(), {.place = PlaceWish{47.5, 7.5, {}}})), one.reports) << file;
    }
}

namespace {
/// Both say it and agree to `tolerance`, or neither says it. Counts those that both say.
std::size_t agrees(std::optional<double> a, std::optional<double> b, double tolerance, std::string const& what) {
    EXPECT_EQ(a.has_value(), b.has_value()) << what;
    if (!a || !b) return 0;
    EXPECT_NEAR(*a, *b, tolerance) << what;
    return 1;
}

Recording bundled(std::string const& name) { return readRecording(std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/" + name); }
}  // namespace

TEST(RoundTrip, TheBundledDaysHoldTheFiguresThatTheDecodersReadInTheProvidersFiles) {
    auto const melbourne = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "open-meteo/melbourne_2024-01-16_hourly_cold_front_thunderstorm.json");
    auto const basel = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "meteoswiss/BAS_10min_2023-06-21_23_thunderstorm_front.csv");
    if (!std::filesystem::exists(melbourne)) GTEST_SKIP() << melbourne;
    std::size_t compared = 0;
    auto const compare = [&](Report const& read, Report const& kept) {
        std::string const what = core::formatUtc(read.time);
        EXPECT_EQ(read.time, kept.time);
        compared += agrees(read.speed_mps, kept.speed_mps, 0.0051, what + " speed") + agrees(read.gust_mps, kept.gust_mps, 0.0051, what + " gust") +
                    agrees(read.temperature_c, kept.temperature_c, 1e-6, what + " temperature") +
                    agrees(read.pressure_hpa, kept.pressure_hpa, 1e-6, what + " pressure") +
                    agrees(read.dew_point_c, kept.dew_point_c, 1e-6, what + " dew point") +
                    agrees(read.rate_mm_h, kept.rate_mm_h, 0.0051, what + " rate") + agrees(read.from_deg, kept.from_deg, 1e-6, what + " direction");
    };
    Site const read = parseSource(core::readFile(melbourne), "m", contextOfNow()).sites[0], kept = bundled("melbourne_2024-01-16.json").sites[0];
    ASSERT_EQ(read.reports.size(), kept.reports.size());
    for (std::size_t i = 0; i < read.reports.size(); ++i) {
        Report const &a = read.reports[i], &b = kept.reports[i];
        compare(a, b);
        std::string const what = core::formatUtc(a.time);
        compared += agrees(a.coverLow, b.coverLow, 0.0051, what) + agrees(a.coverMid, b.coverMid, 0.0051, what) +
                    agrees(a.coverHigh, b.coverHigh, 0.0051, what) + agrees(a.visibility_m, b.visibility_m, 1e-6, what) +
                    agrees(a.cape_j_kg, b.cape_j_kg, 1e-6, what) + agrees(a.freezingLevel_m, b.freezingLevel_m, 1e-6, what) +
                    agrees(a.snowDepth_m, b.snowDepth_m, 1e-6, what);
        EXPECT_EQ(a.visibilityIsMinimum, b.visibilityIsMinimum) << what;
        EXPECT_EQ(a.precipitationKind == Precipitation::None, b.precipitationKind == Precipitation::None) << what;
        EXPECT_EQ(a.weatherCode, b.weatherCode) << what;
        EXPECT_EQ(a.thunder, b.thunder) << what;
        ASSERT_EQ(a.levels.size(), b.levels.size()) << what;
        for (std::size_t k = 0; k < a.levels.size(); ++k) {
            EXPECT_EQ(a.levels[k].altitude_m, b.levels[k].altitude_m);
            compared +=
                agrees(a.levels[k].speed_mps, b.levels[k].speed_mps, 0.0051, what) + agrees(a.levels[k].from_deg, b.levels[k].from_deg, 1e-6, what);
        }
    }
    Site const measured = parseSource(core::readFile(basel), "b", contextOfNow()).sites[0], day = bundled("basel_2023-06-21_23.json").sites[0];
    ASSERT_EQ(measured.reports.size(), day.reports.size());
    for (std::size_t i = 0; i < measured.reports.size(); ++i) compare(measured.reports[i], day.reports[i]);
    EXPECT_GT(compared, 3000u);
}
