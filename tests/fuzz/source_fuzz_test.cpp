// A seeded mutator over the decoders of model and station data: whatever comes, it is refused in one line or it is a recording that can
// be saved and read again.
#include <gtest/gtest.h>

#include <functional>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/weather/source.h"
#include "tests/fuzz/mutator.h"
#include "tests/unit/grib_maker.h"
#include "tests/unit/grib_repack.h"
#include "tests/unit/source_files.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
/// What stands for a number, a word or a piece of structure.
std::vector<std::string> const kPieces{
    "null", "-1", "1e308", "-1e308", "1e-300", "NaN", "\"\"", "[]", "{}", "true", "0", "999999999999999999999",
    "\"2024-01-16T09:00\"", "1705395600", ";", ",", "\n", "-", "\"", "}", "]", "9", "99.9", "\xff", "inf", "hPa",
    "202306210010"};

/// Refused in one line, or taken and the same after it was saved.
bool takes(std::string const& bytes, SourceContext const& context, std::function<Recording(std::string const&, SourceContext const&)> const& parse) {
    try {
        Recording const recording = parse(bytes, context);
        EXPECT_FALSE(recording.sites.empty());
        std::string const text = recordingText(recording);
        EXPECT_EQ(recordingText(parseRecording(text, "again")), text);
        return true;
    } catch (core::Error const& error) {
        EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos) << error.what();
        return false;
    }
}

void fuzz(std::vector<std::string> const& samples, test::Mutator::Kind kind) {
    SourceContext const context{.latest = 1.7e9, .place = PlaceWish{47.2, 7.9, {}}};
    auto const taken = [&](std::string const& bytes) {
        return takes(bytes, context, [](std::string const& b, SourceContext const& its) { return parseSource(b, "fuzz", its); });
    };
    for (std::string const& sample : samples) EXPECT_TRUE(taken(sample)) << sample.substr(0, 200);
    test::expectBoth(test::fuzz({samples, kPieces, kind}, taken));
}

std::string const kOpenMeteo =
    R"({"latitude":47.5,"longitude":7.5,"elevation":300,"generationtime_ms":1,"utc_offset_seconds":0,"hourly_units":{"temperature_2m":"°C","wind_speed_10m":"km/h",
"precipitation":"mm","snowfall":"cm","visibility":"m","weather_code":"wmo code","temperature_850hPa":"°C","geopotential_height_850hPa":"m","surface_pressure":"hPa"},
"hourly":{"time":[1705395600,1705399200],"temperature_2m":[3,null],"wind_speed_10m":[11,0],"precipitation":[0.7,0],"snowfall":[0.49,0],"visibility":[24140,1234],
"weather_code":[73,3],"temperature_850hPa":[2,1],"geopotential_height_850hPa":[1450.5,1451.5],"surface_pressure":[978.3,978]}})";
std::string const kMeteoblue =
    R"({"metadata":{"modelrun_utc":"","name":"Brno","height":226,"latitude":49.2,"longitude":16.6,"utc_timeoffset":2.0},"units":{"temperature":"C","windspeed":"ms-1",
"precipitation":"mm","pressure":"hPa"},"data_1h":{"time":["2026-04-20 00:00","2026-04-20 01:00"],"temperature":[8.4,8.1],"windspeed":[3.5,0],"winddirection":[309,0],
"precipitation":[null,0.1],"snowfraction":[0,0.5],"relativehumidity":[79,77],"sealevelpressure":[1015,1016],"pictocode":[31,27],"lowclouds":[10,20]}})";
std::string const kTenMinutes =
    "nat_abbr;termin;dkl010z0;fkl010z0;fkl010z1;gre000z0;oli000z0;pp0qffs0;prestas0;rre150z0;tde200s0;tre200s0;ure200s0\n"
    "BAS;20230621000000;194;0.4;0.7;0;362;1014.9;978.3;0.0;17.8;19.6;89.1\nPAY;21.06.2023 00:00;115;0.5;1.2;0;364;;978.4;1.0;17.8;19.7;89.0\n";
std::string const kObserver =
    "termin_utc,okta_nto,genus_cc1_wmo0500,vis_vho_wmo4377,ww_wmo4677,t2m_c,td2m_c\n20230622055000,0,,89,2,15,10\n20230622174000,7,9,15,95,16,15\n";
std::string const kSounding =
    "IUSD01;190215;;\nIIiii;zzzztttt;yloclas0;yloclos0;zxltcos0;zreppps0;zreppzs0;zrettts0;zretdes0;zklddds0;zklfffs0\n"
    "0-20000-0-06610;202306190000;46.812;6.943;1;958.24;491;18.8;14.29;251;1.6\n0-20000-0-06610;202306190000;46.9;6.95;10;500;5800;-10.0;-20.5;280;"
    "12\n";

std::vector<std::string> gribSeeds() {
    std::vector<std::string> seeds;
    for (auto const& [category, number, surface, level, value, statistic] :
         {std::tuple{0, 0, 103, 2.0, 288.0, -1}, {6, 1, 214, 0.0, 41.0, 0}, {1, 8, 1, 0.0, 7.0, 1}, {3, 5, 4, 0.0, 3100.0, -1}}) {
        tests::GribMaker maker;
        maker.category = category, maker.number = number, maker.surface = surface, maker.level = level, maker.statistic = statistic;
        maker.values = {value, value, value * 1.001, value, value, value, value, std::nullopt, value};
        seeds.push_back(maker.message() + maker.message());
    }
    tests::GribMaker wide;
    wide.columns = 16, wide.rows = 16, wide.latStep = -0.1, wide.lonStep = 0.1;
    for (int i = 0; i < 256; ++i) wide.values.push_back(280.0 + 0.05 * i);
    for (char const* type : {"grid_jpeg", "grid_ccsds"}) seeds.push_back(tests::repacked(wide.message(), type));
    // Complex packing with differences, and bitmaps, are what the real ones have.
    auto const file = tests::sharedWeather(LUFTPOST_SOURCE_DIR, "grib/gfs_clouds_subset.grib2");
    if (!std::filesystem::exists(file)) return seeds;
    std::string const bytes = core::readFile(file);
    std::vector<std::string> messages;
    for (std::size_t at = 0; at < bytes.size(); at += messages.back().size()) {
        std::size_t length = 0;
        for (std::size_t i = 12; i < 16; ++i) length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
        messages.push_back(bytes.substr(at, length));
    }
    seeds.insert(seeds.end(), {messages.at(0), messages.at(7), messages.at(7) + messages.at(11)});  // 2 m temperature, low cloud, its base
    return seeds;
}
}  // namespace

TEST(FuzzSources, MutantsOfModelsInJsonAreRefusedOrReadNeverACrash) { fuzz({kOpenMeteo, kMeteoblue}, test::Mutator::Kind::text); }

TEST(FuzzSources, MutantsOfStationTablesAreRefusedOrReadNeverACrash) { fuzz({kTenMinutes, kObserver, kSounding}, test::Mutator::Kind::text); }

TEST(FuzzSources, MutantsOfGribAreRefusedOrReadNeverACrash) { fuzz(gribSeeds(), test::Mutator::Kind::binary); }

TEST(FuzzSources, HostileBodiesAreRefusedBeforeTheyFillTheMemory) {
    SourceContext const context{.latest = 1.7e9};
    auto const refused = [&](std::string const& bytes) {
        return !takes(bytes, context, [](std::string const& b, SourceContext const& c) { return parseSource(b, "fuzz", c); });
    };
    EXPECT_TRUE(refused(std::string(65u << 20, ' ')));
    std::string const head = R"({"latitude":1,"longitude":2,"generationtime_ms":1,"hourly":)";
    EXPECT_TRUE(refused(head + std::string(1u << 20, '[')));
    std::string many = head + R"({"time":[0)";
    for (int i = 0; i < 4'000'001; ++i) many += ",0";
    EXPECT_TRUE(refused(many + "]}}"));
    EXPECT_TRUE(refused("GRIB" + std::string(1u << 20, '\0')));
    EXPECT_TRUE(refused("nat_abbr;termin;tre200s0\n" + std::string(1u << 20, ';')));
}
