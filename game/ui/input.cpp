#include "game/ui/input.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::ui {
namespace {
using core::kTickSeconds;

double towards(double value, double target, double step) {
    return value < target ? std::min(value + step, target) : std::max(value - step, target);
}

double keyPair(InputSample const& sample, FlightKey less, FlightKey more) {
    return (sample.held(more) ? 1.0 : 0.0) - (sample.held(less) ? 1.0 : 0.0);
}

/// An axis with its centre cut out and its ends kept, finer about the centre.
double shaped(double axis, double deadZone, double curve) {
    double const size = std::min(std::abs(axis), 1.0);
    if (!(size > deadZone)) return 0.0;
    double const share = (size - deadZone) / (1.0 - deadZone);
    return std::copysign(core::pow(share, curve), axis);
}

/// A key moves the stick at a steady rate and lets it spring back twice as fast; the gamepad's stick is where
/// it is.
double axisAfter(double before, double keys, double pad, InputSettings const& settings) {
    if (keys == 0.0 && pad != 0.0) return pad;
    double const rate = kTickSeconds / settings.keySeconds * (keys == 0.0 || keys * before < 0.0 ? 2.0 : 1.0);
    return towards(before, keys, rate);
}
}  // namespace

void Stick::follow(DirectStick const& stick) {
    controls_ = {.throttle = stick.throttle.value_or(controls_.throttle),
                 .elevator = stick.elevator,
                 .aileron = stick.aileron,
                 .rudder = stick.rudder,
                 .flaps = stick.flaps,
                 .brakes = stick.brakes};
}

/// Thrust and flaps stay where they are put; an axis that is a lever acts when it moves, so that keys act beside it.
void Stick::moveLevers(InputSample const& sample, InputSettings const& settings) {
    double const rate = keyPair(sample, FlightKey::thrustDown, FlightKey::thrustUp) +
                        shaped(sample.pad.thrust, settings.thrustDeadZone, settings.thrustCurve);
    double const steps = (pressed(sample, FlightKey::thrustStepUp) ? kLeverStep : 0.0) -
                         (pressed(sample, FlightKey::thrustStepDown) ? kLeverStep : 0.0);
    double const moved = std::clamp(rate, -1.0, 1.0) * kTickSeconds / kLeverSeconds + steps;
    controls_.throttle = std::clamp(controls_.throttle + moved, 0.0, 1.0);
    leverMoved_ = moved;
    double const notches =
        (pressed(sample, FlightKey::flapsDown) ? 1.0 : 0.0) - (pressed(sample, FlightKey::flapsUp) ? 1.0 : 0.0);
    double const notch = std::round(controls_.flaps * kFlapNotches) + notches;
    if (notches != 0.0) controls_.flaps = std::clamp(notch / kFlapNotches, 0.0, 1.0);
    auto const takeLever = [](double& value, std::optional<float> now, std::optional<float> before) {
        if (now && before && *now != *before) value = std::clamp<double>(*now, 0.0, 1.0);
    };
    takeLever(controls_.throttle, sample.pad.lever, before_.pad.lever);
    if (sample.pad.lever && before_.pad.lever) leverMoved_ += static_cast<double>(*sample.pad.lever - *before_.pad.lever);
    takeLever(controls_.flaps, sample.pad.flaps, before_.pad.flaps);
}

void Stick::moveTrim(InputSample const& sample) {
    auto const move = [&](double& trim, FlightKey less, FlightKey more) {
        trim = std::clamp(trim + keyPair(sample, less, more) * kTickSeconds / kTrimSeconds, -1.0, 1.0);
    };
    move(controls_.elevatorTrim, FlightKey::trimNoseDown, FlightKey::trimNoseUp);
    move(controls_.rudderTrim, FlightKey::trimYawLeft, FlightKey::trimYawRight);
    if (sample.held(FlightKey::trimNeutral)) controls_.elevatorTrim = controls_.rudderTrim = 0.0;
}

void Stick::followKeys(InputSample const& sample, InputSettings const& settings, bool autopilot) {
    double const roll = shaped(sample.pad.roll, settings.rollDeadZone, settings.rollCurve);
    double const pitch = shaped(sample.pad.pitch, settings.pitchDeadZone, settings.pitchCurve);
    double const yaw = shaped(sample.pad.yaw, settings.yawDeadZone, settings.yawCurve);
    moveLevers(sample, settings);
    if (!autopilot) moveTrim(sample);
    controls_.elevator =
        axisAfter(controls_.elevator, keyPair(sample, FlightKey::noseDown, FlightKey::noseUp),
                  sample.mouse ? static_cast<double>(sample.mouse->pitch) : pitch, settings);
    controls_.aileron =
        axisAfter(controls_.aileron, keyPair(sample, FlightKey::rollLeft, FlightKey::rollRight),
                  sample.mouse ? static_cast<double>(sample.mouse->roll) : roll, settings);
    controls_.rudder = axisAfter(controls_.rudder, keyPair(sample, FlightKey::yawLeft, FlightKey::yawRight), yaw, settings);
    double const braking = std::max(shaped(sample.pad.brakes, settings.brakesDeadZone, settings.brakesCurve), 0.0);
    controls_.brakes = sample.held(FlightKey::brakes) ? 1.0 : braking;
}

Stick::Action Stick::step(InputSample const& sample, InputSettings const& settings, bool autopilot) {
    leverMoved_ = 0.0;
    if (sample.direct)
        follow(*sample.direct);
    else
        followKeys(sample, settings, autopilot);
    respawnTicks_ = sample.held(FlightKey::respawn) ? respawnTicks_ + 1 : 0;
    constexpr int kHeldTicks = static_cast<int>(kRespawnSeconds * core::kTicksPerSecond);
    auto const pressed = [&](FlightKey key) { return sample.held(key) && !before_.held(key); };
    Action const action{.controls = controls_,
                        .drop = pressed(FlightKey::drop),
                        .respawn = respawnTicks_ == kHeldTicks,
                        .autopilot = pressed(FlightKey::autopilot),
                        .leverMoved = leverMoved_,
                        .trimPitch = keyPair(sample, FlightKey::trimNoseDown, FlightKey::trimNoseUp),
                        .trimYaw = keyPair(sample, FlightKey::trimYawLeft, FlightKey::trimYawRight)};
    before_ = sample;
    return action;
}
}  // namespace luftpost::ui
