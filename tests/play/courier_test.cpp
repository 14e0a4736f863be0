// The bot plays the game through the input layer, and a flight is the same flight however it is run.
#include "tests/play/program.h"

#include <sstream>
#include <vector>

namespace {
using luftpost::tests::fileText;
using luftpost::tests::flight;
using luftpost::tests::scratch;

std::string const kBot = "play --headless --no-render --bot courier ";

class Courier : public testing::TestWithParam<int> {};
TEST_P(Courier, DeliversWithinTenMinutesAndDoesNotCrash) {
    auto const report = flight(kBot + "--seconds 600 --seed " + std::to_string(GetParam()));
    EXPECT_GE(report["deliveries"], 1);
    EXPECT_EQ(report["crashes"], 0);
    EXPECT_GT(report["score"], 0.0);
    EXPECT_EQ(report["state_hash"].size(), 600u);
    EXPECT_EQ(report["frames"], 0);
    EXPECT_LE(report["chunks"]["peak_bytes"], 160'000'000);
    EXPECT_GT(report["chunks"]["made"], 20);
    for (auto const& drop : report["drops"])
        EXPECT_TRUE(drop["landing"].is_null() || drop["landing"]["t_s"] > drop["t_s"]);
}
INSTANTIATE_TEST_SUITE_P(Seeds, Courier, testing::Values(1, 2, 3));

TEST(Bot, DeliversWithTheFreightPlane) {
    auto const report = flight(kBot + "--seconds 240 --set aircraft.airframe=freight_plane --payload 560");
    EXPECT_GE(report["deliveries"], 1);
    EXPECT_EQ(report["crashes"], 0);
    EXPECT_EQ(report["changed"]["aircraft.airframe"], "freight_plane");
}

TEST(Bot, DeliversInEveryAssist) {
    for (char const* assist : {"sim", "light", "easy"}) {
        auto const report = flight(kBot + "--seconds 120 --assist " + assist);
        EXPECT_GE(report["deliveries"], 1) << assist;
        EXPECT_EQ(report["crashes"], 0) << assist;
        EXPECT_EQ(report["changed"]["aircraft.assist"], assist);
    }
}

TEST(Flight, IsTheSameAgainAndWithAnyWorkersFrameRateAndProcessor) {
    std::string const flown = kBot + "--seconds 75 ";
    auto const hashes = flight(flown)["state_hash"];
    ASSERT_EQ(hashes.size(), 75u);
    EXPECT_NE(hashes[0], hashes[1]);
    EXPECT_EQ(flight(flown)["state_hash"], hashes) << "a second run";
    EXPECT_EQ(flight(flown + "--workers 1 --frame-rate 30")["state_hash"], hashes)
        << "1 worker, 30 frames a second";
    EXPECT_EQ(flight(flown + "--workers 8 --frame-rate 144")["state_hash"], hashes)
        << "8 workers, 144 frames a second";
    EXPECT_EQ(flight(flown, "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable")["state_hash"], hashes)
        << "no FMA";
    EXPECT_NE(flight(flown + "--seed 2")["state_hash"], hashes) << "another land is another flight";
    EXPECT_NE(flight(flown + "--weather preset:calm")["state_hash"], hashes)
        << "another weather is another flight";
}

TEST(Replay, IsTheFlightAgainAtAnyFrameRate) {
    std::string const file = (scratch() / "flight.replay").string();
    auto const flown =
        flight(kBot +
               "--seconds 60 --weather preset:broken --payload 100 --set aircraft.rollSpeed=45 "
               "--save-replay '" +
               file + "'");
    auto const again = flight("replay '" + file + "' --frame-rate 30 --workers 2");
    EXPECT_EQ(again["state_hash"], flown["state_hash"]);
    EXPECT_EQ(again["drops"], flown["drops"]);
    EXPECT_EQ(again["changed"]["aircraft.rollSpeed"], 45.0);
}

TEST(Replay, OpensNoWindowWhereThereIsNoneOrNobodyWantsIt) {
    std::string const file = "'" + (scratch() / "flight.replay").string() + "'";
    flight(kBot + "--seconds 2 --weather preset:calm --save-replay " + file);
    EXPECT_EQ(luftpost::tests::run("replay " + file, "DISPLAY= WAYLAND_DISPLAY=").code, 0);
    EXPECT_EQ(luftpost::tests::run("replay --headless " + file, "DISPLAY=:4711").code, 0);
    EXPECT_NE(luftpost::tests::run("replay " + file, "DISPLAY=:4711").code, 0) << "a display that does not answer";
}

TEST(Replay, FindsItsRecordingFromAnyFolder) {
    auto const folder = scratch();
    std::filesystem::copy_file(
        std::filesystem::path{LUFTPOST_SOURCE_DIR} / "assets/weather/melbourne_2024-01-16.json",
        folder / "here.json", std::filesystem::copy_options::overwrite_existing);
    auto const from = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    auto const flown = flight(kBot + "--seconds 3 --weather recorded:here.json --save-replay flight.replay");
    std::filesystem::current_path(from);
    EXPECT_EQ(flight("replay '" + (folder / "flight.replay").string() + "'")["state_hash"],
              flown["state_hash"]);
}

TEST(InputFile, FliesTheAircraftAndDropsTheParcel) {
    auto const folder = scratch();
    luftpost::tests::writeText(folder / "in.csv",
                               "t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop\n"
                               "0,,,,,,,\n2,1,,0.5,,,,\n4,,,0,,0.5,,1\n5,,,,,,,0\n");
    auto const report =
        flight("--headless --no-render --seconds 60 --weather preset:calm --input '" +
               (folder / "in.csv").string() + "' --log '" + (folder / "log.csv").string() + "'");
    ASSERT_EQ(report["drops"].size(), 1u);
    EXPECT_DOUBLE_EQ(report["drops"][0]["t_s"], 4.0);
    std::string const log = fileText(folder / "log.csv");
    EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 602) << "a header, and rows at 0, 0.1, ... 60";
    EXPECT_TRUE(log.starts_with("t_s,lat_deg,lon_deg,altitude_m,height_m,tas_mps,ias_mps,"));
    EXPECT_EQ(log.find("nan"), std::string::npos);
    EXPECT_EQ(log.find("inf"), std::string::npos);
}

TEST(Flight, StartsOnTheRunwayAtRest) {
    auto const folder = scratch();
    flight("--headless --no-render --seconds 3 --start runway --log '" + (folder / "log.csv").string() + "'");
    std::istringstream log{fileText(folder / "log.csv")};
    std::string line;
    std::getline(log, line);
    int rows = 0;
    for (; std::getline(log, line); ++rows) {
        std::vector<double> values;
        std::istringstream cells{line};
        for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
        ASSERT_EQ(values.size(), 30u);
        EXPECT_EQ(values[26], 1.0) << "on the ground at " << values[0];
        EXPECT_LT(values[7], 1.0) << "hardly rolls at " << values[0];
    }
    EXPECT_EQ(rows, 31);
}

TEST(Flight, GoesOnAfterACrash) {
    auto const folder = scratch();
    luftpost::tests::writeText(folder / "in.csv",
                               "t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop\n0,1,-1,,,,,\n");
    auto const report = flight("--headless --no-render --seconds 60 --assist sim --input '" +
                               (folder / "in.csv").string() + "'");
    EXPECT_GE(report["crashes"], 1);
    EXPECT_EQ(report["seconds"], 60.0);
}

TEST(Save, KeepsScoreAndDeliveriesAcrossRuns) {
    std::string const save = (scratch() / "save.json").string();
    std::string const flown = kBot + "--seconds 75 --save '" + save + "'";
    flight(flown);
    auto const first = nlohmann::json::parse(fileText(save));
    EXPECT_GE(first["deliveries"], 1);
    flight(flown);
    auto const second = nlohmann::json::parse(fileText(save));
    EXPECT_EQ(second["deliveries"], 2 * first["deliveries"].get<int>());
    EXPECT_FALSE(std::filesystem::exists(save + ".new"));
}

TEST(Save, IsBegunInAnEmptyFileAndRefusedByAFullDiskWithOneLine) {
    std::string const save = (scratch() / "save.json").string();
    luftpost::tests::writeText(save, "");
    flight(kBot + "--seconds 75 --save '" + save + "'");
    EXPECT_GE(nlohmann::json::parse(fileText(save))["deliveries"], 1);
    auto const full = luftpost::tests::run(kBot + "--seconds 75 --save /dev/full");
    EXPECT_EQ(full.code, 2);
    EXPECT_EQ(full.complaints(), 1) << full.err;
    EXPECT_NE(full.err.find("/dev/full"), std::string::npos) << full.err;
}

TEST(Save, SurvivesAProgramThatIsKilled) {
    std::string const save = (scratch() / "save.json").string();
    std::string const endless =
        "timeout -s KILL 60 sh -c '" LUFTPOST_PROGRAM " " + kBot + "--seconds 1000000 --save \"" + save +
        "\" & p=$!; until grep -q deliveries \"" + save + "\" 2>/dev/null; do sleep 0.05; done; kill -9 $p'";
    EXPECT_EQ(std::system(endless.c_str()), 0);
    EXPECT_GE(nlohmann::json::parse(fileText(save))["deliveries"], 1);
}

TEST(Save, IsNeitherReadNorWrittenHeadlessUnlessNamed) {
    flight(kBot + "--seconds 5");
    EXPECT_FALSE(std::filesystem::exists(scratch() / "config"));
    EXPECT_FALSE(std::filesystem::exists(scratch() / "data"));
}

TEST(Weather, OfAFlightIsSavedAsARecordingThatFliesTheSame) {
    auto const folder = scratch();
    for (std::string const source : {"", "--weather preset:storm "}) {
        std::string const file = (folder / "weather.json").string();
        auto const flown = flight(kBot + source + "--seconds 20 --save-weather '" + file + "'");
        auto const again =
            flight(kBot + "--seconds 20 --time 2023-06-23T18:40Z --weather 'recorded:" + file + "'");
        EXPECT_EQ(again["state_hash"], flown["state_hash"]) << source;
    }
}
}  // namespace
