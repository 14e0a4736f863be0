#include "engine/flight/control_laws.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::flight {
namespace {
constexpr double kStickFree = 0.02;       // share of the stick below which it counts as let go
constexpr double kReferenceSpeed = 51.4;  // m/s (100 kt), where the gains below were chosen
constexpr double kNormalBankLimit = core::radians(65.0);
constexpr double kEasyBank = core::radians(50.0);
constexpr double kEasyClimb = core::radians(18.0);
constexpr double kPedalLean = 0.35;
constexpr double kTrimTravel = 0.5;  // of the stick's travel, by the trim wheel at its stop
constexpr double kFlareHeight = 15.0;  // m; below it easy lets the aircraft be slow and land

/// What all laws read, taken once.
struct Flight {
    Airframe const& airframe;
    AircraftState const& state;
    Readings const& now;
    AssistSettings const& settings;
    Controls const& stick;
    double dt;
    double speed;  // m/s, never too small to divide by
    double gain;  // controls bite with the square of the speed, damping with the speed: gains go as 1 / speed
    double climbAngle;  // rad, of the path over the ground
};

double radiansOf(double degrees) { return core::radians(degrees); }

/// Lift per angle of attack as load factor: q S a / W.
double loadFactorSlope(Flight const& f) {
    double slope = 0.0;
    for (StripData const& strip : f.airframe.strips)
        if (strip.place == StripPlace::wing) slope += strip.liftSlope * strip.area;
    double const pressure = 0.5 * f.now.density * f.speed * f.speed;
    return std::max(pressure * slope / (f.now.mass * core::kGravity), 1.0);
}

/// The body's angle of attack at which the first wing strip begins to stall, with the flaps as they are.
double stallAlpha(Flight const& f) {
    double least = 1.0;
    for (StripData const& strip : f.airframe.strips) {
        if (strip.place != StripPlace::wing) continue;
        double const flap =
            strip.surface == ControlSurface::flap ? f.state.surfaces.flaps * f.airframe.flapTravel : 0.0;
        least = std::min(
            least, strip.stallAngle - 0.35 * strip.stallWidth - strip.surfaceStall * flap - strip.incidence);
    }
    return least;
}

/// 1 on the ground, 0 well above it.
double nearGround(Flight const& f) { return 1.0 - std::clamp((f.now.height - 6.0) / 18.0, 0.0, 1.0); }

/// Close above the ground with the lever back one means to land: a height held there would end in a stall.
bool landing(Flight const& f) { return f.now.height < kFlareHeight && f.stick.throttle < 0.2; }
/// The soft path down: the sink that the height allows.
double landingPath(Flight const& f) { return -(0.5 + 0.2 * std::max(f.now.height, 0.0)) / f.speed; }

/// Elevator that flies the load factor `wanted`, never past the stall.
double elevatorForLoad(Flight const& f, double wanted, AssistMemory& memory) {
    double const slope = loadFactorSlope(f);
    double const guard = stallAlpha(f) + radiansOf(-0.5 + 1.3 * nearGround(f));
    double const alpha = std::clamp(f.now.alpha + (std::clamp(wanted, -1.5, 4.5) - f.now.loadFactor) / slope,
                                    radiansOf(-10.0), guard);
    double const load = f.now.loadFactor + (alpha - f.now.alpha) * slope;
    double const turning = std::clamp(
        (load - core::cos(f.now.pitch) * core::cos(f.now.roll)) * core::kGravity / f.speed, -1.0, 1.0);
    double const error = alpha - f.now.alpha;
    double const command = f.state.trim.elevator + memory.pitchIntegral + 6.0 * error +
                           1.0 * f.gain * (turning - f.now.pitchRate);
    if (std::abs(command) < 1.0 || command * error < 0.0)
        memory.pitchIntegral = std::clamp(memory.pitchIntegral + 6.0 * error * f.dt, -1.5, 1.5);
    return std::clamp(command, -1.0, 1.0);
}

/// Load factor that turns the path toward `climbAngle`, in a bank round as well; at most `fastest` rad/s.
double loadForPath(Flight const& f, double climbAngle, double fastest = 0.2) {
    double const turn = std::clamp(1.2 * (climbAngle - f.climbAngle), -fastest, fastest);
    double const upward = core::cos(f.climbAngle) + f.speed * turn / core::kGravity;
    return upward / std::max(core::cos(f.now.roll), 0.45);
}

double stallSpeed(Flight const& f) {
    return f.airframe.stallSpeed +
           f.state.surfaces.flaps * (f.airframe.stallSpeedFlaps - f.airframe.stallSpeed);
}

/// Keeps a load factor from taking the path where the speed would run out, up or down. The path that keeps
/// the speed is the one that thrust less drag carries; above a fifth over the stall there is speed to spend
/// on more, below it the path must give some back. Near the ground, where one takes off and lands, it may be
/// slow.
double guardedLoad(Flight const& f, double load, AssistMemory& memory) {
    memory.excess += std::min(f.dt / 0.5, 1.0) * (f.now.excess - memory.excess);
    double const margin = 1.18 - 0.16 * nearGround(f);
    double const steepest =
        std::clamp(memory.excess + 0.9 * (f.now.cas / stallSpeed(f) - margin), -0.25, radiansOf(50.0));
    double const dive =
        std::clamp((f.now.cas - 0.97 * f.airframe.neverExceedSpeed) / 20.0, radiansOf(-60.0), 0.1);
    double const least = loadForPath(f, dive, 0.4);
    return std::clamp(load, least, std::max(loadForPath(f, steepest, 0.4), least));
}

/// The climb angle that brings the held altitude back.
double angleToAltitude(Flight const& f, double altitude, double most) {
    return std::clamp(0.35 * (altitude - f.state.positionWorld.y) / f.speed, -most, most);
}

/// How far past the pilot's stops the assist may turn a surface: only where the settings ask for more than
/// their default, and at most twice as far.
double lentTravel(double asked, double usual) { return std::clamp(asked / usual, 1.0, 2.0); }

double aileronForRate(Flight const& f, double rate, AssistMemory& memory) {
    double const error = rate - f.now.rollRate;
    double const most = lentTravel(f.settings.rollFactor * f.settings.rollSpeed_dps, 60.0);
    double const command = f.state.trim.aileron + memory.rollIntegral + f.gain * (0.82 * rate + 0.35 * error);
    if (std::abs(command) < most || command * error < 0.0)
        memory.rollIntegral = std::clamp(memory.rollIntegral + 0.8 * f.gain * error * f.dt, -0.5, 0.5);
    return std::clamp(command, -most, most);
}

/// Keeps a roll rate from carrying the bank past the limit, and brings it back from beyond.
double guardedRollRate(double rate, double bank, double limit) {
    return std::clamp(rate, 2.5 * (-limit - bank), 2.5 * (limit - bank));
}

/// Rudder for the induced share of the coordinated turn and what the pedal asks.
double rudderForTurn(Flight const& f, double pedal, AssistMemory& memory) {
    double const coordinated = core::kGravity / f.speed * core::sin(f.now.roll) * core::cos(f.now.pitch);
    double const wanted =
        f.settings.inducedYawFactor * coordinated + pedal * radiansOf(f.settings.yawSpeed_dps);
    // The ball is centred as far as the turn is flown unasked, and while the pedal is left alone.
    double const centring = (1.0 - std::min(std::abs(f.settings.inducedYawFactor - 1.0), 1.0)) *
                            (std::abs(pedal) < kStickFree ? 1.0 : 0.0);
    double const error = wanted - f.now.yawRate + centring * f.now.beta;
    double const most = std::max(lentTravel(f.settings.yawSpeed_dps, 15.0),
                                 1.0 + std::min(std::abs(f.settings.inducedYawFactor - 1.0), 1.0));
    double const command = f.state.trim.rudder + memory.yawIntegral + 2.5 * f.gain * error;
    if (std::abs(command) < most || command * error < 0.0)
        memory.yawIntegral = std::clamp(memory.yawIntegral + 3.0 * f.gain * error * f.dt, -most, most);
    return std::clamp(command, -most, most);
}

/// With a wheel on the ground the stick is the surfaces, the pedals steer with a damper, and the memory
/// follows, so that the hand-over at lift-off is smooth.
SurfaceCommands groundCommands(Flight const& f, bool easy, AssistMemory& memory) {
    SurfaceCommands out = f.stick;
    out.elevator = std::clamp(f.state.trim.elevator + f.stick.elevator, -1.0, 1.0);
    out.aileron = std::clamp(f.stick.aileron - 1.5 * f.now.roll, -1.0, 1.0);
    double const wanted = f.stick.rudder * radiansOf(f.settings.yawSpeed_dps);
    double const error = wanted - f.now.yawRate;
    out.rudder = std::clamp(0.6 * f.stick.rudder + 1.2 * error + memory.yawIntegral, -1.0, 1.0);
    double const yawIntegral =
        f.now.groundSpeed > 2.0 ? std::clamp(memory.yawIntegral + 2.0 * error * f.dt, -0.6, 0.6) : 0.0;
    if (easy && f.stick.throttle < 0.05)
        out.brakes = std::max(out.brakes, 0.4);  // landed: it stops by itself
    memory = AssistMemory{.climbAngle = f.climbAngle,
                          .yawIntegral = yawIntegral,
                          .excess = f.now.excess,
                          .startSpeed = memory.startSpeed};
    memory.pitchIntegral = out.elevator - f.state.trim.elevator;
    return out;
}

/// The bank of a coordinated turn at the yaw rate that the pedal asks for.
double pedalBank(Flight const& f) {
    return core::atan(f.speed * f.stick.rudder * radiansOf(f.settings.yawSpeed_dps) / core::kGravity);
}

/// With the stick free the wings come level, or lean a little into the turn that the pedal asks for: skidding
/// round alone is slow.
double freeRollRate(Flight const& f, AssistMemory& memory) {
    double const fastest = radiansOf(f.settings.rollSpeed_dps);
    if (std::abs(f.stick.rudder) >= kStickFree && f.now.height > kFlareHeight) {
        double const lean = kPedalLean * pedalBank(f);
        memory.heldBank = f.now.roll;
        return std::clamp(1.5 * (lean - f.now.roll), -fastest, fastest);
    }
    if (f.settings.stabilizingRoll > 0.0) {
        memory.heldBank = f.now.roll;
        return std::clamp(-f.settings.stabilizingRoll * f.now.roll, -fastest, fastest);
    }
    return std::clamp(1.5 * (memory.heldBank - f.now.roll), -fastest, fastest);
}

SurfaceCommands normalCommands(Flight const& f, AssistMemory& memory) {
    SurfaceCommands out = f.stick;
    double rollRate = f.settings.rollFactor * radiansOf(f.settings.rollSpeed_dps) * f.stick.aileron;
    if (std::abs(f.stick.aileron) < kStickFree)
        rollRate = freeRollRate(f, memory);
    else
        memory.heldBank = f.now.roll;
    out.aileron = aileronForRate(f, guardedRollRate(rollRate, f.now.roll, kNormalBankLimit), memory);

    double pull = 0.0;
    if (std::abs(f.stick.elevator) >= kStickFree) {
        double const rate = f.stick.elevator * radiansOf(f.settings.pitchSpeed_dps);
        pull = f.speed * rate / core::kGravity;
        memory.climbAngle = std::clamp(f.climbAngle + 0.25 * rate, radiansOf(-50.0), radiansOf(40.0));
        memory.holdsAltitude = 0.0;
    } else if (memory.holdsAltitude == 0.0 && std::abs(memory.climbAngle) < radiansOf(1.5)) {
        memory.holdsAltitude = 1.0;
        memory.heldAltitude = f.state.positionWorld.y + f.state.velocityWorld.y;
    }
    double path = memory.holdsAltitude > 0.0 ? angleToAltitude(f, memory.heldAltitude, radiansOf(6.0))
                                             : memory.climbAngle;
    if (landing(f) && f.stick.elevator > -kStickFree) {
        path = landingPath(f);
        memory.holdsAltitude = 0.0;
        memory.climbAngle = path;
    }
    double load = guardedLoad(f, loadForPath(f, path) + pull, memory);
    // A pull softens the landing, but does not carry the aircraft up again to where it would drop from.
    if (landing(f)) load = std::min(load, loadForPath(f, 0.6 * landingPath(f), 0.4));
    out.elevator = elevatorForLoad(f, load, memory);
    out.rudder = rudderForTurn(f, f.stick.rudder, memory);
    return out;
}

/// The lever asks for a speed; the engine's power follows.
double throttleForSpeed(Flight const& f, double climbAngle, AssistMemory& memory) {
    double const slowest = 1.35 * f.airframe.stallSpeed, fastest = 0.97 * f.airframe.cruiseLimitSpeed;
    // Where the start put the lever it asks for the speed of the start.
    double const middle = std::clamp(f.state.trim.throttle / f.settings.maxThrottle, 0.05, 0.95);
    double const atMiddle = std::clamp(memory.startSpeed, slowest, fastest);
    double const lever = f.stick.throttle;
    double const wanted = lever < middle
                              ? slowest + lever / middle * (atMiddle - slowest)
                              : atMiddle + (lever - middle) / (1.0 - middle) * (fastest - atMiddle);
    double const error = wanted - f.now.cas;
    double const climbing =
        f.now.mass * core::kGravity * f.speed * climbAngle / (0.7 * f.airframe.engine.power);
    double const command = f.state.trim.throttle + climbing + 0.08 * error + memory.throttleIntegral;
    if ((command < 1.0 || error < 0.0) && (command > 0.0 || error > 0.0))
        memory.throttleIntegral = std::clamp(memory.throttleIntegral + 0.02 * error * f.dt, -1.0, 1.0);
    return std::clamp(command, 0.0, 1.0);
}

/// Where easy steers: the bank that the stick and the pedals point to.
double easyRollRate(Flight const& f, AssistMemory& memory) {
    double const fastest = radiansOf(f.settings.rollSpeed_dps);
    bool const steered = std::abs(f.stick.aileron) >= kStickFree || std::abs(f.stick.rudder) >= kStickFree;
    if (!steered) return freeRollRate(f, memory);
    double const bank = std::clamp(f.settings.rollFactor * f.stick.aileron * kEasyBank + pedalBank(f),
                                   -kNormalBankLimit, kNormalBankLimit);
    memory.heldBank = f.now.roll;
    return std::clamp(3.0 * (bank - f.now.roll), -fastest, fastest);
}

/// The path that easy flies: the stick's climb, else the altitude where it was let go; a soft arrival near
/// the ground.
double easyClimbAngle(Flight const& f, AssistMemory& memory) {
    if (std::abs(f.stick.elevator) >= kStickFree) {
        double const wanted = f.stick.elevator * kEasyClimb,
                     step = radiansOf(f.settings.pitchSpeed_dps) * f.dt;
        memory.climbAngle += std::clamp(wanted - memory.climbAngle, -step, step);
        memory.holdsAltitude = 0.0;
    } else {
        if (memory.holdsAltitude == 0.0)
            memory.heldAltitude = f.state.positionWorld.y + 1.5 * f.state.velocityWorld.y;
        memory.holdsAltitude = 1.0;
        memory.climbAngle = angleToAltitude(f, memory.heldAltitude, kEasyClimb);
    }
    double path = memory.climbAngle;
    if (f.now.height < kFlareHeight) path = std::max(path, landingPath(f));
    if (landing(f) && memory.holdsAltitude > 0.0) path = landingPath(f);
    return path;
}

SurfaceCommands easyCommands(Flight const& f, AssistMemory& memory) {
    SurfaceCommands out = f.stick;
    out.aileron =
        aileronForRate(f, guardedRollRate(easyRollRate(f, memory), f.now.roll, kNormalBankLimit), memory);
    double const path = easyClimbAngle(f, memory);
    out.elevator = elevatorForLoad(f, guardedLoad(f, loadForPath(f, path), memory), memory);
    out.rudder = rudderForTurn(f, f.stick.rudder, memory);
    out.throttle = landing(f) ? 0.0 : throttleForSpeed(f, path, memory);
    return out;
}

SurfaceCommands directCommands(Flight const& f) {
    SurfaceCommands out = f.stick;
    out.elevator = std::clamp(f.state.trim.elevator + f.stick.elevator + kTrimTravel * f.stick.elevatorTrim, -1.0, 1.0);
    out.aileron = std::clamp(f.state.trim.aileron + f.stick.aileron, -1.0, 1.0);
    out.rudder = std::clamp(f.state.trim.rudder + f.stick.rudder + kTrimTravel * f.stick.rudderTrim, -1.0, 1.0);
    return out;
}

/// Automatic rudder: the ball in the middle, yaw damped about the coordinated turn.
SurfaceCommands lightCommands(Flight const& f) {
    SurfaceCommands out = directCommands(f);
    if (f.now.onGround) return out;
    double const coordinated = core::kGravity / f.speed * core::sin(f.now.roll) * core::cos(f.now.pitch);
    double const withAileron = 0.35 * f.gain * f.gain * f.stick.aileron;  // ahead of the adverse yaw
    double const damping = 1.0 * f.gain * (coordinated - f.now.yawRate);
    out.rudder = std::clamp(out.rudder + withAileron + 3.0 * f.now.beta + damping, -1.0, 1.0);
    return out;
}
}  // namespace

Controls cleaned(Controls const& stick) {
    auto const clean = [](double value, double low) {
        return value == value ? std::clamp(value, low, 1.0) : 0.0;
    };
    return {clean(stick.throttle, 0.0), clean(stick.elevator, -1.0), clean(stick.aileron, -1.0),
            clean(stick.rudder, -1.0),  clean(stick.flaps, 0.0),     clean(stick.brakes, 0.0),
            clean(stick.elevatorTrim, -1.0), clean(stick.rudderTrim, -1.0)};
}

SurfaceCommands assistedCommands(Airframe const& airframe, AircraftState const& state, Controls const& stick,
                                 AssistLevel level, AssistSettings const& settings, AssistMemory& memory,
                                 double dt) {
    Controls const clean = cleaned(stick);
    double const speed = std::max(state.readings.tas, 15.0);
    double const ground = std::max(glm::length(state.velocityWorld), 5.0);
    Flight const f{airframe,
                   state,
                   state.readings,
                   settings,
                   clean,
                   dt,
                   speed,
                   std::clamp(kReferenceSpeed / speed, 0.4, 2.5),
                   core::asin(std::clamp(state.velocityWorld.y / ground, -1.0, 1.0))};
    SurfaceCommands out;
    bool const held = level == AssistLevel::normal || level == AssistLevel::easy;
    if (held && state.readings.onGround)
        out = groundCommands(f, level == AssistLevel::easy, memory);
    else if (level == AssistLevel::normal)
        out = normalCommands(f, memory);
    else if (level == AssistLevel::easy)
        out = easyCommands(f, memory);
    else
        out = level == AssistLevel::light ? lightCommands(f) : directCommands(f);
    out.throttle *= settings.maxThrottle;
    return out;
}
}  // namespace luftpost::flight
