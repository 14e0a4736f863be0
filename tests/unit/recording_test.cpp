#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/field.h"
#include "engine/weather/genera.h"
#include "engine/weather/presets.h"
#include "engine/weather/recording.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
/// A recording whose one report is the text.
std::string recordingWith(std::string const& report) {
    return R"({"format":"luftpost-weather-1","name":"n","source":"s","licence":"l","sites":[{"name":"a","lat":47.5,"lon":7.5,"elevation_m":300,"reports":[)" +
           report + "]}]}";
}
Report reportFrom(std::string const& report) { return parseRecording(recordingWith(report), "test").sites[0].reports[0]; }

std::string complaintOf(std::string const& bytes) {
    try {
        parseRecording(bytes, "day.json");
    } catch (core::Error const& error) {
        return error.what();
    }
    return "no complaint";
}

std::string bundled(std::string const& name) {
    std::ifstream file{std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/" + name};
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

std::string const kFull = R"({"time":"2023-06-22T17:30Z","wind":{"speed_mps":9.3,"gust_mps":22,"from_deg":263},"visibility_m":4000,
 "visibility_is_minimum":true,"vertical_visibility_m":300,"temperature_c":16.6,"dew_point_c":15.4,"pressure_hpa":1018.8,
 "precipitation":{"kind":"rain","rate_mm_h":109.2},"thunder":true,"layers":[{"genus":"Cb","cover":1,"base_m":900,"top_m":11000},
 {"genus":null,"cover":0.5,"base_m":null}],"layers_to_m":3000,"interval_s":600,"cover_low":1,"cover_mid":0.5,"cover_high":0.25,"cover_total":1,
 "cover_bounds_m":[2500,7000],"cape_j_kg":1200,"freezing_level_m":3600,"snow_depth_m":0.1,"weather_code":95,
 "levels":[{"altitude_m":1500,"temperature_c":9,"dew_point_c":8,"speed_mps":18,"from_deg":250,"cover":0.9},{"altitude_m":3000}],
 "filled":{"layers[1].genus":"Sc","layers[1].base_m":1500,"visibility_m":4200}})";
}  // namespace

TEST(Recording, EveryFieldOfTheFormatIsRead) {
    Report const r = reportFrom(kFull);
    EXPECT_EQ(r.time, *core::parseUtc("2023-06-22T17:30Z"));
    EXPECT_EQ(r.speed_mps, 9.3);
    EXPECT_EQ(r.gust_mps, 22.0);
    EXPECT_EQ(r.from_deg, 263.0);
    EXPECT_EQ(r.visibility_m, 4000.0);
    EXPECT_TRUE(r.visibilityIsMinimum);
    EXPECT_EQ(r.verticalVisibility_m, 300.0);
    EXPECT_EQ(r.temperature_c, 16.6);
    EXPECT_EQ(r.dew_point_c, 15.4);
    EXPECT_EQ(r.pressure_hpa, 1018.8);
    EXPECT_EQ(r.precipitationKind, Precipitation::Rain);
    EXPECT_EQ(r.rate_mm_h, 109.2);
    EXPECT_EQ(r.thunder, true);
    ASSERT_EQ(r.layers->size(), 2u);
    EXPECT_EQ((*r.layers)[0].genus, Genus::Cb);
    EXPECT_EQ((*r.layers)[0].top_m, 11000.0);
    EXPECT_FALSE((*r.layers)[1].genus || (*r.layers)[1].base_m || (*r.layers)[1].top_m);
    EXPECT_EQ(r.layersTo_m, 3000.0);
    EXPECT_EQ(r.interval_s, 600.0);
    EXPECT_EQ(r.coverBounds.mid_m, 7000.0);
    EXPECT_EQ(r.cape_j_kg, 1200.0);
    EXPECT_EQ(r.freezingLevel_m, 3600.0);
    EXPECT_EQ(r.snowDepth_m, 0.1);
    EXPECT_EQ(r.weatherCode, 95);
    ASSERT_EQ(r.levels.size(), 2u);
    EXPECT_EQ(r.levels[0].from_deg, 250.0);
    EXPECT_EQ(std::get<std::string>(r.filled.at("layers[1].genus")), "Sc");
}

TEST(Recording, NullAndAbsentAreUnknownAndNeverZero) {
    Report const r = reportFrom(R"({"time":"2023-06-22T17:30Z","wind":{"speed_mps":null},"layers":null,"thunder":null})");
    EXPECT_FALSE(r.speed_mps || r.gust_mps || r.visibility_m || r.temperature_c || r.rate_mm_h || r.thunder || r.layers);
    EXPECT_TRUE(reportFrom(R"({"time":"2023-06-22T17:30Z","layers":[]})").layers->empty());
}

TEST(Recording, UnknownKeysAreIgnoredAndNamedOnceAKind) {
    Recording const recording = parseRecording(
        recordingWith(R"({"time":"2023-06-22T17:30Z","mood":1,"wind":{"hail":2}},{"time":"2023-06-22T18:30Z","mood":2})"), "test");
    EXPECT_EQ(recording.unknownKeys, (std::vector<std::string>{"sites[0].reports[0].mood", "sites[0].reports[0].wind.hail"}));
}

TEST(Recording, TheChecksumIsThatOfTheBytes) {
    EXPECT_EQ(sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    std::string const bytes = recordingWith(kFull);
    EXPECT_EQ(parseRecording(bytes, "x").sha256, sha256Hex(bytes));
}

TEST(Recording, BadFilesAreAnsweredWithFilePlaceAndExpectationInOneLine) {
    struct Case {
        std::string bytes, place;
    };
    auto const report = [](std::string const& body) { return recordingWith(R"({"time":"2023-06-22T17:30Z",)" + body + "}"); };
    std::vector<Case> const cases{
        {"", "empty"},
        {"METAR LSZB 221720Z", "line 1"},
        {recordingWith(kFull).substr(0, 400), "line"},
        {"{\"format\":\"luftpost-weather-1\",\n\"name\": nope}", "line 2, column"},
        {"[]", "top level"},
        {"{}", "format"},
        {R"({"format":"luftpost-weather-2"})", "format"},
        {R"({"format":"luftpost-weather-1","name":"n","source":"s","licence":"l"})", "sites"},
        {R"({"format":"luftpost-weather-1","name":"n","source":"s","licence":"l","sites":[]})", "sites"},
        {R"({"format":"luftpost-weather-1","name":3,"source":"s","licence":"l","sites":[]})", "name"},
        {recordingWith(""), "sites[0].reports"},
        {recordingWith("{}"), "sites[0].reports[0]"},
        {recordingWith(R"({"time":"22 June"})"), "sites[0].reports[0].time"},
        {recordingWith(R"({"time":"2023-06-22T17:30"})"), "sites[0].reports[0].time"},
        {recordingWith(R"({"time":"2023-06-22T17:30Z"},{"time":"2023-06-22T17:30Z"})"), "sites[0].reports[1].time"},
        {report(R"("wind":{"speed_mps":-1})"), "sites[0].reports[0].wind.speed_mps"},
        {report(R"("wind":{"speed_mps":"9"})"), "wind.speed_mps"},
        {report(R"("wind":{"speed_mps":NaN})"), "line 1"},
        {report(R"("wind":{"from_deg":361})"), "wind.from_deg"},
        {report(R"("wind":[1])"), "wind"},
        {report(R"("temperature_c":1e999)"), "day.json"},
        {report(R"("precipitation":{"kind":"frogs"})"), "precipitation.kind"},
        {report(R"("layers":[{"genus":"cu"}])"), "layers[0].genus"},
        {report(R"("layers":[{"cover":1.2}])"), "layers[0].cover"},
        {report(R"("layers":[{"cover":1,"base_m":900,"top_m":800}])"), "layers[0]"},
        {report(R"("layers":{})"), "layers"},
        {report(R"("levels":[{"altitude_m":500},{"altitude_m":400}])"), "levels[1]"},
        {report(R"("cover_bounds_m":[8000,3000])"), "cover_bounds_m"},
        {report(R"("weather_code":1.5)"), "weather_code"},
        {report(R"("thunder":1)"), "thunder"},
        {report(R"("filled":{"layers[0].cover":7})"), "filled.layers[0].cover"},
    };
    for (Case const& one : cases) {
        std::string const complaint = complaintOf(one.bytes);
        EXPECT_TRUE(complaint.starts_with("day.json: ")) << complaint;
        EXPECT_NE(complaint.find(one.place), std::string::npos) << complaint << "\nshould name " << one.place;
        EXPECT_NE(complaint.find("expected"), std::string::npos) << complaint;
        EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
    }
}

TEST(Recording, WrittenAndReadAgainItIsTheSame) {
    for (std::string const name : {"basel_2023-06-21_23.json", "melbourne_2024-01-16.json"}) {
        std::string const once = recordingText(parseRecording(bundled(name), name));
        EXPECT_EQ(recordingText(parseRecording(once, "again")), once);
    }
    std::string const full = recordingText(parseRecording(recordingWith(kFull), "full"));
    EXPECT_EQ(recordingText(parseRecording(full, "again")), full);
    EXPECT_NE(full.find("109.2"), std::string::npos);
}

TEST(Recording, TheBundledDaysHoldWhatWasObserved) {
    Recording const basel = parseRecording(bundled("basel_2023-06-21_23.json"), "basel");
    EXPECT_TRUE(basel.unknownKeys.empty());
    EXPECT_NE(basel.source.find("MeteoSwiss"), std::string::npos);
    ASSERT_EQ(basel.sites[0].reports.size(), 432u);
    Report const* storm = nullptr;
    for (Report const& report : basel.sites[0].reports)
        if (report.time == *core::parseUtc("2023-06-22T17:30Z")) storm = &report;
    ASSERT_NE(storm, nullptr);
    EXPECT_EQ(storm->from_deg, 263.0);
    EXPECT_EQ(storm->gust_mps, 22.0);
    EXPECT_EQ(storm->temperature_c, 16.6);
    EXPECT_NEAR(*storm->rate_mm_h / 6.0, 18.2, 0.01);
    Recording const melbourne = parseRecording(bundled("melbourne_2024-01-16.json"), "melbourne");
    EXPECT_NE(melbourne.source.find("model"), std::string::npos);
    EXPECT_NE(melbourne.licence.find("CC BY 4.0"), std::string::npos);
    EXPECT_EQ(melbourne.sites[0].reports.size(), 24u);
}

TEST(Recording, TheGenusTableHasElevenRowsWithNamesOfTheirOwn) {
    for (int i = 0; i < kGenera; ++i) {
        auto const genus = static_cast<Genus>(i);
        EXPECT_EQ(genusFromName(genusName(genus)), genus);
        GenusRow const& row = genusRow(genus);
        EXPECT_TRUE(row.thickness > 0.0 && row.water > 0.0 && row.radius > 0.0 && row.extinction > 1e-4 && row.extinction < 0.2) << row.name;
    }
    EXPECT_FALSE(genusFromName("cu"));
    EXPECT_FALSE(genusFromName("TCU"));
}
