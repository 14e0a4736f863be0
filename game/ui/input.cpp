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

/// The gamepad's axis with its centre cut out and its ends kept.
double shaped(double axis, InputSettings const& settings) {
    double const size = std::min(std::abs(axis), 1.0);
    if (!(size > settings.padDeadZone)) return 0.0;
    double const share = (size - settings.padDeadZone) / (1.0 - settings.padDeadZone);
    return std::copysign(core::pow(share, settings.padExponent), axis);
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
    controls_ = {stick.throttle.value_or(controls_.throttle),
                 stick.elevator,
                 stick.aileron,
                 stick.rudder,
                 stick.flaps,
                 stick.brakes};
}

void Stick::followKeys(InputSample const& sample, InputSettings const& settings) {
    double const lever =
        keyPair(sample, FlightKey::thrustDown, FlightKey::thrustUp) + shaped(sample.pad.thrust, settings);
    controls_.throttle = std::clamp(
        controls_.throttle + std::clamp(lever, -1.0, 1.0) * kTickSeconds / kLeverSeconds, 0.0, 1.0);
    double const pitch = shaped(sample.pad.pitch, settings) * (settings.invertPitch ? -1.0 : 1.0);
    controls_.elevator = axisAfter(controls_.elevator,
                                   keyPair(sample, FlightKey::noseDown, FlightKey::noseUp), pitch, settings);
    controls_.aileron =
        axisAfter(controls_.aileron, keyPair(sample, FlightKey::rollLeft, FlightKey::rollRight),
                  shaped(sample.pad.roll, settings), settings);
    controls_.rudder = axisAfter(controls_.rudder, keyPair(sample, FlightKey::yawLeft, FlightKey::yawRight),
                                 shaped(sample.pad.yaw, settings), settings);
    controls_.brakes = sample.held(FlightKey::brakes) ? 1.0 : std::clamp<double>(sample.pad.brakes, 0.0, 1.0);
    auto const pressed = [&](FlightKey key) { return sample.held(key) && !before_.held(key); };
    double const notches =
        (pressed(FlightKey::flapsDown) ? 1.0 : 0.0) - (pressed(FlightKey::flapsUp) ? 1.0 : 0.0);
    double const notch = std::round(controls_.flaps * kFlapNotches) + notches;
    if (notches != 0.0) controls_.flaps = std::clamp(notch / kFlapNotches, 0.0, 1.0);
}

Stick::Action Stick::step(InputSample const& sample, InputSettings const& settings) {
    if (sample.direct)
        follow(*sample.direct);
    else
        followKeys(sample, settings);
    respawnTicks_ = sample.held(FlightKey::respawn) ? respawnTicks_ + 1 : 0;
    constexpr int kHeldTicks = static_cast<int>(kRespawnSeconds * core::kTicksPerSecond);
    auto const pressed = [&](FlightKey key) { return sample.held(key) && !before_.held(key); };
    Action const action{controls_, pressed(FlightKey::drop), respawnTicks_ == kHeldTicks,
                        pressed(FlightKey::autopilot)};
    before_ = sample;
    return action;
}
}  // namespace luftpost::ui
