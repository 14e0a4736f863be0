// However one comes down, the flight goes on: a crash that says why, or an aircraft that stands and says how
// to be in the air again.
#include <gtest/gtest.h>

#include "engine/core/frames.h"
#include "engine/flight/aircraft.h"
#include "engine/platform/paths.h"
#include "game/app/hangar.h"
#include "game/app/instruments.h"

namespace {
using namespace luftpost;

core::AirSample stillAir(glm::dvec3 const&, core::UtcSeconds) { return {}; }

/// Dropped onto the ground in an attitude, with a speed ahead, and left alone for some seconds.
flight::AircraftState dropped(glm::dquat const& worldFromBody, glm::dvec3 const& velocityWorld,
                              core::Surface surface = core::Surface::grass) {
    auto const ground = [surface](double, double) {
        return core::GroundSample{0.0, {0.0, 1.0, 0.0}, surface};
    };
    flight::Aircraft aircraft{chosen(app::loadHangar(), app::AirframeChoice::mailPlane), 240.0, 60.0};
    aircraft.startInAir({0.0, 300.0, 0.0}, 0.0, 45.0, stillAir, ground, 0.0);
    flight::AircraftState state = aircraft.state();
    state.positionWorld = {0.0, 4.5, 0.0};
    state.velocityWorld = velocityWorld;
    state.worldFromBody = worldFromBody;
    aircraft.restore(state);
    for (int tick = 0; tick < 6 * core::kTicksPerSecond && !aircraft.state().crashed(); ++tick)
        aircraft.step({}, flight::AssistLevel::sim, {}, stillAir, ground, 0.0);
    return aircraft.state();
}

glm::dquat about(double x, double y, double z, double angle_deg) {
    return glm::angleAxis(core::radians(angle_deg), glm::dvec3{x, y, z});
}

TEST(Crash, IsWhatEndsALandingOnTheBackOnASideOrOnTheNoseAndSaysWhy) {
    flight::Airframe const airframe = chosen(app::loadHangar(), app::AirframeChoice::mailPlane);
    for (double roll_deg : {70.0, 110.0, 150.0, 180.0, -180.0, -120.0, -80.0})
        for (double speed : {0.0, 20.0}) {
            flight::AircraftState const state = dropped(about(1.0, 0.0, 0.0, roll_deg), {speed, -1.0, 0.0});
            EXPECT_TRUE(state.crashed()) << roll_deg << " degrees at " << speed;
            EXPECT_NE(flight::crashText(airframe, state), "") << roll_deg;
        }
    for (double pitch_deg : {-90.0, -45.0, 90.0})
        EXPECT_TRUE(dropped(about(0.0, 0.0, 1.0, pitch_deg), {0.0, -1.0, 0.0}).crashed()) << pitch_deg;
}

TEST(Crash, HasAReasonForHardLandingsStrikesAndWater) {
    flight::Airframe const airframe = chosen(app::loadHangar(), app::AirframeChoice::mailPlane);
    flight::AircraftState const hard = dropped(about(1.0, 0.0, 0.0, 0.0), {30.0, -6.0, 0.0});
    EXPECT_EQ(hard.crash, flight::CrashReason::hardLanding);
    EXPECT_NE(flight::crashText(airframe, hard).find("too hard"), std::string::npos);
    flight::AircraftState const wet =
        dropped(about(1.0, 0.0, 0.0, 0.0), {30.0, -1.0, 0.0}, core::Surface::water);
    EXPECT_EQ(wet.crash, flight::CrashReason::water);
    flight::AircraftState const back = dropped(about(1.0, 0.0, 0.0, 180.0), {0.0, -1.0, 0.0});
    EXPECT_EQ(back.crash, flight::CrashReason::strike);
    EXPECT_NE(flight::crashText(airframe, back).find("struck the ground"), std::string::npos);
}
}  // namespace
