// Wheels, touchdown, crash.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/flight/trim.h"
#include "tests/sim/test_flight.h"

namespace luftpost::flight {
namespace {
/// Dropped from `height` m above the runway, wings level, at 30 m/s with a sink of `sink` m/s and a bank.
TestFlight& touchedDown(TestFlight& flight, double sink, double bank_deg,
                        core::Surface surface = core::Surface::runway) {
    flight.ground = [surface](double, double) {
        return core::GroundSample{.height = 0.0, .surface = surface};
    };
    flight.inAir(2.2, 30.0);
    AircraftState state = flight.state();
    state.velocityWorld.y = -sink;
    state.worldFromBody = attitude(0.0, 0.06, core::radians(bank_deg));
    flight.aircraft.restore(state);
    flight.stick.throttle = 0.0;
    flight.fly(2.0, [&](double) { return !flight.state().crashed(); });
    return flight;
}
}  // namespace

TEST(Ground, ItStandsStillOnItsWheels) {
    TestFlight flight;
    flight.onRunway();
    flight.stick.brakes = 1.0;
    flight.fly(5.0);
    glm::dvec3 const place = flight.state().positionWorld;
    flight.fly(20.0);
    EXPECT_LT(glm::length(flight.state().positionWorld - place), 0.3);
    EXPECT_TRUE(flight.now().onGround);
    EXPECT_NEAR(flight.now().height, 0.0, 1e-9);
    EXPECT_NEAR(flight.now().loadFactor, 1.0, 0.02);
    double load = 0.0;
    for (WheelState const& wheel : flight.state().wheels) load += wheel.load;
    EXPECT_NEAR(load, 1100.0 * core::kGravity, 400.0);
    EXPECT_NEAR(flight.state().wheels[0].load / load, 0.22, 0.08) << "the nose wheel's share";
    EXPECT_FALSE(flight.state().crashed());
}

TEST(Ground, ItStandsInAGaleWithTheBrakesOn) {
    TestFlight flight;
    flight.wind = {0.0, 0.0, 18.0};
    flight.onRunway();
    flight.stick.brakes = 1.0;
    flight.fly(20.0);
    EXPECT_FALSE(flight.state().crashed());
    EXPECT_LT(flight.now().groundSpeed, 0.3);
}

TEST(Ground, TheNoseWheelSteersWhereThePedalPoints) {
    TestFlight flight;
    flight.onRunway();
    flight.stick = Controls{.throttle = 0.25, .rudder = 1.0};
    flight.fly(12.0, [&](double) {
        if (flight.now().groundSpeed > 5.0) flight.stick.throttle = 0.0;
        return true;
    });
    EXPECT_GT(flight.now().heading, 0.5);
    EXPECT_LT(flight.now().heading, core::kPi);
    EXPECT_FALSE(flight.state().crashed());
}

TEST(Ground, ASoftTouchdownIsKeptAndAHardOneEndsTheFlight) {
    TestFlight soft, hard;
    touchedDown(soft, 1.2, 0.0);
    EXPECT_FALSE(soft.state().crashed());
    EXPECT_GE(soft.state().touchdownTick, 0);
    EXPECT_NEAR(soft.state().touchdownSpeed, 1.8, 0.6)
        << "1.2 m/s and a fall of 0.9 m, most of it carried by the wings";
    touchedDown(hard, 5.0, 0.0);
    EXPECT_EQ(hard.state().crash, CrashReason::hardLanding);
    EXPECT_NE(crashText(hard.aircraft.airframe(), hard.state()).find("too hard"), std::string::npos);
}

TEST(Ground, AWingTipOnTheGroundAndWaterEndTheFlightAndSayWhy) {
    TestFlight tip, wet;
    touchedDown(tip, 1.0, 35.0);
    EXPECT_EQ(tip.state().crash, CrashReason::strike);
    EXPECT_EQ(crashText(tip.aircraft.airframe(), tip.state()), "The right wing tip struck the ground");
    touchedDown(wet, 1.0, 0.0, core::Surface::water);
    EXPECT_EQ(wet.state().crash, CrashReason::water);
}

TEST(Ground, AWreckComesToRestAndRespawnFliesOnWhereItWas) {
    TestFlight flight;
    touchedDown(flight, 6.0, 0.0);
    ASSERT_TRUE(flight.state().crashed());
    flight.fly(5.0);
    EXPECT_LT(glm::length(flight.state().velocityWorld), 0.2);
    EXPECT_GT(flight.state().positionWorld.y, -0.1);
    glm::dvec3 const place = flight.state().positionWorld;
    flight.aircraft.respawn(300.0, flight.air, flight.ground, flight.time);
    EXPECT_FALSE(flight.state().crashed());
    EXPECT_NEAR(flight.state().positionWorld.y, 300.0, 1e-9);
    EXPECT_EQ(flight.state().positionWorld.x, place.x);
    EXPECT_EQ(flight.state().positionWorld.z, place.z);
    flight.stick = Controls{.throttle = flight.state().trim.throttle};
    flight.fly(10.0);
    EXPECT_NEAR(flight.state().positionWorld.y, 300.0, 3.0);
}

TEST(Start, InTheAirIsLevelTrimmedAndWithoutSlipInAnyWind) {
    TestFlight flight;
    flight.wind = {10.0, 0.0, -5.0};
    flight.inAir(1000.0, 52.0);
    EXPECT_NEAR(flight.now().tas, 52.0, 1e-9);
    EXPECT_NEAR(flight.now().beta, 0.0, 1e-9);
    EXPECT_NEAR(flight.now().roll, 0.0, 1e-9);
    EXPECT_NEAR(flight.now().loadFactor, 1.0, 0.02);
    flight.fly(30.0);
    EXPECT_NEAR(flight.state().positionWorld.y, 1000.0, 3.0);
    EXPECT_NEAR(flight.now().tas, 52.0, 0.2);
    EXPECT_NEAR(core::degrees(flight.now().roll), 0.0, 1.0);
}

TEST(Start, TooSlowOrWithoutFuelIsTheNearestThatCanBe) {
    TestFlight slow;
    slow.inAir(1000.0, 15.0);
    EXPECT_TRUE(std::isfinite(slow.state().trim.elevator));
    TestFlight dry{240.0, 0.0};
    dry.inAir(1000.0, 45.0);
    dry.fly(5.0);
    EXPECT_LT(dry.now().climb, 0.0);
    EXPECT_NEAR(dry.now().mass, 1000.0, 1e-9);
}

TEST(Start, TheStandardAtmosphereHandedInIsTheStandardAtmosphere) {
    struct Row {
        double altitude, density, temperature;
    };
    for (Row row : {Row{0, 1.22500, 288.15}, Row{1000, 1.11164, 281.65}, Row{3000, 0.90912, 268.65},
                    Row{11000, 0.36392, 216.65}}) {
        EXPECT_NEAR(isaAir(row.altitude).density, row.density, 2e-4);
        EXPECT_NEAR(isaAir(row.altitude).temperature, row.temperature, 1e-9);
    }
    TestFlight flight;
    flight.inAir(3000.0,
                 60.0);  // at 3 km 60 m/s are 51.7 m/s of equivalent airspeed, a little more calibrated
    EXPECT_NEAR(flight.now().cas, 51.75, 0.15);
}

TEST(Ice, AddsWeightAndSpoilsTheStrips) {
    TestFlight flight{AssistLevel::normal};
    flight.inAir(2500.0, 52.0);
    core::AirFunction const clear = flight.air;
    flight.air = [clear](glm::dvec3 const& p, core::UtcSeconds t) {
        core::AirSample sample = clear(p, t);
        sample.temperature = 263.0;
        sample.icing = 5e-4;
        return sample;
    };
    double const before = flight.now().tas;
    flight.fly(600.0);
    EXPECT_GT(flight.state().ice, 10.0);
    EXPECT_NEAR(flight.now().mass, 680.0 + 80.0 + 240.0 + flight.state().fuel + flight.state().ice, 1e-9);
    EXPECT_LT(flight.now().tas, before - 2.0);
    flight.air = clear;
    flight.aircraft.respawn(300.0, flight.air, flight.ground, 0.0);
    EXPECT_EQ(flight.state().ice, 0.0);
}
}  // namespace luftpost::flight
