#include <gtest/gtest.h>

#include <algorithm>

#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/meteoswiss.h"
#include "engine/weather/source.h"
#include "tests/unit/source_files.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
Recording parsed(std::string const& bytes) { return parseMeteoSwiss(bytes, "day.csv"); }

std::string const kHeading =
    "station_abbr;reference_timestamp;dkl010z0;fkl010z0;fkl010z1;gre000z0;oli000z0;pp0qffs0;pp0qnhs0;prestas0;rre150z0;tde200s0;tre200s0;ure200s0\n";

std::string const kSounding =
    "IUSD01;190215;;\n"
    "IIiii;zzzztttt;zxracos0;yloclas0;yloclos0;zxltcos0;zreppps0;zreppzs0;zrettts0;zretdes0;zklddds0;zklfffs0\n"
    "0-20000-0-06610;202306190000;142;46.812;6.943;10;1000;118.9;-;-;-;0\n"
    "0-20000-0-06610;202306190000;142;46.812;6.943;1;958.24;491;18.8;14.29;251;1.6\n"
    "0-20000-0-06610;202306190000;142;46.812;6.943;2;953.93;530;21.47;13.68;243;3.1\n"
    "0-20000-0-06610;202306190000;142;46.9;6.95;10;500;5800;-10.0;-20.5;280;12\n"
    "0-20000-0-06610;202306190000;142;46.813;6.943;1;-;-;-;-;-;-\n";

Report const& at(Site const& site, char const* time) {
    return *std::find_if(site.reports.begin(), site.reports.end(), [&](Report const& report) { return report.time == *core::parseUtc(time); });
}
}  // namespace

TEST(MeteoSwiss, TenMinutesHoldWhatTheStationMeasured) {
    Recording const recording = parsed(kHeading + "BAS;22.06.2023 17:30;263;9.3;22.0;12;380;1008.1;1009.2;970.5;18.2;15.4;16.6;92.5\n");
    EXPECT_EQ(recording.source, "MeteoSwiss (automatic stations)");
    Site const& site = recording.sites.at(0);
    EXPECT_EQ(site.name, "Basel / Binningen");
    EXPECT_EQ(site.elevation_m, 316.0);
    Report const& r = site.reports.at(0);
    EXPECT_EQ(r.time, *core::parseUtc("2023-06-22T17:30Z"));
    EXPECT_EQ(r.from_deg, 263.0);
    EXPECT_EQ(r.speed_mps, 9.3);
    EXPECT_EQ(r.gust_mps, 22.0);
    EXPECT_EQ(r.temperature_c, 16.6);
    EXPECT_EQ(r.dew_point_c, 15.4);
    EXPECT_EQ(r.pressure_hpa, 1008.1) << "QFF before QNH before the station's own";
    EXPECT_NEAR(*r.rate_mm_h, 109.2, 1e-9) << "18.2 mm in ten minutes";
    EXPECT_EQ(r.interval_s, 600.0);
    EXPECT_FALSE(r.precipitationKind) << "a gauge does not see what falls";
    EXPECT_EQ(r.radiation_w_m2, 12.0);
    EXPECT_EQ(r.longwave_w_m2, 380.0);
    EXPECT_FALSE(r.layers || r.visibility_m);
}

TEST(MeteoSwiss, AnEmptyCellIsUnknownAndSeveralStationsAreSeveralSites) {
    Recording const recording = parsed(kHeading +
                                       "BAS;22.06.2023 17:30;;;;;;;;;0.0;;16.6;\n"
                                       "XYZ;22.06.2023 17:30;-;2.0;4.0;-;-;-;-;900.0;1.0;-;10.0;50\n"
                                       "BAS;22.06.2023 17:20;200;1.0;;;;;1010.0;978.3;;;17.0;50\n");
    ASSERT_EQ(recording.sites.size(), 2u);
    Site const& basel = recording.sites[0];
    ASSERT_EQ(basel.reports.size(), 2u) << "sorted by time";
    EXPECT_EQ(basel.reports[0].pressure_hpa, 1010.0) << "QNH where QFF is never given";
    EXPECT_NEAR(*basel.reports[0].dew_point_c, 6.5, 0.1);
    EXPECT_FALSE(basel.reports[1].speed_mps || basel.reports[1].gust_mps || basel.reports[1].pressure_hpa || basel.reports[1].dew_point_c);
    EXPECT_EQ(basel.reports[1].precipitationKind, Precipitation::None);
    ASSERT_EQ(recording.order.size(), 3u) << "as the file lists them";
    EXPECT_EQ(recording.order[0].report, 1u);
    EXPECT_EQ(recording.order[1].site, 1u);
    EXPECT_EQ(recording.order[2].report, 0u);
    Site const& unknown = recording.sites[1];
    EXPECT_EQ(unknown.name, "XYZ");
    EXPECT_FALSE(unknown.lat_deg || unknown.lon_deg || unknown.elevation_m);
    EXPECT_FALSE(unknown.reports[0].pressure_hpa || unknown.reports[0].filled.contains("pressure_hpa")) << "nobody knows how high it stands";
    EXPECT_FALSE(unknown.reports[0].from_deg);
}

TEST(MeteoSwiss, AStationsOwnPressureAloneIsReducedAndFilled) {
    Report const r =
        parsed("station_abbr;reference_timestamp;prestas0;tre200s0;fu3010z0;fu3010z1\nBAS;22.06.2023 17:30;978.3;19.6;36;72\n").sites[0].reports[0];
    EXPECT_FALSE(r.pressure_hpa);
    EXPECT_NEAR(std::get<double>(r.filled.at("pressure_hpa")), 1014.9, 0.5) << "the QFF that the station itself gave for this";
    EXPECT_NEAR(*r.speed_mps, 10.0, 1e-9) << "kilometres an hour by the column's name";
    EXPECT_NEAR(*r.gust_mps, 20.0, 1e-9);
}

TEST(MeteoSwiss, ASoundingIsAReportWithLevels) {
    Recording const recording = parsed(kSounding);
    Site const& site = recording.sites.at(0);
    EXPECT_EQ(site.name, "Payerne");
    EXPECT_EQ(site.elevation_m, 491.0);
    EXPECT_EQ(site.lat_deg, 46.812);
    Report const& r = site.reports.at(0);
    EXPECT_EQ(r.temperature_c, 18.8);
    EXPECT_EQ(r.speed_mps, 1.6);
    ASSERT_EQ(r.levels.size(), 2u) << "the 1000 hPa level lies under the ground";
    EXPECT_EQ(r.levels[0].altitude_m, 530.0);
    EXPECT_EQ(r.levels[0].temperature_c, 21.47);
    EXPECT_EQ(r.levels[0].dew_point_c, 13.68);
    EXPECT_EQ(r.levels[1].from_deg, 280.0);
    EXPECT_NEAR(*r.freezingLevel_m, 530.0 + 5270.0 * 21.47 / 31.47, 0.1);
    EXPECT_NEAR(std::get<double>(r.filled.at("pressure_hpa")), 1014.0, 1.5);
}

TEST(MeteoSwiss, AnObserversLookIsALayerOfItsGenus) {
    std::string const heading =
        "termin_utc,okta_nto,genus_cc1_wmo0500,vis_vho_wmo4377,ww_wmo4677,t2m_c,td2m_c,rain_mm_10min,wind_ms,gust_ms,wind_dir\n";
    auto const reports = parsed(heading +
                                "20230622055000,0,,89,2,15,10,0,1,2,90\n"
                                "20230622115000,6,8,75,80,25,16,0.5,3,6,200\n"
                                "20230622174000,8,9,15,95,16,15,3,9,22,263\n"
                                "20230623055000,9,,04,45,10,10,0,0,0,0\n")
                             .sites.at(0)
                             .reports;
    ASSERT_EQ(reports.size(), 4u);
    EXPECT_TRUE(reports[0].layers.value().empty());
    EXPECT_TRUE(reports[0].visibilityIsMinimum);
    EXPECT_EQ((*reports[1].layers)[0].genus, Genus::Cu);
    EXPECT_EQ((*reports[1].layers)[0].cover, 0.75);
    EXPECT_FALSE((*reports[1].layers)[0].base_m);
    EXPECT_EQ(reports[1].visibility_m, 25000.0);
    EXPECT_EQ(reports[1].precipitationKind, Precipitation::Rain);
    EXPECT_EQ(reports[1].thunder, false);
    EXPECT_EQ(reports[2].thunder, true);
    EXPECT_EQ(reports[2].visibility_m, 1500.0);
    EXPECT_FALSE(reports[3].layers) << "an obscured sky has no layers that one sees";
    EXPECT_EQ(reports[3].visibility_m, 400.0);
    EXPECT_FALSE(reports[3].from_deg);
}

TEST(MeteoSwiss, BadFilesAreAnsweredWithLineAndColumnInOneLine) {
    struct Case {
        std::string bytes, part;
    };
    std::vector<Case> const cases{
        {"a;b;c\n", "line 1"},
        {kHeading, "at least one row"},
        {kHeading + "BAS;yesterday;263\n", "line 2, column reference_timestamp"},
        {kHeading + "BAS;31.06.2023 17:30;263\n", "line 2, column reference_timestamp"},
        {kHeading + "BAS;22.06.2023 17:30;400\n", "line 2, column dkl010z0"},
        {kHeading + "BAS;22.06.2023 17:30;west\n", "line 2, column dkl010z0"},
        {kHeading + "BAS;22.06.2023 17:30;263nan\n", "line 2, column dkl010z0"},
        {kHeading + "BAS;22.06.2023 17:30;nan\n", "line 2, column dkl010z0"},
        {kHeading + ";22.06.2023 17:30;263\n", "line 2, column station_abbr"},
        {kHeading + "BAS;22.06.2023 17:30;1;1\nBAS;22.06.2023 17:30;1;1\n", "line 3, column reference_timestamp"},
        {kHeading + "BAS;22.06.2023 17:30;1;2;3;4;5;6;7;8;9;10;11;12;13;14;15\n", "line 2"},
        {"IIiii;zzzztttt;zreppzs0\nx;tomorrow;1\n", "line 2, column zzzztttt"},
        {"termin_utc,okta_nto\n20230622055000,10\n", "line 2, column okta_nto"},
        {"termin_utc,okta_nto\n20230622055000,1\n20230622055000,1\n", "line 3, column termin_utc"},
    };
    for (Case const& one : cases) {
        std::string const complaint = tests::complaintOf([&] { parsed(one.bytes); });
        EXPECT_TRUE(complaint.starts_with("day.csv: ")) << complaint;
        EXPECT_NE(complaint.find(one.part), std::string::npos) << complaint << "\nshould say " << one.part;
        EXPECT_NE(complaint.find("expected"), std::string::npos) << complaint;
        EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
    }
}

TEST(MeteoSwiss, AllThreeAreRecognisedByContent) {
    EXPECT_TRUE(looksLikeMeteoSwiss(kHeading));
    EXPECT_TRUE(looksLikeMeteoSwiss(kSounding));
    EXPECT_FALSE(looksLikeMeteoSwiss("METAR LSZB 221720Z"));
    EXPECT_FALSE(looksLikeMeteoSwiss("{}"));
    EXPECT_EQ(parseSource(kSounding, "x", contextOfNow()).source, "MeteoSwiss (sounding)");
}

TEST(MeteoSwiss, TheRealGustFrontReadsAsTheFileSays) {
    auto const file = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "meteoswiss/BAS_10min_2023-06-21_23_thunderstorm_front.csv");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    Recording const recording = parseMeteoSwiss(core::readFile(file), file.string());
    Site const& site = recording.sites.at(0);
    ASSERT_EQ(site.reports.size(), 432u);
    Report const& first = site.reports[0];
    EXPECT_EQ(first.time, *core::parseUtc("2023-06-21T00:00Z"));
    EXPECT_EQ(first.from_deg, 194.0);
    EXPECT_EQ(first.speed_mps, 0.4);
    EXPECT_EQ(first.gust_mps, 0.7);
    EXPECT_EQ(first.pressure_hpa, 1014.9);
    EXPECT_EQ(first.longwave_w_m2, 362.0);
    Report const& storm = at(site, "2023-06-22T17:30Z");
    EXPECT_EQ(storm.from_deg, 263.0);
    EXPECT_EQ(storm.gust_mps, 22.0);
    EXPECT_EQ(storm.temperature_c, 16.6);
    EXPECT_NEAR(*storm.rate_mm_h / 6.0, 18.2, 1e-9);
}

TEST(MeteoSwiss, TheRealSoundingReadsAsTheFileSays) {
    auto const file = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "meteoswiss/radiosounding_PAY_2023-06-19_00Z.csv");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    Recording const recording = parseMeteoSwiss(core::readFile(file), file.string());
    Report const& r = recording.sites.at(0).reports.at(0);
    EXPECT_EQ(r.time, *core::parseUtc("2023-06-19T00:00Z"));
    EXPECT_EQ(r.temperature_c, 18.8);
    EXPECT_EQ(r.levels.front().altitude_m, 530.0);
    EXPECT_EQ(r.levels.back().altitude_m, 37839.7);
    EXPECT_EQ(r.levels.back().temperature_c, -20.8);
    EXPECT_GT(r.levels.size(), 130u);
    EXPECT_NEAR(*r.freezingLevel_m, 3900.0, 600.0);
}

TEST(MeteoSwiss, TheRealObserverReadsAsTheFileSays) {
    auto const file = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "meteoswiss/BAS_observer_2023-01_07.csv");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    Site const site = parseMeteoSwiss(core::readFile(file), file.string()).sites.at(0);
    ASSERT_EQ(site.reports.size(), 288u);
    Report const& first = site.reports[0];
    EXPECT_EQ(first.time, *core::parseUtc("2023-01-01T05:50Z"));
    EXPECT_EQ((*first.layers)[0].cover, 0.75);
    EXPECT_EQ((*first.layers)[0].genus, Genus::Ci);
    EXPECT_EQ(first.visibility_m, 25000.0);
    Report const& last = site.reports.back();
    EXPECT_EQ((*last.layers)[0].genus, Genus::Cu);
    EXPECT_EQ(last.visibility_m, 50000.0) << "code 84";
}
