// Test cards flown by the whole program: what the bot measured stands in the report, and the flight is a replay.
#include "tests/play/program.h"

namespace {
using luftpost::tests::flight;
using luftpost::tests::scratch;

std::string const kCard = "play --headless --no-render --bot card:";

TEST(Card, MeasuresTheStallAndTheReplayIsTheSameFlight) {
    std::string const file = (scratch() / "stall.replay").string();
    auto const report = flight(kCard + "stall --seconds 125 --save-replay '" + file + "'");
    EXPECT_EQ(report["card"]["name"], "stall");
    EXPECT_EQ(report["card"]["finished"], true);
    EXPECT_NEAR(report["card"]["items"]["stall_clean_kcas"], 50.5, 4.5);
    EXPECT_NEAR(report["card"]["items"]["stall_full_flap_kcas"], 45.0, 4.0);
    EXPECT_EQ(report["crashes"], 0);
    EXPECT_EQ(report["changed"]["aircraft.assist"], "sim");
    EXPECT_EQ(flight("replay '" + file + "'")["state_hash"], report["state_hash"]);
}

TEST(Card, LandsAcrossItsOwnWindAndTheReplayHasIt) {
    std::string const file = (scratch() / "crosswind.replay").string();
    auto const report = flight(kCard + "crosswind --seconds 75 --save-replay '" + file + "'");
    auto const& items = report["card"]["items"];
    EXPECT_NEAR(items["wind_across_kt"], 15.0, 3.0);
    EXPECT_LT(items["landing_off_m"], 12.0);
    EXPECT_LT(items["touchdown_mps"], 2.0);
    EXPECT_EQ(report["crashes"], 0);
    EXPECT_EQ(flight("replay '" + file + "'")["state_hash"], report["state_hash"]);
}

TEST(Card, SaysWhatItCouldNotFinish) {
    auto const report = flight(kCard + "ceiling --seconds 3");
    EXPECT_EQ(report["card"]["finished"], false);
    EXPECT_TRUE(report["card"]["items"].empty());
}

TEST(Card, FliesInTheWeatherThatIsAskedFor) {
    auto const report = flight(kCard + "landing --seconds 60 --weather preset:fair --payload 100");
    EXPECT_GT(std::abs(report["card"]["items"]["wind_across_kt"].get<double>()), 0.5);
    EXPECT_EQ(report["crashes"], 0);
}
}  // namespace
