#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/open_meteo.h"
#include "engine/weather/source.h"
#include "tests/unit/source_files.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
/// A body of one place with two hours; `units` and `arrays` are further entries of their objects, each ending in a comma.
std::string body(std::string const& units, std::string const& arrays, std::string const& head = "") {
    return R"({"latitude":47.5,"longitude":7.5,"elevation":300,"utc_offset_seconds":0,"generationtime_ms":0.1,)" + head + R"("hourly_units":{)" +
           units + R"("time":"unixtime"},"hourly":{)" + arrays + R"("time":[1705395600,1705399200]}})";
}
Recording parsed(std::string const& bytes) { return parseOpenMeteo(bytes, "body.json"); }
std::vector<Report> reportsOf(std::string const& units, std::string const& arrays) { return parsed(body(units, arrays)).sites.at(0).reports; }

std::string complaintOf(std::string const& bytes) {
    return tests::complaintOf([&] { parsed(bytes); });
}
std::filesystem::path shared(std::string const& name) { return tests::sharedWeather(LUFTPOST_SOURCE_DIR, "open-meteo/" + name); }
}  // namespace

TEST(OpenMeteo, AnHourHoldsWhatTheBodySaysInTheUnitsOfAReport) {
    auto const reports = reportsOf(
        R"("temperature_2m":"°C","dew_point_2m":"°C","wind_speed_10m":"m/s","wind_gusts_10m":"m/s","wind_direction_10m":"°","pressure_msl":"hPa",
           "precipitation":"mm","rain":"mm","snowfall":"cm","cloud_cover":"%","cloud_cover_low":"%","cloud_cover_mid":"%","cloud_cover_high":"%",
           "visibility":"m","cape":"J/kg","freezing_level_height":"m","snow_depth":"m","weather_code":"wmo code","shortwave_radiation":"W/m²",)",
        R"("temperature_2m":[5,6.5],"dew_point_2m":[4,5],"wind_speed_10m":[3,4],"wind_gusts_10m":[8,9],"wind_direction_10m":[200,210],
           "pressure_msl":[1001,1002.5],"precipitation":[0,1.2],"rain":[0,1.2],"snowfall":[0,0],"cloud_cover":[90,100],"cloud_cover_low":[10,20],
           "cloud_cover_mid":[30,40],"cloud_cover_high":[50,60],"visibility":[24140,9000],"cape":[0,350],"freezing_level_height":[1800,1900],
           "snow_depth":[0.05,0.04],"weather_code":[3,95],"shortwave_radiation":[100,200],)");
    ASSERT_EQ(reports.size(), 2u);
    Report const& r = reports[1];
    EXPECT_EQ(r.time, 1705399200.0);
    EXPECT_EQ(r.temperature_c, 6.5);
    EXPECT_EQ(r.dew_point_c, 5.0);
    EXPECT_EQ(r.speed_mps, 4.0);
    EXPECT_EQ(r.gust_mps, 9.0);
    EXPECT_EQ(r.from_deg, 210.0);
    EXPECT_EQ(r.pressure_hpa, 1002.5);
    EXPECT_EQ(r.rate_mm_h, 1.2);
    EXPECT_EQ(r.precipitationKind, Precipitation::Rain);
    EXPECT_EQ(r.interval_s, 3600.0);
    EXPECT_DOUBLE_EQ(*r.coverTotal, 1.0);
    EXPECT_DOUBLE_EQ(*r.coverLow, 0.2);
    EXPECT_DOUBLE_EQ(*r.coverMid, 0.4);
    EXPECT_DOUBLE_EQ(*r.coverHigh, 0.6);
    EXPECT_EQ(r.coverBounds.low_m, 3000.0);
    EXPECT_EQ(r.coverBounds.mid_m, 8000.0);
    EXPECT_EQ(r.visibility_m, 9000.0);
    EXPECT_FALSE(r.visibilityIsMinimum);
    EXPECT_TRUE(reports[0].visibilityIsMinimum) << "24,140 m is where the model ends";
    EXPECT_EQ(r.cape_j_kg, 350.0);
    EXPECT_EQ(r.freezingLevel_m, 1900.0);
    EXPECT_EQ(r.snowDepth_m, 0.04);
    EXPECT_EQ(r.weatherCode, 95);
    EXPECT_EQ(r.thunder, true);
    EXPECT_EQ(reports[0].thunder, false);
    EXPECT_EQ(reports[0].precipitationKind, Precipitation::None);
    EXPECT_EQ(r.radiation_w_m2, 200.0);
    EXPECT_FALSE(r.layers) << "cover by level is no layer";
}

TEST(OpenMeteo, EveryUnitOptionComesOutTheSame) {
    struct Case {
        char const *unit, *value;
    };
    for (Case const one : {Case{"m/s", "10"}, {"km/h", "36"}, {"kn", "19.4384449"}, {"mp/h", "22.3693629"}}) {
        auto const r =
            reportsOf(std::string{R"("wind_speed_10m":")"} + one.unit + "\",", std::string{R"("wind_speed_10m":[null,)"} + one.value + "],");
        ASSERT_EQ(r.size(), 1u) << "an hour of nothing is no report";
        EXPECT_NEAR(*r[0].speed_mps, 10.0, 1e-6) << one.unit;
    }
    for (Case const one : {Case{"°C", "-10"}, {"°F", "14"}})
        EXPECT_NEAR(*reportsOf(std::string{R"("temperature_2m":")"} + one.unit + "\",", std::string{R"("temperature_2m":[0,)"} + one.value + "],")[1]
                         .temperature_c,
                    -10.0, 1e-9);
    for (Case const one : {Case{"mm", "5.08"}, {"inch", "0.2"}})
        EXPECT_NEAR(
            *reportsOf(std::string{R"("precipitation":")"} + one.unit + "\",", std::string{R"("precipitation":[0,)"} + one.value + "],")[1].rate_mm_h,
            5.08, 1e-9);
    for (Case const one : {Case{"m", "3048"}, {"ft", "10000"}})
        EXPECT_NEAR(
            *reportsOf(std::string{R"("visibility":")"} + one.unit + "\",", std::string{R"("visibility":[0,)"} + one.value + "],")[1].visibility_m,
            3048.0, 1e-9);
    auto const feet = reportsOf(R"("visibility":"ft",)", R"("visibility":[79199.475,5],)");
    EXPECT_TRUE(feet[0].visibilityIsMinimum);
}

TEST(OpenMeteo, TheKindOfWhatFellComesFromTheSumsAndTheCode) {
    auto const kind = [](std::string const& rain, std::string const& snow, std::string const& code) {
        return reportsOf(R"("precipitation":"mm","rain":"mm","showers":"mm","snowfall":"cm","weather_code":"wmo code",)",
                         R"("precipitation":[0,1],"showers":[0,0],"rain":[0,)" + rain + R"(],"snowfall":[0,)" + snow + R"(],"weather_code":[0,)" +
                             code + "],")[1]
            .precipitationKind;
    };
    EXPECT_EQ(kind("1", "0", "61"), Precipitation::Rain);
    EXPECT_EQ(kind("0", "0.7", "71"), Precipitation::Snow);
    EXPECT_EQ(kind("0.5", "0.35", "73"), Precipitation::Sleet);
    EXPECT_EQ(kind("1", "0", "51"), Precipitation::Drizzle);
    EXPECT_EQ(kind("1", "0", "66"), Precipitation::FreezingRain);
    EXPECT_EQ(kind("null", "null", "null"), std::nullopt) << "something fell, nobody says what";
}

TEST(OpenMeteo, WaterIsTheSumOfItsPartsOnlyWhenAllAreKnown) {
    std::string const units = R"("rain":"mm","showers":"mm","snowfall":"cm","temperature_2m":"°C",)";
    EXPECT_NEAR(*reportsOf(units, R"("rain":[0,1],"showers":[0,2],"snowfall":[0,0.7],"temperature_2m":[1,1],)")[1].rate_mm_h, 4.0, 1e-9)
        << "7 cm of snow are 10 mm of water";
    EXPECT_FALSE(reportsOf(units, R"("rain":[0,1],"snowfall":[0,0.7],"temperature_2m":[1,1],)")[1].rate_mm_h);
}

TEST(OpenMeteo, LocalTimesAreTakenBackByTheOffsetAndUnixTimesAreNot) {
    std::string const head =
        R"({"latitude":-37.75,"longitude":144.875,"elevation":19,"utc_offset_seconds":39600,"hourly_units":{"temperature_2m":"°C"},"hourly":{)";
    auto const local = parsed(head + R"("time":["2024-01-16T20:00","2024-01-16T21:00"],"temperature_2m":[29.8,28.3]}})").sites[0].reports;
    auto const unix = parsed(head + R"("time":[1705395600,1705399200],"temperature_2m":[29.8,28.3]}})").sites[0].reports;
    EXPECT_EQ(local[0].time, *core::parseUtc("2024-01-16T09:00Z"));
    EXPECT_EQ(unix[0].time, local[0].time);
}

TEST(OpenMeteo, SeveralPlacesAreSeveralSites) {
    std::string const one = body(R"("temperature_2m":"°C",)", R"("temperature_2m":[1,2],)");
    std::string const two = body(R"("temperature_2m":"°C",)", R"("temperature_2m":[3,4],)", R"("location_id":1,)");
    Recording const recording = parsed("[" + one + "," + two + "]");
    ASSERT_EQ(recording.sites.size(), 2u);
    EXPECT_EQ(recording.sites[1].reports[1].temperature_c, 4.0);
}

TEST(OpenMeteo, OfSeveralModelsTheMostKnowingLeadsAndOthersFillWhatItDoesNotSay) {
    Recording const recording = parsed(body(
        R"("temperature_2m_gfs_seamless":"°C","temperature_2m_icon_seamless":"°C","cloud_cover_low_gfs_seamless":"%","cloud_cover_gfs_seamless":"%",
           "cape_icon_seamless":"J/kg","cloud_cover_icon_seamless":"%","precipitation_probability_gfs_seamless":"%","temperature_850hPa_gfs_seamless":"°C",
           "geopotential_height_850hPa_gfs_seamless":"m",)",
        R"("temperature_2m_gfs_seamless":[1,2],"temperature_2m_icon_seamless":[3,null],"cloud_cover_low_gfs_seamless":[10,20],
           "cloud_cover_gfs_seamless":[50,60],"cape_icon_seamless":[100,200],"cloud_cover_icon_seamless":[70,80],
           "precipitation_probability_gfs_seamless":[10,90],"temperature_850hPa_gfs_seamless":[-3,-4],"geopotential_height_850hPa_gfs_seamless":[1450,1460],)"));
    Report const& r = recording.sites.at(0).reports.at(1);
    EXPECT_EQ(r.temperature_c, 2.0);
    EXPECT_DOUBLE_EQ(*r.coverTotal, 0.6);
    EXPECT_DOUBLE_EQ(*r.coverLow, 0.2);
    EXPECT_EQ(r.cape_j_kg, 200.0);
    EXPECT_FALSE(r.rate_mm_h) << "a probability is no rain";
    ASSERT_EQ(r.levels.size(), 1u);
    EXPECT_EQ(r.levels[0].altitude_m, 1460.0);
    EXPECT_EQ(r.levels[0].temperature_c, -4.0);
    EXPECT_NE(recording.source.find("gfs_seamless"), std::string::npos);
    EXPECT_NE(recording.source.find("icon_seamless"), std::string::npos);
}

TEST(OpenMeteo, LevelsAreAboveSeaLevelAscendingAndAboveTheGround) {
    auto const r = reportsOf(
        R"("wind_speed_80m":"m/s","wind_direction_80m":"°","temperature_850hPa":"°C","relative_humidity_850hPa":"%","wind_speed_850hPa":"m/s",
           "wind_direction_850hPa":"°","cloud_cover_850hPa":"%","geopotential_height_850hPa":"m","temperature_1000hPa":"°C","geopotential_height_1000hPa":"m",)",
        R"("wind_speed_80m":[null,7],"wind_direction_80m":[null,190],"temperature_850hPa":[null,10],"relative_humidity_850hPa":[null,50],
           "wind_speed_850hPa":[null,15],"wind_direction_850hPa":[null,240],"cloud_cover_850hPa":[null,25],"geopotential_height_850hPa":[null,1480],
           "temperature_1000hPa":[null,12],"geopotential_height_1000hPa":[null,110],)");
    ASSERT_EQ(r.size(), 1u);
    ASSERT_EQ(r[0].levels.size(), 2u) << "1000 hPa lies under the ground at 300 m";
    EXPECT_EQ(r[0].levels[0].altitude_m, 380.0);
    EXPECT_EQ(r[0].levels[0].speed_mps, 7.0);
    EXPECT_FALSE(r[0].levels[0].temperature_c);
    EXPECT_EQ(r[0].levels[1].altitude_m, 1480.0);
    EXPECT_EQ(r[0].levels[1].from_deg, 240.0);
    EXPECT_EQ(r[0].levels[1].cover, 0.25);
    EXPECT_NEAR(*r[0].levels[1].dew_point_c, 0.06, 0.02) << "10 degrees at 50 %: psychrometric tables say 0.1";
}

TEST(OpenMeteo, ThePressureOfThePlaceIsReducedAndCountsAsFilled) {
    auto const r = reportsOf(R"("surface_pressure":"hPa","temperature_2m":"°C",)", R"("surface_pressure":[978.3,978.3],"temperature_2m":[15,15],)");
    EXPECT_FALSE(r[0].pressure_hpa);
    EXPECT_NEAR(std::get<double>(r[0].filled.at("pressure_hpa")), 1013.7, 0.3) << "1 hPa on 8.4 m at 15 degrees";
    auto const both =
        reportsOf(R"("surface_pressure":"hPa","pressure_msl":"hPa",)", R"("surface_pressure":[978.3,978.3],"pressure_msl":[1014,null],)");
    EXPECT_EQ(both[0].pressure_hpa, 1014.0);
    EXPECT_FALSE(both[0].filled.contains("pressure_hpa"));
}

TEST(OpenMeteo, NullIsUnknownAndACalmHasNoDirection) {
    auto const r = reportsOf(R"("wind_speed_10m":"m/s","wind_direction_10m":"°","precipitation":"mm","cape":"undefined",)",
                             R"("wind_speed_10m":[0,null],"wind_direction_10m":[180,90],"precipitation":[null,0],"cape":[null,null],)");
    EXPECT_EQ(r[0].speed_mps, 0.0);
    EXPECT_FALSE(r[0].from_deg);
    EXPECT_FALSE(r[0].rate_mm_h || r[0].precipitationKind || r[0].interval_s || r[0].cape_j_kg || r[0].thunder);
    EXPECT_FALSE(r[1].speed_mps);
    EXPECT_EQ(r[1].rate_mm_h, 0.0);
}

TEST(OpenMeteo, QuarterHoursAndTheCurrentHourAreReadWhereThereAreNoHours) {
    auto const quarters =
        parsed(R"({"latitude":1,"longitude":2,"minutely_15_units":{"precipitation":"mm"},"minutely_15":{"time":[900,1800],"precipitation":[0,2]}})");
    EXPECT_EQ(quarters.sites[0].reports[1].rate_mm_h, 8.0) << "2 mm in a quarter";
    EXPECT_EQ(quarters.sites[0].reports[1].interval_s, 900.0);
    auto const now =
        parsed(R"({"latitude":1,"longitude":2,"current_units":{"precipitation":"mm"},"current":{"time":900,"interval":900,"precipitation":2}})");
    EXPECT_EQ(now.sites[0].reports[0].rate_mm_h, 8.0);
}

TEST(OpenMeteo, TheOldSpellingIsReadToo) {
    auto const r =
        reportsOf(R"("windspeed_10m":"km/h","cloudcover_low":"%","weathercode":"wmo code","relativehumidity_2m":"%","temperature_2m":"°C",)",
                  R"("windspeed_10m":[36,36],"cloudcover_low":[50,50],"weathercode":[3,3],"relativehumidity_2m":[100,100],"temperature_2m":[8,8],)");
    EXPECT_DOUBLE_EQ(*r[0].speed_mps, 10.0);
    EXPECT_EQ(r[0].coverLow, 0.5);
    EXPECT_EQ(r[0].weatherCode, 3);
    EXPECT_NEAR(*r[0].dew_point_c, 8.0, 1e-9);
}

TEST(OpenMeteo, BadBodiesAreAnsweredWithFilePlaceAndExpectationInOneLine) {
    struct Case {
        std::string bytes, part;
    };
    std::string const good = body(R"("temperature_2m":"°C",)", R"("temperature_2m":[1,2],)");
    std::vector<Case> const cases{
        {R"({"error":true,"reason":"Minutely API request limit exceeded.\nPlease try again in one minute."})",
         "Minutely API request limit exceeded. Please"},
        {"<html>busy</html>", "line 1"},
        {"", "empty"},
        {good.substr(0, 150), "well-formed"},
        {"[]", "at least one place"},
        {"[1]", "[0]"},
        {R"({"latitude":47})", "longitude"},
        {R"({"latitude":99,"longitude":7})", "latitude"},
        {R"({"latitude":47,"longitude":7,"daily":{}})", "hourly"},
        {R"({"latitude":47,"longitude":7,"hourly":[]})", "hourly"},
        {R"({"latitude":47,"longitude":7,"hourly":{}})", "time"},
        {R"({"latitude":47,"longitude":7,"hourly":{"time":[]}})", "hourly.time"},
        {R"({"latitude":47,"longitude":7,"hourly":{"time":["soon"]}})", "hourly.time[0]"},
        {R"({"latitude":47,"longitude":7,"hourly":{"time":[3600,3600]}})", "hourly.time[1]"},
        {R"({"latitude":47,"longitude":7,"hourly":{"time":[3600]}})", "at least one hour"},
        {body(R"("temperature_2m":"°C",)", R"("temperature_2m":[1],)"), "hourly.temperature_2m"},
        {body(R"("temperature_2m":"°C",)", R"("temperature_2m":3,)"), "hourly.temperature_2m"},
        {body(R"("temperature_2m":"°C",)", R"("temperature_2m":[1,"2"],)"), "hourly.temperature_2m[1]"},
        {body(R"("temperature_2m":"°C",)", R"("temperature_2m":[1,200],)"), "hourly.temperature_2m[1]"},
        {body("", R"("temperature_2m":[1,2],)"), "hourly_units.temperature_2m"},
        {body(R"("temperature_2m":"hPa",)", R"("temperature_2m":[1,2],)"), "hourly_units.temperature_2m"},
        {body(R"("temperature_2m":"°C",)", R"("temperature_2m":[NaN,2],)"), "line 1"},
        {"[" + good + "," + body(R"("cape":"J/kg",)", R"("cape":[1,-5],)") + "]", "[1].hourly.cape[1]"},
    };
    for (Case const& one : cases) {
        std::string const complaint = complaintOf(one.bytes);
        EXPECT_TRUE(complaint.starts_with("body.json: ")) << complaint;
        EXPECT_NE(complaint.find(one.part), std::string::npos) << complaint << "\nshould say " << one.part;
        EXPECT_NE(complaint.find("expected"), std::string::npos) << complaint;
        EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
    }
}

TEST(OpenMeteo, TooManyPlacesOrHoursAreRefused) {
    std::string const good = body(R"("temperature_2m":"°C",)", R"("temperature_2m":[1,2],)");
    std::string places = "[" + good;
    for (int i = 0; i < 100; ++i) places += "," + good;
    EXPECT_NE(complaintOf(places + "]").find("at most 100 places"), std::string::npos);
    std::string times = "0";
    for (int i = 1; i <= 20000; ++i) times += "," + std::to_string(3600 * i);
    EXPECT_NE(complaintOf(R"({"latitude":47,"longitude":7,"hourly":{"time":[)" + times + "]}}").find("at most 20000"), std::string::npos);
}

TEST(OpenMeteo, ItIsRecognisedByContent) {
    std::string const good = body(R"("temperature_2m":"°C",)", R"("temperature_2m":[1,2],)");
    EXPECT_TRUE(looksLikeOpenMeteo(good));
    EXPECT_TRUE(looksLikeOpenMeteo("\n[" + good + "]"));
    EXPECT_FALSE(looksLikeOpenMeteo(R"({"format":"luftpost-weather-1","name":"generationtime_ms"})"));
    EXPECT_FALSE(looksLikeOpenMeteo("METAR LSZB 221720Z"));
    EXPECT_EQ(parseSource(good, "x", contextOfNow()).source, "Open-Meteo (model data)");
    std::string const complaint = tests::complaintOf([] { parseSource("Dear diary, it rained.", "diary.txt", contextOfNow()); });
    EXPECT_NE(complaint.find("diary.txt: expected weather in one of the formats: GRIB 2, "), std::string::npos) << complaint;
}

TEST(OpenMeteo, TheRequestAsksForAllThatIsRead) {
    std::string const url = openMeteoUrl("http://127.0.0.1:8080/v1/forecast", 47.541, -7.5834567);
    EXPECT_TRUE(url.starts_with("http://127.0.0.1:8080/v1/forecast?latitude=47.5410&longitude=-7.5835&timeformat=unixtime&wind_speed_unit=ms&"))
        << url;
    for (char const* part : {"past_hours=6", "forecast_hours=24", "hourly=temperature_2m,", "wind_gusts_10m", "geopotential_height_1000hPa",
                             "cloud_cover_200hPa", "wind_direction_180m", "weather_code"})
        EXPECT_NE(url.find(part), std::string::npos) << part;
    EXPECT_EQ(url.find(' '), std::string::npos);
    EXPECT_LT(url.size(), 4000u);
    EXPECT_NE(openMeteoUrl("http://h/f?apikey=k", 1, 2).find("?apikey=k&latitude=1.0000"), std::string::npos);
}

TEST(OpenMeteo, TheRealColdFrontReadsAsTheFileSays) {
    auto const file = shared("melbourne_2024-01-16_hourly_cold_front_thunderstorm.json");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    Recording const recording = parseOpenMeteo(core::readFile(file), file.string());
    ASSERT_EQ(recording.sites.size(), 1u);
    Site const& site = recording.sites[0];
    EXPECT_EQ(site.elevation_m, 19.0);
    ASSERT_EQ(site.reports.size(), 24u);
    Report const& first = site.reports[0];
    EXPECT_EQ(first.time, *core::parseUtc("2024-01-16T09:00Z"));
    EXPECT_EQ(first.temperature_c, 29.8);
    EXPECT_EQ(first.levels.size(), 3u);
    EXPECT_EQ(first.levels[0].altitude_m, 99.0);
    EXPECT_EQ(site.reports[13].temperature_c, 19.9);
    EXPECT_EQ(first.radiation_w_m2, 168.0);
}

TEST(OpenMeteo, TheRealBodyOfTwelvePlacesIsTwelveSites) {
    auto const file = shared("multi_location_array_cities_2024-01-26.json");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    Recording const recording = parseOpenMeteo(core::readFile(file), file.string());
    ASSERT_EQ(recording.sites.size(), 12u);
    EXPECT_EQ(recording.sites[0].name, "51.60 N 0.00 E");
    EXPECT_EQ(recording.sites[3].reports[2].temperature_c, 6.1);
    EXPECT_EQ(recording.sites[11].elevation_m, 110.0);
    EXPECT_EQ(recording.sites[11].reports.size(), 240u);
}

TEST(OpenMeteo, TheRealBodyOfTwoModelsIsOneSite) {
    auto const file = shared("berlin_vcr_general_more_models.json");
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    // The fixture wraps the body in what its recorder noted.
    std::string const bytes = nlohmann::json::parse(core::readFile(file)).at("body").dump();
    Recording const recording = parseOpenMeteo(bytes, file.string());
    ASSERT_EQ(recording.sites.size(), 1u);
    EXPECT_EQ(recording.sites[0].reports[1].weatherCode, 3) << "best_match knows as much as gfs_seamless and comes first";
    EXPECT_EQ(recording.source, "Open-Meteo (model data): best_match");
}
