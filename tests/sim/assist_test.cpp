// What each level of assist promises, and that each of the seven parameters acts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/test_flight.h"

namespace luftpost::flight {
namespace {
double degreesOf(double angle) { return core::degrees(angle); }

/// Gusts of a few m/s over a hundred metres and less, on a wind from the west: a rough day.
void roughen(TestFlight& flight) {
    flight.air = [](glm::dvec3 const& p, core::UtcSeconds t) {
        core::AirSample sample = isaAir(p.y);
        sample.windWorld = {12.0 + 2.0 * std::sin(0.05 * p.z + 0.3 * t),
                            2.0 * std::sin(0.04 * p.z + 0.02 * p.x), 2.0 * std::sin(0.06 * p.x + 0.03 * p.z)};
        return sample;
    };
}
/// The largest roll rate in a second of full stick to the right, deg/s.
double rollRate_dps(AssistSettings const& settings, double stick = 1.0,
                    AssistLevel level = AssistLevel::normal) {
    TestFlight flight{level, settings};
    flight.inAir(600.0, 52.0);
    double most = 0.0;
    flight.stick.aileron = stick;
    flight.fly(0.8, [&](double) { return most = std::max(most, flight.now().rollRate), true; });
    return degreesOf(most);
}
}  // namespace

TEST(Assist, NormalFliesItselfHandsOffInRoughAirForMinutes) {
    for (AssistLevel level : {AssistLevel::normal, AssistLevel::easy}) {
        TestFlight flight{level};
        roughen(flight);
        flight.inAir(600.0, 52.0);
        double bank = 0.0, off = 0.0, slowest = 1e9;
        flight.fly(300.0, [&](double) {
            bank = std::max(bank, std::abs(flight.now().roll));
            off = std::max(off, std::abs(flight.state().positionWorld.y - 600.0));
            slowest = std::min(slowest, flight.now().cas);
            return true;
        });
        fmt::print("hands off, rough air, 300 s: bank {:.1f} deg, height off {:.1f} m, slowest {:.1f} m/s\n",
                   degreesOf(bank), off, slowest);
        EXPECT_LT(degreesOf(bank), 20.0);
        EXPECT_LT(off, 40.0);
        EXPECT_GT(slowest, 40.0);
        EXPECT_FALSE(flight.state().crashed());
    }
}

TEST(Assist, NormalCannotBeStalledOrRolledOver) {
    for (AssistLevel level : {AssistLevel::normal, AssistLevel::easy}) {
        TestFlight flight{level};
        roughen(flight);
        flight.inAir(900.0, 45.0);
        flight.stick = Controls{.throttle = 0.0, .elevator = 1.0};
        double stalled = 0.0, bank = 0.0;
        flight.fly(60.0, [&](double t) {
            flight.stick.aileron = t > 30.0 ? 1.0 : 0.0;
            stalled = std::max(stalled, flight.now().stalled);
            bank = std::max(bank, std::abs(flight.now().roll));
            return true;
        });
        fmt::print("full back, idle, then full aileron: stalled {:.2f}, bank {:.1f} deg\n", stalled,
                   degreesOf(bank));
        EXPECT_LT(stalled, 0.35);
        EXPECT_LT(degreesOf(bank), 75.0);
        EXPECT_GT(flight.now().cas, 25.0);
    }
}

TEST(Assist, NormalStaysBelowTheNeverExceedSpeed) {
    TestFlight flight{AssistLevel::normal};
    flight.inAir(2500.0, 60.0);
    flight.stick = Controls{.throttle = 1.0, .elevator = -1.0};
    double fastest = 0.0;
    flight.fly(40.0, [&](double) { return fastest = std::max(fastest, flight.now().cas), true; });
    EXPECT_LT(fastest, 1.05 * flight.aircraft.airframe().neverExceedSpeed);
}

TEST(Assist, NormalHoldsTheBankedTurnsHeight) {
    TestFlight flight{AssistLevel::normal, AssistSettings{.stabilizingRoll = 0.0}};
    flight.inAir(600.0, 52.0);
    flight.fly(0.7, [&](double) { return flight.stick.aileron = 1.0, true; });
    flight.stick.aileron = 0.0;
    flight.fly(20.0);
    EXPECT_NEAR(degreesOf(flight.now().roll), 38.0, 8.0);
    EXPECT_NEAR(flight.state().positionWorld.y, 600.0, 12.0);
    EXPECT_LT(std::abs(degreesOf(flight.now().beta)), 2.0) << "the ball is in the middle";
}

TEST(Assist, EasyHoldsHeightAndSpeedAndPointsWhereOneSteers) {
    TestFlight flight{AssistLevel::easy};
    flight.inAir(600.0, 50.0);
    double const cas = flight.now().cas;
    flight.fly(30.0);
    EXPECT_NEAR(flight.state().positionWorld.y, 600.0, 3.0);
    EXPECT_NEAR(flight.now().cas, cas, 1.0);
    flight.stick.elevator = 0.5;
    flight.fly(6.0);
    EXPECT_GT(flight.now().climb, 3.0);
    flight.stick.elevator = 0.0;
    flight.stick.aileron = 0.6;
    flight.fly(8.0);
    EXPECT_NEAR(degreesOf(flight.now().roll), 30.0, 4.0);
    EXPECT_GT(degreesOf(flight.now().heading), 40.0);
    flight.stick.aileron = 0.0;
    flight.fly(15.0);
    EXPECT_NEAR(degreesOf(flight.now().roll), 0.0, 2.0);
    EXPECT_NEAR(flight.now().climb, 0.0, 0.5);
}

TEST(Assist, EasyLandsByItselfWithTheLeverBack) {
    TestFlight flight{AssistLevel::easy};
    flight.inAir(120.0, 45.0);
    flight.fly(150.0, [&](double) {
        flight.stick.throttle = 0.0;
        flight.stick.elevator = flight.now().height > 18.0 ? -0.3 : 0.0;
        return !flight.state().crashed() && !(flight.now().onGround && flight.now().groundSpeed < 1.0);
    });
    EXPECT_FALSE(flight.state().crashed());
    EXPECT_TRUE(flight.now().onGround);
    EXPECT_LT(flight.state().touchdownSpeed, 1.6);
    EXPECT_LT(flight.now().groundSpeed, 1.0);
}

TEST(Assist, NormalLandsByAPlainFlare) {
    TestFlight flight{AssistLevel::normal};
    flight.wind = {2.0, 0.0, 3.0};
    flight.inAir(100.0, 36.0);
    flight.fly(120.0, [&](double) {
        Readings const& now = flight.now();
        flight.stick = Controls{.throttle = now.height > 7.0 ? 0.35 : 0.1, .flaps = 1.0};
        if (now.onGround)
            flight.stick = Controls{.flaps = 1.0, .brakes = 0.7};
        else if (now.height > 7.0)
            flight.stick.elevator = now.climb > -2.2 ? -0.1 : 0.0;
        else
            flight.stick.elevator = now.climb < -0.7 ? 0.35 : 0.0;
        return !flight.state().crashed() && !(now.onGround && now.groundSpeed < 1.0);
    });
    fmt::print("normal, plain flare: touchdown at {:.2f} m/s\n", flight.state().touchdownSpeed);
    EXPECT_FALSE(flight.state().crashed()) << crashText(flight.aircraft.airframe(), flight.state());
    EXPECT_TRUE(flight.now().onGround);
    EXPECT_LT(flight.state().touchdownSpeed, 2.2);
}

TEST(Assist, LightKeepsTheBallInTheMiddleWhereSimDoesNot) {
    double slip[2];
    for (int i = 0; i < 2; ++i) {
        TestFlight flight{i == 0 ? AssistLevel::sim : AssistLevel::light};
        flight.inAir(600.0, 45.0);
        flight.stick.aileron = 0.7;
        slip[i] = 0.0;
        flight.fly(1.2,
                   [&](double) { return slip[i] = std::max(slip[i], std::abs(flight.now().beta)), true; });
    }
    fmt::print("adverse yaw of 0.7 aileron: sim {:.1f} deg of slip, light {:.1f}\n", degreesOf(slip[0]),
               degreesOf(slip[1]));
    EXPECT_LT(slip[1], 0.6 * slip[0]);
}

TEST(Assist, EveryLevelTakesOff) {
    for (AssistLevel level : {AssistLevel::sim, AssistLevel::light, AssistLevel::normal, AssistLevel::easy}) {
        TestFlight flight{level};
        flight.onRunway();
        flight.stick = Controls{.throttle = 1.0, .flaps = 1.0 / 3.0};
        flight.fly(40.0, [&](double) {
            double const heading = flight.now().heading > core::kPi ? flight.now().heading - 2.0 * core::kPi
                                                                    : flight.now().heading;
            flight.stick.rudder = std::clamp(
                -5.0 * heading - 2.0 * flight.now().yawRate - 0.08 * flight.state().positionWorld.x, -1.0,
                1.0);
            flight.stick.aileron = std::clamp(-1.5 * flight.now().roll, -0.3, 0.3);
            flight.stick.elevator = flight.now().cas < 27.0 ? 0.0 : flight.now().pitch < 0.12 ? 0.4 : 0.05;
            return flight.now().height < 30.0 && !flight.state().crashed();
        });
        EXPECT_FALSE(flight.state().crashed()) << static_cast<int>(level);
        EXPECT_GT(flight.now().height, 29.0) << static_cast<int>(level);
        EXPECT_LT(std::abs(flight.state().positionWorld.x), 15.0) << static_cast<int>(level);
    }
}

TEST(Assist, AHardPullAtTakeOffDoesNotSinkBack) {
    for (AssistLevel level : {AssistLevel::normal, AssistLevel::easy}) {
        TestFlight flight{level};
        flight.onRunway();
        double sunk = 0.0, highest = 0.0;
        flight.fly(45.0, [&](double t) {
            flight.stick = Controls{.throttle = 1.0, .flaps = 1.0 / 3.0};
            flight.stick.elevator = t < 17.0 ? 0.0 : t < 20.0 ? 0.5 : t < 30.0 ? 0.2 : 0.0;
            highest = std::max(highest, flight.now().height);
            sunk = std::max(sunk, highest - flight.now().height);
            return !flight.state().crashed();
        });
        fmt::print("hard pull at take-off: highest {:.0f} m, sank back {:.1f} m, {:.1f} m/s\n", highest, sunk,
                   flight.now().cas);
        EXPECT_FALSE(flight.state().crashed());
        EXPECT_GT(flight.now().height, 12.0);
        EXPECT_LT(sunk, 3.0);
    }
}

TEST(Assist, RollSpeedIsTheRateOfTheFullStick) {
    for (double speed : {20.0, 40.0, 60.0, 90.0})
        EXPECT_NEAR(rollRate_dps({.rollSpeed_dps = speed}), speed, 0.15 * speed);
    EXPECT_GT(rollRate_dps({.rollSpeed_dps = 120.0}), 95.0);
}

TEST(Assist, RollFactorIsTheShareOfTheRollCommand) {
    EXPECT_LT(rollRate_dps({.rollFactor = 0.0}), 3.0);
    EXPECT_NEAR(rollRate_dps({.rollFactor = 0.5}), 30.0, 5.0);
    EXPECT_NEAR(rollRate_dps({.rollFactor = 2.0}, 0.5), 60.0, 9.0);
}

TEST(Assist, PitchSpeedIsTheRateOfTheFullStick) {
    for (double speed : {5.0, 15.0, 25.0}) {
        TestFlight flight{AssistLevel::normal, AssistSettings{.pitchSpeed_dps = speed}};
        flight.inAir(600.0, 60.0);
        flight.stick.elevator = 1.0;
        flight.fly(1.2);
        double const before = flight.now().pitch;
        flight.fly(0.4);
        EXPECT_NEAR(degreesOf(flight.now().pitch - before) / 0.4, speed, 0.3 * speed) << speed;
    }
}

TEST(Assist, YawSpeedScalesThePedal) {
    double swung[3];
    double const speeds[3] = {5.0, 15.0, 45.0};
    for (int i = 0; i < 3; ++i) {
        TestFlight flight{AssistLevel::normal, AssistSettings{.yawSpeed_dps = speeds[i]}};
        flight.inAir(600.0, 52.0);
        flight.stick.rudder = 1.0;
        flight.fly(1.0);
        swung[i] = degreesOf(flight.now().heading);
    }
    fmt::print("full pedal for 1 s swings the nose by {:.1f}, {:.1f}, {:.1f} deg\n", swung[0], swung[1],
               swung[2]);
    EXPECT_GT(swung[0], 1.5);
    EXPECT_GT(swung[1], 1.5 * swung[0]);
    EXPECT_GT(swung[2], 1.3 * swung[1]);
}

TEST(Assist, StabilizingRollIsTheRateToWingsLevel) {
    for (double rate : {0.0, 0.5, 1.0, 3.0}) {
        TestFlight flight{AssistLevel::normal, AssistSettings{.stabilizingRoll = rate}};
        flight.inAir(600.0, 52.0);
        flight.stick.aileron = 1.0;
        flight.fly(0.8);
        flight.stick.aileron = 0.0;
        flight.fly(1.0);
        double const before = flight.now().roll;
        flight.fly(1.0);
        EXPECT_NEAR(flight.now().roll / before, std::exp(-rate), 0.12) << rate;
    }
}

TEST(Assist, InducedYawFactorIsTheShareOfTheCoordinatedTurn) {
    double turned[3];
    double const factors[3] = {0.0, 1.0, 2.0};
    double expected = 0.0;
    for (int i = 0; i < 3; ++i) {
        TestFlight flight{AssistLevel::normal,
                          AssistSettings{.stabilizingRoll = 0.0, .inducedYawFactor = factors[i]}};
        flight.inAir(600.0, 52.0);
        flight.stick.aileron = 1.0;
        flight.fly(0.45);
        flight.stick.aileron = 0.0;
        flight.fly(1.0);
        double const before = flight.now().heading;
        expected = core::kGravity * std::tan(flight.now().roll) / flight.now().tas * 3.0;
        flight.fly(3.0);
        turned[i] = flight.now().heading - before;
        if (i == 1) {
            EXPECT_NEAR(turned[i] / expected, 1.0, 0.15);
        }
    }
    fmt::print("turn in 3 s: factor 0 {:.1f}, 1 {:.1f}, 2 {:.1f} deg\n", degreesOf(turned[0]),
               degreesOf(turned[1]), degreesOf(turned[2]));
    EXPECT_LT(turned[0], 0.6 * turned[1]);
    EXPECT_GT(turned[2], 1.2 * turned[1]);
}

TEST(Assist, MaxThrottleScalesThePowerAtEveryLevel) {
    for (AssistLevel level : {AssistLevel::sim, AssistLevel::light, AssistLevel::normal, AssistLevel::easy}) {
        double thrust[3];
        double const shares[3] = {0.2, 1.0, 2.0};
        for (int i = 0; i < 3; ++i) {
            TestFlight flight{level, AssistSettings{.maxThrottle = shares[i]}};
            flight.inAir(600.0, 45.0);
            flight.stick.throttle = 1.0;
            flight.fly(3.0);
            thrust[i] = flight.now().thrust;
        }
        EXPECT_LT(thrust[0], 0.5 * thrust[1]) << static_cast<int>(level);
        EXPECT_GT(thrust[2], 1.4 * thrust[1]) << static_cast<int>(level);
    }
}
}  // namespace luftpost::flight
