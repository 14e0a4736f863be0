// The bot takes off, flies a circuit and lands in a strong wind across the runway, on five lands.
#include "engine/core/frames.h"
#include "engine/terrain/land.h"
#include "tests/play/program.h"

namespace {
using namespace luftpost;
using luftpost::tests::flight;
using luftpost::tests::scratch;

constexpr double kElevation = 300.0;  // m, of the airfield

/// 30 kt from 30 degrees to the right of the runway's heading, gusts to 49 kt: 1.7 m/s rms up and down, a little over the 1.5 m/s
/// of moderate turbulence at that wind (MIL-F-8785C).
std::string windyRecording(unsigned seed) {
    double const heading_deg = core::degrees(terrain::Land{seed, kElevation}.runway().heading);
    std::string const file = (scratch() / "windy.json").string();
    nlohmann::json const report{{"time", "2023-06-23T18:00Z"},
                                {"wind", {{"speed_mps", 15.4}, {"gust_mps", 25.0}, {"from_deg", heading_deg + 30.0}}},
                                {"visibility_m", 30000},
                                {"temperature_c", 12},
                                {"dew_point_c", 4},
                                {"pressure_hpa", 1005},
                                {"layers", nlohmann::json::array()}};
    nlohmann::json const site{{"name", "windy"}, {"lat", 47.5}, {"lon", 7.5}, {"elevation_m", kElevation}, {"reports", {report}}};
    luftpost::tests::writeText(file, nlohmann::json{{"format", "luftpost-weather-1"}, {"name", "30 kt across the runway"}, {"source", "composed"}, {"licence", "MIT"}, {"sites", {site}}}.dump());
    return file;
}

void expectCircuit(std::string const& who, unsigned seed, std::string const& options, double hardest, double farthest = 600.0) {
    auto const report = flight("play --headless --no-render --bot circuit --seconds 330 --seed " + std::to_string(seed) +
                               " --weather 'recorded:" + windyRecording(seed) + "' " + options);
    auto const& items = report["card"]["items"];
    std::printf("| circuit, %s | %.2f m/s | %.1f m | %.0f m |\n", who.c_str(), items.value("touchdown_mps", -1.0),
                items.value("landing_off_m", -1.0), items.value("stopped_at_m", -1.0));
    EXPECT_EQ(report["crashes"], 0);
    ASSERT_EQ(report["card"]["finished"], true);
    EXPECT_LT(items["touchdown_mps"], hardest);
    EXPECT_LT(items["landing_off_m"], 8.0) << "15 m are half the runway";
    EXPECT_GT(items["touchdown_along_m"], 0.0);
    EXPECT_LT(items["stopped_at_m"], farthest) << "the runway has 900 m";
}

class Circuit : public testing::TestWithParam<unsigned> {};
TEST_P(Circuit, IsFlownAndLandedInThirtyKnotsThirtyDegreesOffTheRunway) {
    expectCircuit("seed " + std::to_string(GetParam()), GetParam(), "", 1.6);
}

class AssistedCircuit : public testing::TestWithParam<char const*> {};
TEST_P(AssistedCircuit, IsFlownAndLandedInTheSameWind) {
    std::string const level = GetParam();
    expectCircuit("assist " + level, 1, "--assist " + level, 1.6, level == "easy" ? 750.0 : 600.0);  // easy lands by itself, slowly
}
INSTANTIATE_TEST_SUITE_P(Levels, AssistedCircuit, testing::Values("light", "normal", "easy"));

TEST(FreightCircuit, IsFlownAndLandedInTheSameWindAndBreaksNothing) {
    expectCircuit("freight plane", 1, "--set aircraft.airframe=freight_plane --payload 512 --fuel 150", 1.6);
}
INSTANTIATE_TEST_SUITE_P(Seeds, Circuit, testing::Values(1u, 2u, 3u, 4u, 5u));
}  // namespace
