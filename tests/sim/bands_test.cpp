// The default aircraft against its bands. Every figure is printed as a row of the table in docs/flight.md:
//   build/release/tests_sim --gtest_filter='Bands.*' | grep '^|'
#include <gtest/gtest.h>

#include "tests/sim/cards.h"

namespace luftpost::flight {
namespace {
/// One row: ours is within the band.
void expectIn(std::string const& item, double ours, double low, double high, std::string const& figure,
              int digits = 1) {
    fmt::print("| {} | {:.{}f} | {} | {:g} .. {:g} |\n", item, ours, digits, figure, low, high);
    EXPECT_GE(ours, low) << item;
    EXPECT_LE(ours, high) << item;
}
}  // namespace

TEST(Bands, TheStallComesAtThePublishedSpeeds) {
    expectIn("stall, power off, clean, KCAS", stallSpeed_kt(0.0), 46, 55, "51");
    expectIn("stall, power off, full flap, KCAS", stallSpeed_kt(1.0), 41, 49, "47");
}

TEST(Bands, TheGlideReachesAsFarAsPublished) {
    Best const glide = bestGlide();
    expectIn("best glide, ratio", glide.value, 8.5, 10.5, "9.1 (model 10.3)", 2);
    expectIn("best glide, KCAS", glide.speed_kt, 60, 82, "65 (model 80-84)", 0);
}

TEST(Bands, ItClimbsAsPublished) {
    Best const climb = bestClimb_fpm(20.0);
    expectIn("climb at sea level, ft/min", climb.value, 600, 850, "720", 0);
    expectIn("best climb, KCAS", climb.speed_kt, 70, 80, "73-76", 0);
    expectIn("service ceiling, ft", ceiling_ft(), 12000, 15000, "13,500", 0);
}

TEST(Bands, ItFliesLevelAsFastAsPublished) {
    expectIn("level speed at sea level, kt", levelSpeed_kt(), 115, 128, "123");
}

TEST(Bands, ItTakesOffAndLandsInThePublishedDistances) {
    Distances const off = takeOff(), on = landing(0.0);
    EXPECT_FALSE(off.crashed);
    EXPECT_FALSE(on.crashed);
    expectIn("take-off roll, ft", off.roll_ft, 600, 1200, "945", 0);
    expectIn("take-off over 50 ft, ft", off.over50ft_ft, 1100, 2200, "1685", 0);
    expectIn("landing roll, ft", on.roll_ft, 400, 900, "550", 0);
    expectIn("landing over 50 ft, ft", on.over50ft_ft, 900, 2000, "1295", 0);
    expectIn("touchdown, m/s", on.touchdown_mps, 0.05, 1.6, "(freight breaks at 1.6)", 2);
}

TEST(Bands, ItLandsInTheCrosswindThatWasShown) {
    for (double wind : {15.0, -15.0}) {
        Distances const on = landing(wind);
        EXPECT_FALSE(on.crashed) << wind;
        expectIn(fmt::format("landing, {} kt across, off the line, m", wind), on.off_m, 0, 12, "lands");
        expectIn(fmt::format("landing, {} kt across, touchdown, m/s", wind), on.touchdown_mps, 0.05, 2.0,
                 "lands", 2);
    }
}

TEST(Bands, ThePhugoidIsSlowAndDamped) {
    Oscillation const mode = phugoid();
    expectIn("phugoid, s", mode.period_s, 18, 32, "24.9");
    expectIn("phugoid, damping", mode.damping, 0.03, 0.2, "0.095", 3);
}

TEST(Bands, TheShortPeriodIsQuickAndDamped) {
    Oscillation const mode = shortPeriod();
    expectIn("short period, s", mode.period_s, 0.9, 2.2, "1.28", 2);
    expectIn("short period, damping", mode.damping, 0.35, 0.9, "0.63", 2);
}

TEST(Bands, TheDutchRollIsSlowAndDamped) {
    Oscillation const mode = dutchRoll();
    expectIn("Dutch roll, s", mode.period_s, 2, 4.5, "2.71", 2);
    expectIn("Dutch roll, damping", mode.damping, 0.08, 0.35, "0.20", 2);
}

TEST(Bands, ItRollsAsFastAsTheModel) {
    expectIn("roll, full aileron at 100 kt, deg/s", fullAileron(100.0).rate_dps, 45, 80, "63");
    expectIn("roll, full aileron at 70 kt, deg/s", fullAileron(70.0).rate_dps, 30, 55, "41");
    expectIn("roll, time constant, s", fullAileron(100.0).timeConstant_s, 0.02, 0.4, "0.14", 2);
}

TEST(Bands, TheSpiralIsSlow) {
    for (double kt : {60.0, 100.0}) {
        double const doubling = spiralDoubling_s(kt);
        fmt::print(
            "| spiral at {:.0f} kt, s to double (negative: halve) | {:.0f} | {} | slower than 12 either way "
            "|\n",
            kt, doubling, kt == 60.0 ? "17" : "-37");
        EXPECT_GT(std::abs(doubling), 12.0) << kt;
    }
}

TEST(Bands, LevelTrimHasThePublishedAnglesOfAttack) {
    struct Row {
        double kt, alpha_deg;
    };
    for (Row row : {Row{60, 9.9}, Row{76, 4.8}, Row{100, 1.35}, Row{120, -0.1}}) {
        TestFlight flight;
        flight.inAir(304.8, fromKnots(row.kt));
        expectIn(fmt::format("level trim at {} kt, alpha, deg", row.kt), core::degrees(flight.now().alpha),
                 row.alpha_deg - 2.5, row.alpha_deg + 2.5, fmt::format("{}", row.alpha_deg));
    }
}

TEST(Bands, AnElevatorPulseRaisesTheNoseAndIsGone) {
    Pulse const pulse = elevatorPulse();
    expectIn("elevator 0.1 for 0.5 s, alpha, deg", pulse.alpha_deg, 0.5, 3.5, "1.7", 2);
    expectIn("elevator 0.1 for 0.5 s, q, deg/s", pulse.pitchRate_dps, 2, 14, "6.7", 2);
    expectIn("1.5 s later, alpha, deg", pulse.leftAlpha_deg, -0.3, 0.3, "gone", 2);
    expectIn("1.5 s later, q, deg/s", pulse.leftPitchRate_dps, -0.7, 0.7, "gone", 2);
}

TEST(Bands, TurbulenceIsFeltAsPublished) {
    expectIn("Dryden, W20 25 ft/s, load factor rms, g", gustLoad_g(25.0), 0.05, 0.1, "0.076", 3);
    expectIn("Dryden, W20 50 ft/s, load factor rms, g", gustLoad_g(50.0), 0.1, 0.2, "0.151", 3);
    expectIn("Dryden, W20 75 ft/s, load factor rms, g", gustLoad_g(75.0), 0.15, 0.3, "0.222", 3);
}
}  // namespace luftpost::flight
