// The default aircraft against its bands, flown by the bot's test cards. Every figure is printed as a row of the table in
// docs/flight.md:   build/release/tests_sim --gtest_filter='Bands.*' | grep '^|'
#include <gtest/gtest.h>

#include <random>

#include "tests/sim/cards.h"

namespace luftpost::flight {
namespace {
struct Band {
    char const* key;
    char const* item;
    char const* figure;  // that ours is held to
    double low, high;
    int digits = 1;
};

/// One row: ours is within the band.
void expectIn(Band const& band, double ours) {
    fmt::print("| {} | {:.{}f} | {} | {:g} .. {:g} |\n", band.item, ours, band.digits, band.figure, band.low,
               band.high);
    EXPECT_GE(ours, band.low) << band.item;
    EXPECT_LE(ours, band.high) << band.item;
}

FlownCard expectCard(FlownCard const& flown, std::initializer_list<Band> bands) {
    EXPECT_TRUE(flown.finished);
    EXPECT_FALSE(flown.crashed);
    for (Band const& band : bands) expectIn(band, flown.at(band.key));
    return flown;
}

/// rms of the load factor about 1 in Dryden turbulence at 100 kt and 500 ft, for a wind at 20 ft in ft/s.
double gustLoad_g(double w20_fps) {
    // Vertical gusts of the Dryden spectrum (MIL-F-8785C) frozen along the way: a sum of waves with random
    // phases.
    constexpr int kWaves = 400;
    double const scale = 500.0 * core::kMetresPerFoot, sigma = 0.1 * w20_fps * core::kMetresPerFoot;
    std::mt19937 random{7};
    std::vector<double> number(kWaves), size(kWaves), phase(kWaves);
    double const low = 0.02 / scale, high = 200.0 / scale, ratio = std::pow(high / low, 1.0 / kWaves);
    for (std::size_t i = 0; i < kWaves; ++i) {
        double const k = low * std::pow(ratio, static_cast<double>(i) + 0.5), lk = scale * k;
        double const spectrum =
            sigma * sigma * scale / core::kPi * (1.0 + 3.0 * lk * lk) / std::pow(1.0 + lk * lk, 2.0);
        number[i] = k;
        size[i] = std::sqrt(2.0 * spectrum * k * (std::sqrt(ratio) - 1.0 / std::sqrt(ratio)));
        phase[i] = 2.0 * core::kPi * (static_cast<double>(random()) / 4294967296.0);
    }
    TestFlight flight;
    flight.air = [&](glm::dvec3 const& p, core::UtcSeconds) {
        core::AirSample sample = isaAir(p.y);
        for (std::size_t i = 0; i < kWaves; ++i)
            sample.windWorld.y += size[i] * std::cos(number[i] * p.z + phase[i]);
        return sample;
    };
    flight.inAir(500.0 * core::kMetresPerFoot, fromKnots(100.0));
    bot::TestPilot pilot;
    double squares = 0.0;
    int count = 0;
    flight.fly(60.0, [&](double t) {
        pilot.look(flight.state());
        pilot.holdWings();
        flight.stick = pilot.stick;
        if (t > 3.0) squares += std::pow(flight.now().loadFactor - 1.0, 2.0), ++count;
        return true;
    });
    return std::sqrt(squares / count);
}
}  // namespace

TEST(Bands, TheStallComesAtThePublishedSpeeds) {
    expectCard(flownCard("stall"), {{"stall_clean_kcas", "stall, power off, clean, KCAS", "51", 46, 55},
                                    {"stall_full_flap_kcas", "stall, power off, full flap, KCAS", "47", 41, 49}});
}

TEST(Bands, TheGlideReachesAsFarAsPublished) {
    expectCard(flownCard("glide"), {{"glide_ratio", "best glide, ratio", "9.1 (model 10.3)", 8.5, 10.5, 2},
                                    {"glide_kcas", "best glide, KCAS", "65 (model 80-84)", 60, 82, 0}});
}

TEST(Bands, ItClimbsAsPublished) {
    expectCard(flownCard("climb"), {{"climb_fpm", "climb at sea level, ft/min", "720", 600, 850, 0},
                                    {"climb_kcas", "best climb, KCAS", "73-76", 70, 80, 0}});
}

TEST(Bands, ItsCeilingIsAsHighAsPublished) {
    expectCard(flownCard("ceiling"), {{"ceiling_ft", "service ceiling, ft", "13,500", 12000, 15000, 0}});
}

TEST(Bands, ItFliesLevelAsFastAsPublished) {
    expectCard(flownCard("level"), {{"level_kcas", "level speed at sea level, kt", "123", 115, 128}});
}

TEST(Bands, ItTakesOffInThePublishedDistances) {
    expectCard(flownCard("takeoff"), {{"takeoff_roll_ft", "take-off roll, ft", "945", 600, 1200, 0},
                                      {"takeoff_over_50_ft", "take-off over 50 ft, ft", "1685", 1100, 2200, 0}});
}

TEST(Bands, ItLandsInThePublishedDistances) {
    expectCard(flownCard("landing"), {{"landing_roll_ft", "landing roll, ft", "550", 400, 900, 0},
                                      {"landing_over_50_ft", "landing over 50 ft, ft", "1295", 900, 2000, 0},
                                      {"touchdown_mps", "touchdown, m/s", "(freight breaks at 1.6)", 0.05, 1.6, 2}});
}

TEST(Bands, ItLandsInTheCrosswindThatWasShown) {
    expectCard(flownCard("crosswind", 15.0),
               {{"landing_off_m", "landing, 15 kt across, off the line, m", "lands", 0, 12},
                {"touchdown_mps", "landing, 15 kt across, touchdown, m/s", "lands", 0.05, 2, 2}});
    expectCard(flownCard("crosswind", -15.0),
               {{"landing_off_m", "landing, -15 kt across, off the line, m", "lands", 0, 12},
                {"touchdown_mps", "landing, -15 kt across, touchdown, m/s", "lands", 0.05, 2, 2}});
}

TEST(Bands, ThePhugoidIsSlowAndDamped) {
    expectCard(flownCard("phugoid"), {{"phugoid_s", "phugoid, s", "24.9", 18, 32},
                                      {"phugoid_damping", "phugoid, damping", "0.095", 0.03, 0.2, 3}});
}

TEST(Bands, TheShortPeriodIsQuickAndDampedAndAPulseIsGone) {
    expectCard(flownCard("shortperiod"),
               {{"short_period_s", "short period, s", "1.28", 0.9, 2.2, 2},
                {"short_period_damping", "short period, damping", "0.63", 0.35, 0.9, 2},
                {"pulse_alpha_deg", "elevator 0.1 for 0.5 s, alpha, deg", "1.7", 0.5, 3.5, 2},
                {"pulse_q_dps", "elevator 0.1 for 0.5 s, q, deg/s", "6.7", 2, 14, 2},
                {"pulse_alpha_left_deg", "1.5 s later, alpha, deg", "gone", -0.3, 0.3, 2},
                {"pulse_q_left_dps", "1.5 s later, q, deg/s", "gone", -0.7, 0.7, 2}});
}

TEST(Bands, TheDutchRollIsSlowAndDamped) {
    expectCard(flownCard("dutchroll"), {{"dutch_roll_s", "Dutch roll, s", "2.71", 2, 4.5, 2},
                                        {"dutch_roll_damping", "Dutch roll, damping", "0.20", 0.08, 0.35, 2}});
}

TEST(Bands, ItRollsAsFastAsTheModel) {
    expectCard(flownCard("roll"), {{"roll_cruise_dps", "roll, full aileron at 100 kt, deg/s", "63", 45, 80},
                                   {"roll_slow_dps", "roll, full aileron at 70 kt, deg/s", "41", 30, 55},
                                   {"roll_time_constant_s", "roll, time constant, s", "0.14", 0.02, 0.4, 2}});
}

TEST(Bands, TheSpiralIsSlow) {
    FlownCard const flown = expectCard(flownCard("spiral"), {});
    struct Row {
        char const *key, *item, *figure;
    };
    for (Row const& row : {Row{"spiral_slow_doubling_s", "spiral at 60 kt", "17"},
                           Row{"spiral_cruise_doubling_s", "spiral at 100 kt", "-37"}}) {
        fmt::print("| {}, s to double (negative: halve) | {:.0f} | {} | slower than 12 either way |\n", row.item,
                   flown.at(row.key), row.figure);
        EXPECT_GT(std::abs(flown.at(row.key)), 12.0) << row.item;
    }
}

TEST(Bands, LevelTrimHasThePublishedAnglesOfAttack) {
    expectCard(flownCard("trim"),
               {{"trim_60_kcas_alpha_deg", "level trim at 60 kt, alpha, deg", "9.9", 7.4, 12.4},
                {"trim_76_kcas_alpha_deg", "level trim at 76 kt, alpha, deg", "4.8", 2.3, 7.3},
                {"trim_100_kcas_alpha_deg", "level trim at 100 kt, alpha, deg", "1.35", -1.15, 3.85},
                {"trim_120_kcas_alpha_deg", "level trim at 120 kt, alpha, deg", "-0.1", -2.6, 2.4}});
}

/// The freight plane at its gross weight, 1633 kg. Performance: Cessna U206G, published figures; motion: level 1 of MIL-F-8785C
/// for a light aircraft.
FlownCard freightCard(std::string const& name, double windFromRight_kt = 0.0) {
    TestFlight flight{512.0, 150.0, "freight_plane"};
    flight.wind = {-fromKnots(windFromRight_kt), 0.0, 0.0};
    return flownCard(name, flight);
}

TEST(FreightBands, ItsSpeedsAreAsPublished) {
    expectCard(freightCard("stall"), {{"stall_clean_kcas", "stall, power off, clean, KCAS", "62", 57, 67},
                                      {"stall_full_flap_kcas", "stall, power off, full flap, KCAS", "54", 49, 59}});
    expectCard(freightCard("level"), {{"level_kcas", "level speed at sea level, kt", "156", 148, 163}});
}

TEST(FreightBands, ItClimbsAndGlidesAsPublished) {
    expectCard(freightCard("glide"), {{"glide_ratio", "best glide, ratio", "9.1", 8.5, 10.5, 2}});
    expectCard(freightCard("climb"), {{"climb_fpm", "climb at sea level, ft/min", "920", 770, 1080, 0},
                                      {"climb_kcas", "best climb, KCAS", "84", 76, 92, 0}});
    expectCard(freightCard("ceiling"), {{"ceiling_ft", "service ceiling, ft", "14,800", 13000, 16500, 0}});
}

TEST(FreightBands, ItTakesOffAndLandsInThePublishedDistances) {
    expectCard(freightCard("takeoff"), {{"takeoff_roll_ft", "take-off roll, ft", "900", 570, 1140, 0},
                                        {"takeoff_over_50_ft", "take-off over 50 ft, ft", "1780", 1160, 2320, 0}});
    expectCard(freightCard("landing"), {{"landing_roll_ft", "landing roll, ft", "735", 530, 1200, 0},
                                        {"landing_over_50_ft", "landing over 50 ft, ft", "1395", 970, 2150, 0},
                                        {"touchdown_mps", "touchdown, m/s", "(freight breaks at 1.6)", 0.05, 1.6, 2}});
    expectCard(freightCard("crosswind", 15.0),
               {{"landing_off_m", "landing, 15 kt across, off the line, m", "lands", 0, 12},
                {"touchdown_mps", "landing, 15 kt across, touchdown, m/s", "lands", 0.05, 2, 2}});
}

TEST(FreightBands, ItMovesAsALightAircraftShould) {
    expectCard(freightCard("phugoid"), {{"phugoid_damping", "phugoid, damping", "> 0.04", 0.04, 0.3, 3}});
    expectCard(freightCard("shortperiod"), {{"short_period_damping", "short period, damping", "0.35 .. 1.3", 0.35, 1.3, 2}});
    expectCard(freightCard("dutchroll"), {{"dutch_roll_damping", "Dutch roll, damping", "> 0.08", 0.08, 0.5, 2}});
    expectCard(freightCard("roll"), {{"roll_cruise_dps", "roll, full aileron at 122 kt, deg/s", "(mail plane 65)", 45, 95},
                                     {"roll_time_constant_s", "roll, time constant, s", "< 1", 0.02, 1.0, 2}});
    FlownCard const spiral = expectCard(freightCard("spiral"), {});
    double const slow = spiral.at("spiral_slow_doubling_s");
    fmt::print("| spiral at 73 kt, s to double (negative: halve) | {:.0f} | > 12 | slower than 12 either way |\n", slow);
    EXPECT_GT(std::abs(slow), 12.0);
}

TEST(Bands, TurbulenceIsFeltAsPublished) {
    expectIn({"", "Dryden, W20 25 ft/s, load factor rms, g", "0.076", 0.05, 0.1, 3}, gustLoad_g(25.0));
    expectIn({"", "Dryden, W20 50 ft/s, load factor rms, g", "0.151", 0.1, 0.2, 3}, gustLoad_g(50.0));
    expectIn({"", "Dryden, W20 75 ft/s, load factor rms, g", "0.222", 0.15, 0.3, 3}, gustLoad_g(75.0));
}
}  // namespace luftpost::flight
