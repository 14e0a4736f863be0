#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/grib.h"
#include "engine/weather/grib_values.h"
#include "engine/weather/source.h"
#include "tests/unit/grib_maker.h"
#include "tests/unit/grib_repack.h"
#include "tests/unit/source_files.h"

using namespace luftpost;
using namespace luftpost::weather;
using tests::GribMaker;

namespace {
constexpr PlaceWish kMiddle{47.0, 8.0, {}};

Recording parsed(std::string const& bytes, std::optional<PlaceWish> const& place = kMiddle) { return parseGrib(bytes, "model.grib2", place); }
Report firstReport(std::string const& bytes) { return parsed(bytes).sites.at(0).reports.at(0); }

/// A field of one value everywhere.
std::string uniform(int category, int number, int surface, double level, double value, int hour = 6, int statistic = -1, int fromHour = 0) {
    GribMaker maker;
    maker.category = category, maker.number = number, maker.surface = surface, maker.level = level;
    maker.hour = hour, maker.statistic = statistic, maker.fromHour = fromHour;
    maker.values = {value};
    return maker.message();
}
std::string temperature(std::vector<std::optional<double>> const& values) {
    GribMaker maker;
    maker.values = values;
    return maker.message();
}
}  // namespace

TEST(Grib, TheSurfaceHoldsWhatTheFieldsSay) {
    Report const r =
        firstReport(uniform(0, 0, 103, 2, 288.15) + uniform(0, 6, 103, 2, 283.15) + uniform(2, 2, 103, 10, 3.0) + uniform(2, 3, 103, 10, 4.0) +
                    uniform(2, 22, 1, 0, 9.0) + uniform(3, 1, 101, 0, 101500.0) + uniform(6, 1, 10, 0, 75.0) + uniform(6, 1, 214, 0, 40.0) +
                    uniform(6, 1, 224, 0, 50.0) + uniform(6, 1, 234, 0, 60.0) + uniform(19, 0, 1, 0, 8000.0) + uniform(7, 6, 1, 0, 650.0) +
                    uniform(3, 5, 4, 0, 3100.0) + uniform(1, 11, 1, 0, 0.25));
    EXPECT_EQ(r.time, *core::parseUtc("2023-06-22T06:00Z"));
    EXPECT_NEAR(*r.temperature_c, 15.0, 1e-3);
    EXPECT_NEAR(*r.dew_point_c, 10.0, 1e-3);
    EXPECT_NEAR(*r.speed_mps, 5.0, 1e-3);
    EXPECT_NEAR(*r.from_deg, 216.87, 0.05) << "it goes to 3 east, 4 north";
    EXPECT_NEAR(*r.gust_mps, 9.0, 1e-3);
    EXPECT_NEAR(*r.pressure_hpa, 1015.0, 0.02);
    EXPECT_NEAR(*r.coverTotal, 0.75, 1e-4);
    EXPECT_NEAR(*r.coverLow, 0.4, 1e-4);
    EXPECT_NEAR(*r.coverMid, 0.5, 1e-4);
    EXPECT_NEAR(*r.coverHigh, 0.6, 1e-4);
    EXPECT_EQ(r.coverBounds.low_m, 3690.0);
    EXPECT_NEAR(*r.visibility_m, 8000.0, 1.0);
    EXPECT_FALSE(r.visibilityIsMinimum);
    EXPECT_NEAR(*r.cape_j_kg, 650.0, 0.1);
    EXPECT_NEAR(*r.freezingLevel_m, 3100.0, 0.1);
    EXPECT_NEAR(*r.snowDepth_m, 0.25, 1e-4);
    EXPECT_FALSE(r.rate_mm_h || r.layers || r.thunder);
    EXPECT_TRUE(firstReport(uniform(19, 0, 1, 0, 24135.0)).visibilityIsMinimum) << "15 miles is where GFS ends";
}

TEST(Grib, ThePlaceIsBilinearAndTheGridAroundItAreSites) {
    std::string const bytes = temperature({280, 281, 282, 283, 284, 285, 286, 287, 288});
    Recording const middle = parsed(bytes, PlaceWish{47.25, 7.4, {}});
    EXPECT_NEAR(*middle.sites.at(0).reports[0].temperature_c, 280.0 + 0.75 * 3.0 + 0.4 - 273.15, 1e-3);
    EXPECT_EQ(middle.sites.size(), 7u) << "the place, and six of nine points: the nearest is in the first column";
    Recording const point = parsed(bytes, kMiddle);
    ASSERT_EQ(point.sites.size(), 9u) << "the place is a point of the grid";
    EXPECT_NEAR(*point.sites[0].reports[0].temperature_c, 284.0 - 273.15, 1e-3);
    for (Site const& site : point.sites)
        EXPECT_NEAR(*site.reports[0].temperature_c, 280.0 + (48.0 - *site.lat_deg) * 3.0 + (*site.lon_deg - 7.0) - 273.15, 1e-3) << site.name;
}

TEST(Grib, AGridAroundTheEarthHasNoEdge) {
    GribMaker maker;
    maker.columns = 4, maker.rows = 3, maker.lat0 = 90.0, maker.latStep = -90.0, maker.lon0 = 0.0, maker.lonStep = 90.0;
    maker.values = {280, 280, 280, 280, 270, 280, 290, 300, 280, 280, 280, 280};
    EXPECT_NEAR(*parsed(maker.message(), PlaceWish{0.0, -45.0, {}}).sites[0].reports[0].temperature_c, 285.0 - 273.15, 1e-3)
        << "between 300 at 270 and 270 at 0 E";
    EXPECT_NEAR(*parsed(maker.message(), PlaceWish{0.0, 180.0, {}}).sites[0].reports[0].temperature_c, 290.0 - 273.15, 1e-3);
    EXPECT_NEAR(*parsed(maker.message(), PlaceWish{45.0, 0.0, {}}).sites[0].reports[0].temperature_c, 275.0 - 273.15, 1e-3);
}

TEST(Grib, AHoleIsUnknownAndNeverAFigure) {
    auto const hole = std::nullopt;
    std::string const bytes = temperature({280, 281, 282, 283, hole, 285, 286, 287, 288}) + uniform(7, 6, 1, 0, 100.0);
    EXPECT_FALSE(parsed(bytes, kMiddle).sites[0].reports[0].temperature_c);
    EXPECT_NEAR(*parsed(bytes, PlaceWish{47.9, 7.1, {}}).sites[0].reports[0].temperature_c, 280.0 - 273.15, 1e-3) << "the nearest point is known";
}

TEST(Grib, SumsAndMeansFromTheRunsStartBecomeThoseOfTheirOwnStep) {
    // Three hours and then six, as GFS has them: 3 mm, then 9 mm in all.
    std::string const bytes = uniform(1, 8, 1, 0, 3.0, 3, 1, 0) + uniform(1, 8, 1, 0, 9.0, 6, 1, 0) + uniform(4, 192, 1, 0, 100.0, 3, 0, 0) +
                              uniform(4, 192, 1, 0, 250.0, 6, 0, 0);
    auto const reports = parsed(bytes).sites[0].reports;
    ASSERT_EQ(reports.size(), 2u);
    EXPECT_NEAR(*reports[0].rate_mm_h, 1.0, 1e-3);
    EXPECT_NEAR(*reports[1].rate_mm_h, 2.0, 1e-3);
    EXPECT_EQ(reports[1].interval_s, 10800.0);
    EXPECT_NEAR(*reports[1].radiation_w_m2, 400.0, 0.1);
    auto const mean = firstReport(uniform(1, 7, 1, 0, 1.0 / 1024.0, 6, 0, 0));
    EXPECT_NEAR(*mean.rate_mm_h, 3.516, 0.01) << "kilograms a second";
    EXPECT_EQ(mean.interval_s, 21600.0);
}

TEST(Grib, TheKindOfWhatFellIsTheModels) {
    std::string const rate = uniform(1, 7, 1, 0, 1.0 / 1024.0, 6, 0, 0);
    EXPECT_EQ(firstReport(rate).precipitationKind, std::nullopt);
    EXPECT_EQ(firstReport(rate + uniform(1, 192, 1, 0, 1.0, 6, 0, 0)).precipitationKind, Precipitation::Rain);
    EXPECT_EQ(firstReport(rate + uniform(1, 195, 1, 0, 1.0, 6, 0, 0)).precipitationKind, Precipitation::Snow);
    EXPECT_EQ(firstReport(rate + uniform(1, 193, 1, 0, 1.0, 6, 0, 0)).precipitationKind, Precipitation::FreezingRain);
    EXPECT_EQ(firstReport(uniform(1, 7, 1, 0, 0.0, 6, 0, 0)).precipitationKind, Precipitation::None);
}

TEST(Grib, AnInstantOfCoverComesBeforeAMeanAndMeansMeetAtTheirCommonTime) {
    std::string const means = uniform(6, 1, 214, 0, 20.0, 3, 0, 0) + uniform(6, 1, 214, 0, 60.0, 6, 0, 3);
    auto const reports = parsed(means).sites[0].reports;
    EXPECT_NEAR(*reports[0].coverLow, 0.4, 1e-3) << "between the step before and the step after";
    EXPECT_NEAR(*reports[1].coverLow, 0.6, 1e-3);
    EXPECT_NEAR(*parsed(means + uniform(6, 1, 214, 0, 90.0, 3)).sites[0].reports[0].coverLow, 0.9, 1e-3);
}

TEST(Grib, BasesAndTopsMakeLayers) {
    Report const r = firstReport(uniform(6, 1, 214, 0, 50.0, 6, 0, 0) + uniform(6, 1, 224, 0, 0.0, 6, 0, 0) + uniform(6, 1, 234, 0, 25.0, 6, 0, 0) +
                                 uniform(3, 0, 212, 0, 90000.0, 6, 0, 0) + uniform(3, 0, 213, 0, 80000.0, 6, 0, 0));
    ASSERT_TRUE(r.layers);
    ASSERT_EQ(r.layers->size(), 2u);
    EXPECT_FALSE((*r.layers)[0].genus);
    EXPECT_NEAR(*(*r.layers)[0].base_m, 988.0, 3.0) << "900 hPa in the standard atmosphere";
    EXPECT_NEAR(*(*r.layers)[0].top_m, 1949.0, 3.0) << "800 hPa";
    EXPECT_NEAR(*(*r.layers)[1].cover, 0.25, 1e-3);
    EXPECT_FALSE((*r.layers)[1].base_m);
}

TEST(Grib, PressureLevelsBecomeHeights) {
    Report const r = firstReport(uniform(3, 5, 1, 0, 400.0) + uniform(3, 5, 100, 85000, 1500.0) + uniform(0, 0, 100, 85000, 283.15) +
                                 uniform(1, 1, 100, 85000, 50.0) + uniform(2, 2, 100, 85000, -10.0) + uniform(2, 3, 100, 85000, 0.0) +
                                 uniform(6, 1, 100, 85000, 30.0) + uniform(3, 5, 100, 100000, 110.0) + uniform(0, 0, 100, 100000, 290.0) +
                                 uniform(2, 2, 103, 80, 7.0) + uniform(2, 3, 103, 80, 0.0));
    ASSERT_EQ(r.levels.size(), 2u) << "1000 hPa is under the ground at 400 m";
    EXPECT_NEAR(r.levels[0].altitude_m, 480.0, 0.1);
    EXPECT_NEAR(*r.levels[0].from_deg, 270.0, 0.1);
    EXPECT_NEAR(r.levels[1].altitude_m, 1500.0, 0.1);
    EXPECT_NEAR(*r.levels[1].temperature_c, 10.0, 1e-3);
    EXPECT_NEAR(*r.levels[1].dew_point_c, 0.06, 0.02);
    EXPECT_NEAR(*r.levels[1].from_deg, 90.0, 0.1);
    EXPECT_NEAR(*r.levels[1].cover, 0.3, 1e-3);
}

TEST(Grib, IconsLevelsOfCloudMeetAtItsOwnPressures) {
    auto const between = [](int first, double low, int second, double high, double value) {
        GribMaker maker;
        maker.centre = 78, maker.category = 6, maker.number = 22;
        maker.surface = first, maker.level = low, maker.secondSurface = second, maker.secondLevel = high;
        maker.values = {value};
        return maker.message();
    };
    Report const r = firstReport(between(100, 80000, 1, 0, 30) + between(100, 40000, 100, 80000, 50) + between(100, 0, 100, 40000, 70));
    EXPECT_NEAR(*r.coverLow, 0.3, 1e-3);
    EXPECT_NEAR(*r.coverMid, 0.5, 1e-3);
    EXPECT_NEAR(*r.coverHigh, 0.7, 1e-3);
    EXPECT_EQ(r.coverBounds.low_m, 1950.0);
}

TEST(Grib, WithoutAPlaceThePointNearestToBaselIsTakenAndSaid) {
    Recording const recording = parsed(uniform(0, 0, 103, 2, 288.15), std::nullopt);
    EXPECT_NEAR(*recording.sites[0].lat_deg, 48.0, 1e-9);
    EXPECT_NEAR(*recording.sites[0].lon_deg, 8.0, 1e-9);
    EXPECT_NE(recording.name.find("no place was asked for"), std::string::npos) << recording.name;
    EXPECT_NE(recording.name.find("NCEP run of 2023-06-22T00Z"), std::string::npos) << recording.name;
}

TEST(Grib, BadFilesAreAnsweredWithMessageAndByteInOneLine) {
    std::string const good = uniform(0, 0, 103, 2, 288.15);
    auto const changed = [&](std::size_t octet, char value) {
        std::string bytes = good;
        bytes[octet] = value;
        return bytes;
    };
    std::size_t const grid = 16 + 21, product = grid + 72, packing = product + 34;
    struct Case {
        std::string bytes, part;
    };
    std::vector<Case> const cases{
        {good.substr(0, 100), "expected a message of"},
        {good + "GRI", "message 2 at byte"},
        {good + good.substr(0, good.size() - 1), "message 2 at byte"},
        {changed(7, 1), "edition 2"},
        {changed(good.size() - 1, '8'), "7777"},
        {changed(19, 7), "section"},
        {changed(grid + 13, 30), "template 30"},
        {changed(grid + 33, 9), "grid"},
        {changed(packing + 8, 5), "expected 9 values"},
        {changed(packing + 10, 41), "template"},
        {changed(packing + 19, 40), "bits"},
        {uniform(0, 0, 103, 500, 288.15), "expected a value at the place"},
        {uniform(0, 17, 1, 0, 1.0), "at least one field"},
        {uniform(0, 6, 103, 2, 273.0).substr(0, 16), "message"},
    };
    for (Case const& one : cases) {
        std::string const complaint = tests::complaintOf([&] { parsed(one.bytes); });
        EXPECT_NE(complaint.find(one.part), std::string::npos) << complaint << "\nshould say " << one.part;
        EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
        EXPECT_TRUE(complaint.starts_with("model.grib2: ")) << complaint;
    }
    EXPECT_NE(tests::complaintOf([&] {
                  parsed(good, PlaceWish{10.0, 10.0, {}});
              }).find("expected a grid over the place 10.00 N 10.00 E"),
              std::string::npos);
    EXPECT_TRUE(looksLikeGrib(good));
    EXPECT_EQ(parseSource(good, "x", {.place = kMiddle}).sites.size(), 9u);
}

TEST(Grib, AllPackingsGiveTheSameFigures) {
    GribMaker maker;
    maker.columns = 16, maker.rows = 16, maker.latStep = -0.1, maker.lonStep = 0.1;
    for (int i = 0; i < 256; ++i) maker.values.push_back(280.0 + 0.05 * i);
    for (char const* type : {"grid_simple", "grid_jpeg", "grid_ccsds"}) {
        std::string const bytes = tests::repacked(maker.message(), type);
        ASSERT_FALSE(bytes.empty()) << type;
        Recording const recording = parsed(bytes, PlaceWish{47.3, 7.4, {}});
        EXPECT_NEAR(*recording.sites[0].reports[0].temperature_c, 280.0 + 0.05 * (7 * 16 + 4) - 273.15, 1e-2) << type;
    }
}

TEST(Grib, TheRealFileReadsAsAnotherDecoderDoes) {
    auto const file = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "grib/gfs_clouds_subset.grib2");
    auto const figures = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "grib/gfs_2p5deg_point_47.5N_7.5E_eccodes2.28.csv");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    // By number and surface: "3,0,lowCloudBottom" -> value; 9999 is a hole.
    std::map<std::string, double> expected;
    std::istringstream lines{core::readFile(figures)};
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells;
        std::istringstream cell{line};
        for (std::string part; std::getline(cell, part, ',');) cells.push_back(part);
        if (cells.size() == 8 && cells[1] == "0") expected[fmt::format("{},{},{},{}", cells[2], cells[3], cells[4], cells[5])] = std::stod(cells[7]);
    }
    std::map<int, std::string> const surfaces{
        {103, "heightAboveGround"},     {214, "lowCloudLayer"},      {224, "middleCloudLayer"},    {234, "highCloudLayer"}, {212, "lowCloudBottom"},
        {222, "middleCloudBottom"},     {232, "highCloudBottom"},    {213, "lowCloudTop"},         {223, "middleCloudTop"}, {233, "highCloudTop"},
        {242, "convectiveCloudBottom"}, {243, "convectiveCloudTop"}, {244, "convectiveCloudLayer"}};
    int compared = 0, holes = 0;
    forEachGribField(
        core::readFile(file), "gfs", [](GribField const&) { return true; },
        [&](GribField const& field) {
            double const level = field.first.type == 103 ? field.first.value : 0.0;
            auto const found = expected.find(fmt::format("{},{},{},{:.0f}", field.category, field.number, surfaces.at(field.first.type), level));
            ASSERT_NE(found, expected.end()) << field.category << " " << field.number << " " << field.first.type;
            auto const value = gribValueAt(gribValues(field, "gfs"), field.grid, *field.grid.spotOf(47.5, 7.5));
            ++compared;
            if (found->second == 9999.0) {
                EXPECT_FALSE(value) << found->first;
                ++holes;
            } else {
                EXPECT_NEAR(value.value(), found->second, 0.06 + 1e-6 * std::abs(found->second)) << found->first;
            }
        });
    EXPECT_EQ(compared, 22);
    EXPECT_EQ(holes, 5);
    Recording const recording = parseGrib(core::readFile(file), "gfs", PlaceWish{47.5, 7.5, {}});
    EXPECT_EQ(recording.sites.size(), 9u);
    Report const& r = recording.sites[0].reports.at(0);
    EXPECT_EQ(r.time, *core::parseUtc("2011-01-15T12:00Z"));
    EXPECT_NEAR(*r.temperature_c, 281.09 - 273.15, 0.01);
    EXPECT_NEAR(*r.speed_mps, std::hypot(2.56, 2.18), 0.01);
    EXPECT_NEAR(*r.coverHigh, 0.5, 1e-6);
    ASSERT_EQ(r.layers.value().size(), 2u);
}
