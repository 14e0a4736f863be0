// All that one aircraft is at one tick: plain data that can be copied, kept, interpolated and hashed.
#pragma once
#include <array>
#include <string>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/flight/airframe.h"
#include "engine/flight/assist.h"

namespace luftpost::flight {
enum class CrashReason : int { none, hardLanding, strike, water };

/// What a strip carries from tick to tick, and what it met last.
struct StripState {
    double separation = 0.0;    // 0..1, share of the chord whose flow has left
    glm::dvec3 windWorld{0.0};  // m/s, the air's velocity when the strip last asked
    double alpha = 0.0;         // rad, for displays and tests
    double lift = 0.0;          // lift coefficient, for displays and tests
};
struct WheelState {
    double compression = 0.0;  // m
    double load = 0.0;         // N
    double slip = 0.0;         // m/s, speed of the tyre's patch across the ground, for sound and dust
    double angle = 0.0;        // rad, how far the wheel has turned, for the picture
    bool contact = false;
};
/// Positions of the surfaces and levers. Commands: share of the travel, -1..1 (throttle, flaps, brakes 0..1).
using SurfaceCommands = Controls;

/// What instruments, log and HUD read. Derived afresh each tick.
struct Readings {
    double tas = 0.0;                                       // m/s
    double cas = 0.0;                                       // m/s, calibrated airspeed
    double alpha = 0.0;                                     // rad, of the body's x axis
    double beta = 0.0;                                      // rad, + air from the right
    double heading = 0.0;                                   // rad, 0..2 pi, clockwise from true north
    double pitch = 0.0;                                     // rad, + nose up
    double roll = 0.0;                                      // rad, + right wing down
    double rollRate = 0.0, pitchRate = 0.0, yawRate = 0.0;  // rad/s: p right, q nose up, r nose right
    double loadFactor = 1.0;                                // along body up, 1 in level flight
    double sideLoad = 0.0;      // along body right, in g: the slip ball moves against it
    double excess = 0.0;        // thrust less drag over weight: the climb angle that keeps the speed
    double groundSpeed = 0.0;   // m/s
    double climb = 0.0;         // m/s
    double height = 0.0;        // m, of the lowest wheel above the ground under the aircraft
    double thrust = 0.0;        // N
    double mass = 0.0;          // kg
    glm::dvec3 windWorld{0.0};  // m/s, where the air goes to, at the centre of gravity
    double density = 1.225, temperature = 288.15, pressure = 101325.0;
    double visibility = 1.0e5, turbulence = 0.0, icing = 0.0;  // as the air says
    double stalled = 0.0;                                      // 0..1, share of the wing whose flow has left
    double stallMargin = 0.0;                                  // rad more until a strip of the wing stalls
    bool stallHorn = false;                                    // sounds about 5 kt before the stall
    bool onGround = false;                                     // a wheel or skid touches
};

struct AircraftState {
    glm::dvec3 positionWorld{0.0};  // m, centre of gravity
    glm::dvec3 velocityWorld{0.0};  // m/s, over the ground
    glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 ratesBody{0.0};         // rad/s about body x, y, z
    double propellerRate = 0.0;        // rad/s
    double propellerAngle = 0.0;       // rad, 0..2 pi
    double fuel = 0.0, payload = 0.0;  // kg
    double ice = 0.0;                  // kg on the strips
    double downwash = 0.0;             // rad at the tail, follows the wing's lift after the way between them
    SurfaceCommands trim;              // what the start solved for; the stick adds to it
    SurfaceCommands commands;          // after the assist
    SurfaceCommands surfaces;          // where they are, following the commands
    AssistMemory assist;
    std::array<StripState, kMaxStrips> strips{};
    std::array<WheelState, kMaxWheels> wheels{};
    long long tick = 0;  // since the start
    CrashReason crash = CrashReason::none;
    int struck = -1;               // which of the airframe's strikes
    double touchdownSpeed = 0.0;   // m/s across the ground, of the latest touchdown
    long long touchdownTick = -1;  // its tick, -1: none since the start
    Readings readings;

    bool crashed() const { return crash != CrashReason::none; }
};

/// Calls `take(double)` for every number that the next tick depends on, in a fixed order: the state hash.
template <class Take>
void forEachNumber(AircraftState const& s, Take&& take) {
    auto const vector = [&](glm::dvec3 const& v) { take(v.x), take(v.y), take(v.z); };
    auto const controls = [&](Controls const& c) {
        for (double value : {c.throttle, c.elevator, c.aileron, c.rudder, c.flaps, c.brakes}) take(value);
    };
    vector(s.positionWorld), vector(s.velocityWorld), vector(s.ratesBody);
    for (double value : {s.worldFromBody.w, s.worldFromBody.x, s.worldFromBody.y, s.worldFromBody.z})
        take(value);
    for (double value : {s.propellerRate, s.propellerAngle, s.fuel, s.payload, s.ice, s.downwash})
        take(value);
    controls(s.trim), controls(s.commands), controls(s.surfaces);
    AssistMemory const& a = s.assist;
    for (double value : {a.climbAngle, a.heldAltitude, a.holdsAltitude, a.heldBank, a.pitchIntegral,
                         a.rollIntegral, a.yawIntegral, a.throttleIntegral, a.excess, a.startSpeed})
        take(value);
    for (StripState const& strip : s.strips) take(strip.separation), vector(strip.windWorld);
    for (WheelState const& wheel : s.wheels) take(wheel.compression), take(wheel.contact ? 1.0 : 0.0);
    take(static_cast<double>(s.tick)), take(static_cast<double>(s.crash));
}

/// What the picture shows between two ticks. `share` 0 is the earlier, 1 the later. For pictures only: not
/// part of the simulation.
struct AircraftPose {
    glm::dvec3 positionWorld{0.0};  // of the airframe's datum: the model's origin
    glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};
    double propellerAngle = 0.0;                                      // rad
    double elevator = 0.0, aileron = 0.0, rudder = 0.0, flaps = 0.0;  // -1..1 (flaps 0..1), where they are
    std::array<double, kMaxWheels> compression{};                     // m
};
AircraftPose interpolatedPose(Airframe const& airframe, AircraftState const& earlier,
                              AircraftState const& later, double share);

/// One line for the player: "The landing was too hard: 4.2 m/s (3.0 is the limit)". Empty without a crash.
std::string crashText(Airframe const& airframe, AircraftState const& state);
}  // namespace luftpost::flight
