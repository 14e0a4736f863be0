#include "engine/flight/aircraft.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/flight/air_loads.h"
#include "engine/flight/control_laws.h"
#include "engine/flight/trim.h"
#include "engine/flight/wheels.h"

namespace luftpost::flight {
namespace {
constexpr double kTick = core::kTickSeconds;
// The strips ask the air in turn, each 60 times a second: at 60 m/s that is once a metre, finer than any gust
// that the air holds, for a quarter of the cost.
constexpr long long kAskEvery = 4;
constexpr double kHornMargin = core::radians(3.5);

glm::dvec3 gravityWorld() { return glm::dvec3{0.0, -core::kGravity, 0.0}; }

/// Calibrated airspeed from the impact pressure (compressible, subsonic); m/s.
double calibratedAirspeed(double tas, core::AirSample const& air) {
    double const soundSquared = 1.4 * 287.05287 * air.temperature;
    double const impact = air.pressure * (core::pow(1.0 + 0.2 * tas * tas / soundSquared, 3.5) - 1.0);
    double const ratio = core::pow(impact / 101325.0 + 1.0, 2.0 / 7.0) - 1.0;
    return 340.294 * std::sqrt(5.0 * std::max(ratio, 0.0));
}

void askAir(Airframe const& airframe, AircraftState& state, MassProperties const& masses,
            core::AirFunction const& air, core::UtcSeconds time) {
    for (std::size_t i = 0; i < airframe.strips.size(); ++i) {
        if ((static_cast<long long>(i) + state.tick) % kAskEvery != 0) continue;
        glm::dvec3 const arm = airframe.strips[i].position - masses.centre;
        state.strips[i].windWorld = air(state.positionWorld + state.worldFromBody * arm, time).windWorld;
    }
}

void moveSurfaces(Airframe const& airframe, AircraftState& state) {
    double const share = std::min(kTick / airframe.surfaceSeconds, 1.0);
    SurfaceCommands& at = state.surfaces;
    SurfaceCommands const& to = state.commands;
    at.elevator += share * (to.elevator - at.elevator);
    at.aileron += share * (to.aileron - at.aileron);
    at.rudder += share * (to.rudder - at.rudder);
    at.throttle += share * (to.throttle - at.throttle);
    at.brakes += share * (to.brakes - at.brakes);
    double const flapStep = kTick / airframe.flapSeconds;
    at.flaps += std::clamp(to.flaps - at.flaps, -flapStep, flapStep);
}

/// What flows on at its own pace: separation, downwash, the shaft, fuel, ice.
void carryOn(Airframe const& airframe, AircraftState& state, AirLoads const& air,
             core::AirSample const& centre) {
    for (std::size_t i = 0; i < airframe.strips.size(); ++i) {
        StripAnswer const& answer = air.strips[i];
        StripState& strip = state.strips[i];
        double const share = std::min(answer.separationRate * kTick, 1.0);
        strip.separation += share * (answer.separationStatic - strip.separation);
        strip.alpha = answer.alpha;
        strip.lift = answer.lift;
    }
    double const speed = state.readings.tas;
    state.downwash +=
        std::min(kTick * speed / airframe.downwashLength, 1.0) * (air.downwash - state.downwash);

    bool const fuel = state.fuel > 0.0;
    double const torque =
        engineTorque(airframe.engine, state.surfaces.throttle, state.propellerRate, centre.density, fuel) -
        air.propeller.shaftTorque;
    state.propellerRate = std::max(state.propellerRate + torque / airframe.propeller.inertia * kTick, 0.0);
    state.propellerAngle += state.propellerRate * kTick;
    if (state.propellerAngle > 2.0 * core::kPi) state.propellerAngle -= 2.0 * core::kPi;
    if (fuel)
        state.fuel = std::max(state.fuel - kTick * fuelFlow(airframe.engine, state.surfaces.throttle,
                                                            state.propellerRate, centre.density),
                              0.0);
    // A tenth of the wing's area stands across the flow and catches most of the drops; above freezing the ice
    // goes.
    double const caught = 0.08 * airframe.wingArea * speed * centre.icing;
    double const melted = centre.temperature > 273.15 ? state.ice / 40.0 : 0.0;
    state.ice = std::clamp(state.ice + kTick * (caught - melted), 0.0, 0.2 * airframe.empty.mass);
}

Motion motionOf(AircraftState const& state) {
    return {state.positionWorld, state.velocityWorld, state.worldFromBody, state.ratesBody};
}
void setMotion(AircraftState& state, Motion const& motion) {
    state.positionWorld = motion.positionWorld;
    state.velocityWorld = motion.velocityWorld;
    state.worldFromBody = motion.worldFromBody;
    state.ratesBody = motion.ratesBody;
}

void readAttitude(AircraftState& state) {
    Readings& now = state.readings;
    glm::dvec3 const ahead = state.worldFromBody * glm::dvec3{1.0, 0.0, 0.0};
    glm::dvec3 const up = state.worldFromBody * glm::dvec3{0.0, 1.0, 0.0};
    glm::dvec3 const right = state.worldFromBody * glm::dvec3{0.0, 0.0, 1.0};
    now.heading = core::atan2(ahead.x, -ahead.z);
    if (now.heading < 0.0) now.heading += 2.0 * core::kPi;
    now.pitch = core::asin(std::clamp(ahead.y, -1.0, 1.0));
    now.roll = core::atan2(-right.y, up.y);
    now.rollRate = state.ratesBody.x;
    now.pitchRate = state.ratesBody.z;
    now.yawRate = -state.ratesBody.y;
}

void readAir(Airframe const& airframe, AircraftState& state, core::AirSample const& air) {
    Readings& now = state.readings;
    glm::dvec3 const through = glm::conjugate(state.worldFromBody) * (state.velocityWorld - air.windWorld);
    now.tas = glm::length(through);
    now.cas = calibratedAirspeed(now.tas, air);
    now.alpha = core::atan2(-through.y, through.x);
    now.beta = now.tas > 0.1 ? core::asin(std::clamp(through.z / now.tas, -1.0, 1.0)) : 0.0;
    now.windWorld = air.windWorld;
    now.density = air.density, now.temperature = air.temperature, now.pressure = air.pressure;
    now.visibility = air.visibility, now.turbulence = air.turbulence, now.icing = air.icing;
    double area = 0.0, left = 0.0, margin = 1.0;
    for (std::size_t i = 0; i < airframe.strips.size(); ++i) {
        StripData const& strip = airframe.strips[i];
        if (strip.place != StripPlace::wing) continue;
        area += strip.area;
        left += strip.area * state.strips[i].separation;
        double const flap =
            strip.surface == ControlSurface::flap ? state.surfaces.flaps * airframe.flapTravel : 0.0;
        margin = std::min(margin, strip.stallAngle - strip.surfaceStall * flap - state.strips[i].alpha);
    }
    now.stalled = area > 0.0 ? left / area : 0.0;
    now.stallMargin = margin;
    now.stallHorn = margin < kHornMargin && now.tas > 10.0;
}

void readLoads(AircraftState& state, Loads const& loads, core::AirSample const& air, double mass) {
    Readings& now = state.readings;
    glm::dvec3 const perWeight = loads.force / (mass * core::kGravity);
    glm::dvec3 const through = glm::conjugate(state.worldFromBody) * (state.velocityWorld - air.windWorld);
    now.loadFactor = perWeight.y;
    now.sideLoad = perWeight.z;
    now.excess = glm::dot(perWeight, through) / std::max(glm::length(through), 1.0);
}

/// All readings but the loads, which the step knows.
void takeReadings(Airframe const& airframe, AircraftState& state, MassProperties const& masses,
                  core::AirSample const& air, core::GroundSample const& below) {
    readAttitude(state);
    readAir(airframe, state, air);
    Readings& now = state.readings;
    glm::dvec3 const& v = state.velocityWorld;
    now.groundSpeed = std::sqrt(v.x * v.x + v.z * v.z);
    now.climb = v.y;
    now.mass = airframe.empty.mass + airframe.pilot.mass + state.payload + state.fuel + state.ice;
    now.onGround = false;
    for (WheelState const& wheel : state.wheels) now.onGround = now.onGround || wheel.contact;
    double const height = wheelHeight(airframe, state, masses, below);
    now.height = now.onGround ? std::max(height, 0.0) : height;  // a sprung leg is no depth
}

void judgeContact(AircraftState& state, Airframe const& airframe, GroundLoads const& ground, int strike) {
    if (ground.touchdownSpeed > 0.0 && !state.readings.onGround) {
        state.touchdownSpeed = ground.touchdownSpeed;
        state.touchdownTick = state.tick;
    }
    if (ground.inWater) {  // however hard
        state.crash = CrashReason::water;
    } else if (ground.touchdownSpeed > airframe.touchdownLimit) {
        state.touchdownSpeed = ground.touchdownSpeed;
        state.crash = CrashReason::hardLanding;
    } else if (strike >= 0) {
        state.crash = CrashReason::strike;
        state.struck = strike;
    }
}

/// What is left after a crash comes to rest on the ground where it is.
void settleWreck(AircraftState& state, MassProperties const& masses, Airframe const& airframe,
                 core::GroundSample const& below) {
    double const keep = 1.0 - std::min(kTick / 0.3, 1.0);
    state.commands = state.surfaces = SurfaceCommands{};
    state.propellerRate *= keep;
    state.ratesBody *= keep;
    state.velocityWorld = state.velocityWorld * keep + gravityWorld() * kTick;
    Motion const next = moved(motionOf(state), Loads{}, glm::dvec3{0.0}, masses.mass, masses.inertia, kTick);
    setMotion(state, next);
    double lowest = 0.0;
    for (StrikeData const& strike : airframe.strikes)
        lowest = std::min(lowest, (state.worldFromBody * (strike.position - masses.centre)).y);
    double const floor = below.height - 0.5 * lowest;  // half sunk into what it hit
    if (state.positionWorld.y < floor) {
        state.positionWorld.y = floor;
        state.velocityWorld.y = std::max(state.velocityWorld.y, 0.0);
    }
    for (WheelState& wheel : state.wheels) wheel = WheelState{.angle = wheel.angle};
}

core::GroundSample groundBelow(AircraftState const& state, core::GroundFunction const& ground) {
    return ground(state.positionWorld.x, -state.positionWorld.z);
}
}  // namespace

Aircraft::Aircraft(Airframe airframe, double payload, double fuel) : airframe_{std::move(airframe)} {
    CHECK(payload >= 0.0 && fuel >= 0.0, "payload {} kg, fuel {} kg", payload, fuel);
    state_.payload = payload;
    state_.fuel = fuel;
}

void Aircraft::begin(core::AirSample const& air, core::GroundFunction const& ground) {
    MassProperties const masses = massProperties(airframe_, state_);
    takeReadings(airframe_, state_, masses, air, groundBelow(state_, ground));
    AirLoads const loads = airLoads(airframe_, state_, masses, air, state_.readings.height);
    for (std::size_t i = 0; i < airframe_.strips.size(); ++i) {
        state_.strips[i].alpha = loads.strips[i].alpha;
        state_.strips[i].lift = loads.strips[i].lift;
    }
    state_.readings.thrust = loads.propeller.thrust;
    if (!state_.readings.onGround)
        state_.readings.loadFactor = loads.loads.force.y / (masses.mass * core::kGravity);
    state_.assist.holdsAltitude = 1.0;
    state_.assist.heldAltitude = state_.positionWorld.y;
    state_.assist.startSpeed = state_.readings.cas;
}

void Aircraft::startInAir(glm::dvec3 const& positionWorld, double heading, double tas,
                          core::AirFunction const& air, core::GroundFunction const& ground,
                          core::UtcSeconds time) {
    AircraftState fresh;
    fresh.payload = state_.payload, fresh.fuel = state_.fuel;
    fresh.positionWorld = positionWorld;
    core::AirSample const sample = air(positionWorld, time);
    double const height = positionWorld.y - ground(positionWorld.x, -positionWorld.z).height;
    trimForLevelFlight(airframe_, fresh, sample, heading, tas, height);
    state_ = fresh;
    begin(sample, ground);
}

void Aircraft::startOnRunway(double east, double north, double heading, core::AirFunction const& air,
                             core::GroundFunction const& ground, core::UtcSeconds time) {
    AircraftState fresh;
    fresh.payload = state_.payload, fresh.fuel = state_.fuel;
    MassProperties const masses = massProperties(airframe_, fresh);
    fresh.worldFromBody = attitude(heading, 0.0, 0.0);
    double lowest = 0.0, stiffness = 0.0;
    for (WheelData const& wheel : airframe_.wheels) {
        lowest = std::min(lowest, wheel.position.y - masses.centre.y);
        stiffness += wheel.stiffness;
    }
    double const sunk = masses.mass * core::kGravity / stiffness;
    fresh.positionWorld = core::worldFromEastNorth(east, north, ground(east, north).height - lowest - sunk);
    core::AirSample const sample = air(fresh.positionWorld, time);
    fresh.propellerRate = steadyRate(airframe_, 0.0, 0.0, sample.density, fresh.fuel > 0.0);
    for (StripState& strip : fresh.strips) strip.windWorld = sample.windWorld;
    for (std::size_t i = 0; i < airframe_.wheels.size(); ++i) fresh.wheels[i].contact = true;
    state_ = fresh;
    begin(sample, ground);
}

void Aircraft::respawn(double height, core::AirFunction const& air, core::GroundFunction const& ground,
                       core::UtcSeconds time) {
    glm::dvec3 place = state_.positionWorld;
    place.y = std::max(place.y, groundBelow(state_, ground).height + height);
    startInAir(place, state_.readings.heading, 0.78 * airframe_.cruiseLimitSpeed, air, ground, time);
}

void Aircraft::step(Controls const& stick, AssistLevel level, AssistSettings const& settings,
                    core::AirFunction const& air, core::GroundFunction const& ground, core::UtcSeconds time) {
    MassProperties const masses = massProperties(airframe_, state_);
    core::AirSample const centre = air(state_.positionWorld, time);
    core::GroundSample const below = groundBelow(state_, ground);
    if (state_.crashed()) {
        settleWreck(state_, masses, airframe_, below);
    } else {
        askAir(airframe_, state_, masses, air, time);
        state_.commands = assistedCommands(airframe_, state_, stick, level, settings, state_.assist, kTick);
        moveSurfaces(airframe_, state_);
        AirLoads const fromAir = airLoads(airframe_, state_, masses, centre, state_.readings.height);
        GroundLoads const fromGround = groundLoads(airframe_, state_, masses, below, ground, kTick);
        Loads loads = fromAir.loads;
        loads += fromGround.loads;
        state_.wheels = fromGround.wheels;
        judgeContact(state_, airframe_, fromGround,
                     strikeUnderGround(airframe_, state_, masses, below, ground));
        carryOn(airframe_, state_, fromAir, centre);
        state_.readings.thrust = fromAir.propeller.thrust;
        readLoads(state_, loads, centre, masses.mass);
        setMotion(state_, moved(motionOf(state_), loads, gravityWorld(), masses.mass, masses.inertia, kTick));
    }
    ++state_.tick;
    takeReadings(airframe_, state_, masses, centre, below);
}

AircraftPose interpolatedPose(Airframe const& airframe, AircraftState const& earlier,
                              AircraftState const& later, double share) {
    auto const mix = [share](auto const& a, auto const& b) { return a + share * (b - a); };
    AircraftPose pose;
    pose.worldFromBody = glm::slerp(earlier.worldFromBody, later.worldFromBody, share);
    glm::dvec3 const centre = massProperties(airframe, later).centre;
    pose.positionWorld = mix(earlier.positionWorld, later.positionWorld) - pose.worldFromBody * centre;
    pose.propellerAngle = later.propellerAngle - (1.0 - share) * later.propellerRate * kTick;
    pose.elevator = mix(earlier.surfaces.elevator, later.surfaces.elevator);
    pose.aileron = mix(earlier.surfaces.aileron, later.surfaces.aileron);
    pose.rudder = mix(earlier.surfaces.rudder, later.surfaces.rudder);
    pose.flaps = mix(earlier.surfaces.flaps, later.surfaces.flaps);
    for (std::size_t i = 0; i < pose.compression.size(); ++i)
        pose.compression[i] = mix(earlier.wheels[i].compression, later.wheels[i].compression);
    return pose;
}

std::string crashText(Airframe const& airframe, AircraftState const& state) {
    switch (state.crash) {
        case CrashReason::none:
            return "";
        case CrashReason::hardLanding:
            return fmt::format("The landing was too hard: {:.1f} m/s ({:.1f} is the limit)",
                               state.touchdownSpeed, airframe.touchdownLimit);
        case CrashReason::strike:
            return fmt::format("The {} struck the ground",
                               airframe.strikes[static_cast<std::size_t>(state.struck)].name);
        case CrashReason::water:
            return "The aircraft came down in water";
    }
    return "";
}
}  // namespace luftpost::flight
