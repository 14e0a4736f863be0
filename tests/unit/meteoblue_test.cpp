#include <gtest/gtest.h>

#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/meteoblue.h"
#include "engine/weather/source.h"
#include "tests/unit/source_files.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
/// A body of two hours; `units` and `arrays` are further entries, each ending in a comma.
std::string body(std::string const& units, std::string const& arrays, std::string const& times = R"("2026-04-20 00:00","2026-04-20 01:00")") {
    return R"({"metadata":{"modelrun_utc":"2026-04-19 21:00","name":"","height":226,"latitude":49.1952,"longitude":16.608,"utc_timeoffset":2.0},"units":{)" +
           units + R"("time":"YYYY-MM-DD hh:mm"},"data_1h":{)" + arrays + R"("time":[)" + times + "]}}";
}
Recording parsed(std::string const& bytes) { return parseMeteoblue(bytes, "body.json"); }
std::vector<Report> reportsOf(std::string const& units, std::string const& arrays) { return parsed(body(units, arrays)).sites.at(0).reports; }
}  // namespace

TEST(Meteoblue, AnHourHoldsWhatBothPackagesSay) {
    auto const reports = reportsOf(
        R"("temperature":"C","windspeed":"ms-1","winddirection":"degree","precipitation":"mm","relativehumidity":"percent","pressure":"hPa","cloudcover":"percent",)",
        R"("temperature":[8.44,8.07],"windspeed":[3.55,3.5],"winddirection":[309,311],"precipitation":[null,0.11],"snowfraction":[0,0],"relativehumidity":[79,77],
           "sealevelpressure":[1015.52,1015.79],"pictocode":[31,28],"lowclouds":[10,20],"midclouds":[30,40],"highclouds":[50,60],"totalcloudcover":[30,40],
           "visibility":[15000,9000],)");
    ASSERT_EQ(reports.size(), 2u);
    Report const& r = reports[1];
    EXPECT_EQ(r.time, *core::parseUtc("2026-04-19T23:00Z")) << "01:00 in a country two hours ahead";
    EXPECT_EQ(r.temperature_c, 8.07);
    EXPECT_NEAR(*r.dew_point_c, 4.3, 0.1);
    EXPECT_EQ(r.speed_mps, 3.5);
    EXPECT_EQ(r.from_deg, 311.0);
    EXPECT_EQ(r.pressure_hpa, 1015.79);
    EXPECT_EQ(r.rate_mm_h, 0.11);
    EXPECT_EQ(r.interval_s, 3600.0);
    EXPECT_EQ(r.precipitationKind, Precipitation::Rain);
    EXPECT_FALSE(reports[0].rate_mm_h || reports[0].precipitationKind || reports[0].interval_s) << "what looks back has no first value";
    EXPECT_EQ(r.thunder, true);
    EXPECT_FALSE(reports[0].thunder) << "a picture without thunder does not say that there is none";
    EXPECT_DOUBLE_EQ(*r.coverLow, 0.2);
    EXPECT_DOUBLE_EQ(*r.coverMid, 0.4);
    EXPECT_DOUBLE_EQ(*r.coverHigh, 0.6);
    EXPECT_DOUBLE_EQ(*r.coverTotal, 0.4);
    EXPECT_EQ(r.coverBounds.low_m, 4000.0);
    EXPECT_EQ(r.coverBounds.mid_m, 8000.0);
    EXPECT_EQ(r.visibility_m, 9000.0);
}

TEST(Meteoblue, UnitsAreThoseOfTheQuantity) {
    auto const r = reportsOf(R"("temperature":"F","windspeed":"kmh","precipitation":"inch",)",
                             R"("temperature":[50,50],"windspeed":[36,36],"gust":[72,72],"precipitation":[0.1,0.1],"snowfraction":[1,1],)")[1];
    EXPECT_NEAR(*r.temperature_c, 10.0, 1e-9);
    EXPECT_NEAR(*r.speed_mps, 10.0, 1e-9);
    EXPECT_NEAR(*r.gust_mps, 20.0, 1e-9);
    EXPECT_NEAR(*r.rate_mm_h, 2.54, 1e-9);
    EXPECT_EQ(r.precipitationKind, Precipitation::Snow);
    EXPECT_FALSE(r.coverHigh || r.coverTotal) << "nothing said of cloud";
}

TEST(Meteoblue, AllThreeFormatsOfTimeAreTheSameHours) {
    std::string const units = R"("temperature":"C",)", arrays = R"("temperature":[1,2],)";
    for (char const* times : {R"("2026-04-20 00:00","2026-04-20 01:00")", R"("2026-04-20T00:00+02:00","2026-04-20T01:00+02:00")",
                              R"("2026-04-19T22:00:00Z","2026-04-19T23:00:00Z")", "1776636000000,1776639600000", "1776636000,1776639600"}) {
        auto const reports = parsed(body(units, arrays, times)).sites[0].reports;
        EXPECT_EQ(reports[0].time, *core::parseUtc("2026-04-19T22:00Z")) << times;
        EXPECT_EQ(reports[1].time, *core::parseUtc("2026-04-19T23:00Z")) << times;
    }
}

TEST(Meteoblue, AnHourOfSummerTimesEndIsAnHour) {
    std::string const units = R"("temperature":"C",)";
    auto const autumn =
        parsed(body(units, R"("temperature":[1,2,3],)", R"("2026-10-25 02:00","2026-10-25 02:00","2026-10-25 03:00")")).sites[0].reports;
    EXPECT_EQ(autumn[1].time - autumn[0].time, 3600.0);
    EXPECT_EQ(autumn[2].time - autumn[1].time, 3600.0);
    auto const spring =
        parsed(body(units, R"("temperature":[1,2,3],)", R"("2026-03-29 01:00","2026-03-29 03:00","2026-03-29 04:00")")).sites[0].reports;
    EXPECT_EQ(spring[2].time - spring[0].time, 7200.0);
}

TEST(Meteoblue, BadBodiesAreAnsweredWithFilePlaceAndExpectationInOneLine) {
    struct Case {
        std::string bytes, part;
    };
    std::vector<Case> const cases{
        {R"({"error":true,"error_message":"API key\ninvalid"})", "API key invalid"},
        {"[]", "object"},
        {"{}", "metadata"},
        {R"({"metadata":{},"units":{}})", "data_1h"},
        {R"({"metadata":{},"units":{},"data_1h":{}})", "metadata"},
        {body(R"("temperature":"C",)", R"("temperature":[1],)"), "data_1h.temperature"},
        {body(R"("temperature":"C",)", R"("temperature":[1,99],)"), "data_1h.temperature[1]"},
        {body("", R"("temperature":[1,2],)"), "units.temperature"},
        {body(R"("windspeed":"bft",)", R"("windspeed":[1,2],)"), "units.windspeed"},
        {body(R"("temperature":"C",)", R"("temperature":[1,2],)", R"("now","then")"), "data_1h.time[0]"},
        {body(R"("temperature":"C",)", R"("temperature":[1,2],)", R"("2026-04-20T00:00+02:00","2026-04-20T00:00+02:00")"), "data_1h.time[1]"},
        {body("", ""), "at least one hour"},
    };
    for (Case const& one : cases) {
        std::string const complaint = tests::complaintOf([&] { parsed(one.bytes); });
        EXPECT_TRUE(complaint.starts_with("body.json: ")) << complaint;
        EXPECT_NE(complaint.find(one.part), std::string::npos) << complaint << "\nshould say " << one.part;
        EXPECT_NE(complaint.find("expected"), std::string::npos) << complaint;
        EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
    }
}

TEST(Meteoblue, TheRequestNamesThePlaceAndHidesNothingInTheKey) {
    EXPECT_EQ(meteoblueUrl("http://127.0.0.1:8080/packages/basic-1h_clouds-1h", "a b&c", 47.5, 7.25, 316.4),
              "http://127.0.0.1:8080/packages/basic-1h_clouds-1h?lat=47.5000&lon=7.2500&asl=316&timeformat=iso8601&format=json&apikey=a%20b%26c");
    EXPECT_EQ(meteoblueUrl("http://h/p", "k", 47.5, 7.25, {}).find("asl"), std::string::npos);
}

TEST(Meteoblue, ItIsRecognisedByContent) {
    std::string const good = body(R"("temperature":"C",)", R"("temperature":[1,2],)");
    EXPECT_EQ(parseSource(good, "x", contextOfNow()).source, "meteoblue (model data)");
    EXPECT_FALSE(looksLikeMeteoblue(R"({"latitude":1,"hourly":{}})"));
}

TEST(Meteoblue, TheRealBodyReadsAsTheFileSays) {
    auto const file = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "meteoblue/brno_2026-04-20_basic-1h.json");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    Recording const recording = parseMeteoblue(core::readFile(file), file.string());
    Site const& site = recording.sites.at(0);
    EXPECT_EQ(site.elevation_m, 226.0);
    ASSERT_EQ(site.reports.size(), 169u);
    EXPECT_EQ(site.reports[0].time, *core::parseUtc("2026-04-19T22:00Z"));
    EXPECT_EQ(site.reports[0].rate_mm_h, 0.27);
    EXPECT_EQ(site.reports[0].precipitationKind, Precipitation::Rain);
    EXPECT_EQ(site.reports[1].from_deg, 311.0);
    EXPECT_EQ(site.reports[168].temperature_c, 6.39);
    EXPECT_EQ(site.reports[168].pressure_hpa, 1020.3);
    EXPECT_FALSE(site.reports[0].coverTotal);
}
