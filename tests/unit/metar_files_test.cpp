#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/metar.h"
#include "engine/weather/source.h"
#include "engine/weather/stations.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
std::string const kTable = std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/stations.txt";
std::string const kShared = std::string{LUFTPOST_SOURCE_DIR} + "/../shared/weather/metar/";

SourceContext contextAt(std::string const& latest) { return {.latest = *core::parseUtc(latest), .stationTable = kTable}; }

Recording parse(std::string const& bytes, std::string const& latest = "2023-02-10T12:00Z") {
    return parseSource(bytes, "test", contextAt(latest));
}

std::string timeOf(Report const& report) { return core::formatUtc(report.time).substr(0, 16); }

/// "KCVG 00:52" of every report as the file lists them.
std::string listed(Recording const& recording) {
    std::string all;
    for (ListedReport const& entry : recording.order) {
        Site const& site = recording.sites[entry.site];
        all += site.name + " " + timeOf(entry.superseded ? site.superseded[entry.report] : site.reports[entry.report]) + (entry.superseded ? "- " : " ");
    }
    return all;
}

std::string fileText(std::string const& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
}
}  // namespace

TEST(MetarFiles, MonthAndYearAreTheLatestSuchDayAtOrBeforeTheTimeAsked) {
    auto const time = [](std::string const& day, std::string const& latest) { return timeOf(parse("EGLL " + day + "Z 27010KT 9999 10/05 Q1013", latest).sites[0].reports[0]); };
    EXPECT_EQ(time("101130", "2023-02-10T12:00Z"), "2023-02-10T11:30");
    EXPECT_EQ(time("101230", "2023-02-10T12:00Z"), "2023-02-10T12:30") << "of the same day, though later";
    EXPECT_EQ(time("111130", "2023-02-10T12:00Z"), "2023-01-11T11:30");
    EXPECT_EQ(time("302350", "2023-03-05T12:00Z"), "2023-01-30T23:50") << "February has no 30th";
    EXPECT_EQ(time("312350", "2023-01-05T12:00Z"), "2022-12-31T23:50");
}

TEST(MetarFiles, AStationFileHasItsDateLine) {
    Recording const recording = parse("2024/03/01 00:50\nLSZB 010050Z 27010KT CAVOK 10/05 Q1013 NOSIG\n");
    EXPECT_EQ(listed(recording), "LSZB 2024-03-01T00:50 ");
    EXPECT_EQ(recording.name, "METAR LSZB, Bern-Belp Airport");
    ASSERT_TRUE(recording.sites[0].elevation_m);
    EXPECT_NEAR(*recording.sites[0].elevation_m, 510.0, 2.0);
    EXPECT_NEAR(*recording.sites[0].lat_deg, 46.91, 0.01);
    EXPECT_EQ(listed(parse("2024/03/01 00:05\nLSZB 292350Z 27010KT CAVOK 10/05 Q1013")), "LSZB 2024-02-29T23:50 ") << "minutes before midnight";
    EXPECT_EQ(listed(parse("2011/10/20 11:25 EHAM 201125Z 27012KT 9999 10/05 Q1025")), "EHAM 2011-10-20T11:25 ");
    EXPECT_EQ(listed(parse("2024/03/01 00:50\nLSZB 010050Z CAVOK\n\n2024/02/28 12:00\nLSZH 281150Z CAVOK\n")), "LSZB 2024-03-01T00:50 LSZH 2024-02-28T11:50 ");
}

TEST(MetarFiles, BulletinsEndTheirReportsWithEqualSigns) {
    Recording const recording = parse(
        "SASW31 LSSW 010050\nMETAR LSZB 010050Z 27010KT\n 9999 FEW020\n10/05 Q1013 NOSIG=\nMETAR LSZH 010050Z NIL= METAR LSGG 010050Z 22005KT CAVOK 11/04\nQ1012=\n");
    EXPECT_EQ(listed(recording), "LSZB 2023-02-01T00:50 LSZH 2023-02-01T00:50 LSGG 2023-02-01T00:50 ");
    EXPECT_EQ(recording.sites[0].reports[0].pressure_hpa, 1013.0);
    EXPECT_EQ(recording.sites[2].reports[0].pressure_hpa, 1012.0);
    EXPECT_FALSE(recording.sites[1].reports[0].layers);
    EXPECT_TRUE(recording.notes.empty());
}

TEST(MetarFiles, ReportsAscendAtEachSiteAndTheFilesOrderIsKept) {
    Recording const recording = parse("EGLL 010150Z 27011KT CAVOK\nLSZB 010120Z CAVOK\nEGLL 010120Z 27010KT CAVOK\nLSZB 010050Z CAVOK\n");
    EXPECT_EQ(listed(recording), "EGLL 2023-02-01T01:50 LSZB 2023-02-01T01:20 EGLL 2023-02-01T01:20 LSZB 2023-02-01T00:50 ");
    ASSERT_EQ(recording.sites.size(), 2u);
    EXPECT_LT(recording.sites[0].reports[0].time, recording.sites[0].reports[1].time);
}

TEST(MetarFiles, ACorrectionHoldsAndTheSameReportTwiceIsOne) {
    std::string const first = "EGLL 010150Z 27011KT CAVOK 10/05 Q1013", corrected = "METAR COR EGLL 010150Z 27012KT CAVOK 10/05 Q1014";
    Recording const recording = parse(corrected + "\n" + first + "\n" + corrected + "\n");
    ASSERT_EQ(recording.sites[0].reports.size(), 1u);
    EXPECT_EQ(recording.sites[0].reports[0].pressure_hpa, 1014.0);
    EXPECT_EQ(listed(recording), "EGLL 2023-02-01T01:50 EGLL 2023-02-01T01:50- EGLL 2023-02-01T01:50 ");
    Field const field = fieldFrom(recording, {}, {});
    auto const reports = field.listedReports();
    ASSERT_EQ(reports.size(), 3u);
    EXPECT_EQ(reports[1].report.said.pressure_hpa, 1013.0);
    EXPECT_EQ(reports[2].report.said.pressure_hpa, 1014.0);
}

TEST(MetarFiles, AReportWhoseTimeCannotBeReadTakesThatOfTheOneBefore) {
    Recording const recording = parse("EGLL 010150Z 27011KT CAVOK\nSAOR 01123Z 23005KT 8000 BKN004 18/17 Q1013\n");
    EXPECT_EQ(listed(recording), "EGLL 2023-02-01T01:50 SAOR 2023-02-01T01:50 ");
    EXPECT_EQ(std::get<std::string>(recording.sites[1].reports[0].filled.at("time")), "2023-02-01T01:50:00Z");
    EXPECT_EQ(recording.notes, std::vector<std::string>{"line 2, column 6: SAOR: \"01123Z\" is no day and time"});
}

TEST(MetarFiles, AnUnknownStationHasNoPlaceAndItsBasesCountFromZero) {
    Recording const recording = parse("ZZZZ 010150Z 27011KT 9999 BKN010 10/05 Q1013");
    EXPECT_FALSE(recording.sites[0].lat_deg || recording.sites[0].lon_deg || recording.sites[0].elevation_m);
    Field const field = fieldFrom(recording, {}, {});
    EXPECT_NEAR(*(*field.reports()[0][0].said.layers)[0].base_m, 304.8, 1e-9);
    EXPECT_EQ(std::get<double>(field.reports()[0][0].filled.at("elevation_m")), 0.0);
    EXPECT_EQ(std::get<double>(field.reportAt(0, field.instant(field.start())).filled.at("elevation_m")), 0.0);
}

TEST(MetarFiles, AStationWithoutAPlaceBlendsIntoNoOther) {
    Field const field = fieldFrom(parse("ZZZZ 010150Z 27010KT CAVOK 30/05 Q1013\nEGLL 010150Z 27010KT CAVOK 10/05 Q1013\nYYYY 010150Z 27010KT CAVOK M20/M25 Q1013"), {}, {});
    EXPECT_NEAR(field.at(0.0, 0.0, field.start()).temperature, 283.15, 1e-6) << "here is the first that has a place";
    EXPECT_NEAR(*field.reportAt(0, field.instant(field.start())).said.temperature_c, 30.0, 1e-6);
    EXPECT_NEAR(*field.reportAt(2, field.instant(field.start())).said.temperature_c, -20.0, 1e-6);
}

TEST(MetarFiles, ATableGivesItsReportsAndTheirDates) {
    Recording const recording = parse(
        "#DEBUG: Time Zone -> UTC\nstation\tvalid\tmetar\nCVG\t2024-03-01 00:52\tKCVG 010052Z 14003KT 10SM FEW250 03/M11 A3042 RMK AO2 SLP310 T00281106 $\n"
        "CVG\t2024-03-01 00:10\tKCVG 292359Z 14003KT 10SM CLR 03/M1 A3042\nCVG\t2024-03-01 01:00\t\nCVG\n");
    EXPECT_EQ(listed(recording), "KCVG 2024-03-01T00:52 KCVG 2024-02-29T23:59 ");
    EXPECT_EQ(recording.notes, (std::vector<std::string>{"line 4, column 52: KCVG: \"03/M1\" is no temperature and dew point", "line 5, column 1: has no report",
                                                         "line 6, column 1: has no cell for the report"}));
    EXPECT_EQ(listed(parse("station,valid,metar\nCVG,2024-03-01 00:52,\"KCVG 010052Z 14003KT 10SM CLR\"\n")), "KCVG 2024-03-01T00:52 ");
}

TEST(MetarFiles, TheJsonsRawTextCountsAndItsPlaceWhereTheTableHasNone) {
    Recording const recording = parse(
        R"([{"obsTime":1789225200,"rawOb":"METAR RJTT 121500Z 03005KT 5000 -RA FEW003 20/20 Q1023","lat":1,"lon":2,"elev":3,"temp":99},
            {"obsTime":1789225200,"rawOb":"ZZZZ 121500Z 03005KT 9999 SCT010TCU 20/2 Q1023","lat":35.5,"lon":139.7,"elev":5}, {"rawOb":7}])");
    EXPECT_EQ(listed(recording), "RJTT 2026-09-12T15:00 ZZZZ 2026-09-12T15:00 ");
    EXPECT_NEAR(*recording.sites[0].lat_deg, 35.55, 0.01);
    EXPECT_EQ(recording.sites[1].elevation_m, 5.0);
    EXPECT_EQ(recording.sites[0].reports[0].temperature_c, 20.0);
    EXPECT_EQ(recording.notes, (std::vector<std::string>{"[1].rawOb, column 37: ZZZZ: \"20/2\" is no temperature and dew point", "[2], column 1: has no text \"rawOb\""}));
}

TEST(MetarFiles, OtherTextIsNotedOrRefusedInOneLine) {
    EXPECT_EQ(parse("AAXX 11124 78859 12480\nEGLL 010150Z CAVOK\n").notes, std::vector<std::string>{"line 1, column 1: \"AAXX 11124 78859 12480\" is no METAR"});
    for (std::string const bytes : {"", "hello\n", "station\tvalid\tmetar\n", "[{\"rawOb\":7}]", "[{\"rawOb\":"}) {
        try {
            parse(bytes);
            FAIL() << bytes;
        } catch (core::Error const& error) {
            EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos);
        }
    }
    EXPECT_THROW(readWeather("/dev/zero", {}, {}), core::Error) << "more than a file may have";
}

TEST(MetarFiles, ARecordingOfThemIsTheSameWhenReadAgain) {
    Recording const once = parse(
        "KCVG 012352Z 14011KT 3SM RA BR OVC006 04/04 A3014 RMK AO2 SLP212 P0005 T00390039\nZZZZ 010150Z 27011KT 9999 SCT010TCU 10/05\nOJAI 0123Z 0500 FG VV/// 07/07\n");
    Recording const again = parseRecording(recordingText(once), "again");
    EXPECT_TRUE(again.unknownKeys.empty());
    EXPECT_EQ(recordingText(again), recordingText(once));
    for (std::size_t i = 0; i < once.sites.size(); ++i) EXPECT_EQ(again.sites[i].reports[0].filled, once.sites[i].reports[0].filled) << i;
}

TEST(MetarFiles, TheTableOfStationsKnowsMostOfTheWorld) {
    Stations const table = Stations::parse(fileText(kTable), "stations.txt");
    EXPECT_GT(table.size(), 9000u);
    ASSERT_TRUE(table.find("SLLP"));
    EXPECT_NEAR(*table.find("SLLP")->elevation_m, 4061.0, 15.0) << "La Paz, by its AIP";
    EXPECT_FALSE(table.find("ZZZZ"));
    EXPECT_THROW(Stations::parse("EGLL\t51\t0\n", "short"), core::Error);
    EXPECT_THROW(Stations::parse("EGLL\t51\t0\tx\tHeathrow\n", "letters"), core::Error);
}

TEST(MetarFiles, OfARealHourOfTheWorldFewGroupsStayUnread) {
    if (!std::filesystem::exists(kShared)) GTEST_SKIP() << "no " << kShared;
    Recording const recording = readWeather(kShared + "worldwide_1093.txt", {}, contextAt("2023-02-10T00:00Z"));
    EXPECT_EQ(recording.order.size(), 1093u);
    EXPECT_EQ(recording.sites.size(), 813u);
    EXPECT_EQ(recording.notes.size(), 6u) << "a volcano's name twice, XX/XX, a blank, a time of five digits, a SYNOP";
    std::size_t placed = 0;
    for (Site const& site : recording.sites) placed += site.lat_deg.has_value();
    EXPECT_GE(placed, 796u);
    for (std::string const file : {"KCVG_2024-03-01_hourly.tsv", "KCVG_2024-03-01_specials.tsv", "aviationweather_gov_metar_json_examples.json"})
        EXPECT_TRUE(readWeather(kShared + file, {}, contextAt("2024-03-02T00:00Z")).notes.empty()) << file;
}

TEST(MetarFiles, AFieldOfEightHundredStationsIsMadeAndKnowsItsFirst) {
    if (!std::filesystem::exists(kShared)) GTEST_SKIP() << "no " << kShared;
    Field const field = loadWeather(kShared + "worldwide_1093.txt", {}, contextAt("2023-02-10T00:00Z"));
    ASSERT_EQ(field.sites(), 813u);
    Report const& first = field.recording().sites[0].reports[0];
    Weather const weather = field.at(0.0, 0.0, first.time);
    EXPECT_NEAR(weather.temperature - 273.15, *first.temperature_c, 0.3);
    EXPECT_NEAR(glm::length(weather.windSurface), *first.speed_mps, 0.3);
}
