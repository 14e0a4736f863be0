#include "game/bot/test_pilot.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::bot {
namespace {
constexpr double kTick = core::kTickSeconds;
constexpr double kReferenceSpeed = 51.0;  // m/s, where the gains were chosen
constexpr double kUnload = 8.0;            // of the stick per rad beyond the angle of attack that is allowed
constexpr double kAlphaSeconds = 0.4;     // over which the angle of attack is smoothed
constexpr double kSteepestTurn = 0.5;     // rad of bank
constexpr double kSinkGain = 2.0;         // 1/s, how fast a wrong sink is mended close to the ground
constexpr double kLiftSeconds = 3.0;      // over which the pilot learns how the wing bites
constexpr double kZeroLift = 0.09;        // rad that the angle of attack lies over the one without lift, a notch of flap out
}  // namespace

double turnBetween(double from, double to) {
    return core::atan2(core::sin(to - from), core::cos(to - from));
}
double knots(double metresPerSecond) { return metresPerSecond / core::kMetresPerSecondPerKnot; }
double fromKnots(double kt) { return kt * core::kMetresPerSecondPerKnot; }

void TestPilot::look(flight::AircraftState const& state) {
    bool const first = !state_;
    state_ = &state;
    double const alpha = now().pitch - now().climb / std::max(now().tas, 15.0);
    alpha_ += (first ? 1.0 : std::min(kTick / kAlphaSeconds, 1.0)) * (alpha - alpha_);
    double const bite = now().loadFactor / (std::max(now().alpha + kZeroLift, 0.03) * pressure());
    bite_ += (first ? 1.0 : std::min(kTick / kLiftSeconds, 1.0)) * (bite - bite_);
    if (!first) return;
    stick.throttle = state.trim.throttle;
    takeOver();
}

void TestPilot::takeOver() {
    pitch_ = now().pitch;
    power_ = stick.throttle;
    integral_ = lastCas_ = smoothAcceleration_ = 0.0;
}

void TestPilot::pointPath(double angle) {
    constexpr double kEasyClimb = core::radians(18.0);  // of the stick at its stop, with easy
    double const path = now().climb / std::max(now().tas, 15.0);
    stick.elevator = assist == flight::AssistLevel::easy ? std::clamp(angle / kEasyClimb, -1.0, 1.0)
                                                         : std::clamp(4.0 * (angle - path), -0.6, 0.6);
}

double TestPilot::rollTo(double bank) const {
    constexpr double kEasyBank = core::radians(50.0);  // of the stick at its stop, with easy
    if (assist == flight::AssistLevel::easy) return std::clamp(bank / kEasyBank, -1.0, 1.0);
    double const damping = assist == flight::AssistLevel::normal ? 0.0 : 0.4 * now().rollRate;
    return std::clamp(1.5 * (bank - now().roll) - damping, -1.0, 1.0);
}

void TestPilot::holdPitch(double pitch) {
    if (!moveSurfaces()) return pointPath(pitch - alpha_);
    double const error = pitch - now().pitch;
    double const gain = std::min(kReferenceSpeed / std::max(now().tas, 15.0), 2.0);
    double const tooMuch = std::max(now().alpha - mostAlpha, 0.0);
    integral_ = std::clamp(integral_ + (1.5 * gain * error - kUnload * tooMuch) * kTick, -1.0, 1.0);
    stick.elevator = std::clamp(gain * (3.0 * error - 0.8 * now().pitchRate) + integral_ - kUnload * tooMuch, -1.0, 1.0);
}

void TestPilot::holdSpeed(double cas) {
    double const acceleration = (now().cas - lastCas_) / kTick;
    if (lastCas_ > 0.0) smoothAcceleration_ += 0.01 * (acceleration - smoothAcceleration_);
    lastCas_ = now().cas;
    double const wanted = 0.012 * (now().cas - cas) + 0.03 * smoothAcceleration_;
    pitch_ = std::clamp(pitch_ + 1.2 * wanted * kTick, -0.5, 0.5);
    holdPitch(std::clamp(pitch_ + wanted, -0.5, 0.5));
}

void TestPilot::holdSpeedByPower(double cas, double gain) {
    double const error = cas - now().cas;
    power_ = std::clamp(power_ + 0.006 * error * kTick, 0.0, 1.0);
    stick.throttle = std::clamp(power_ + gain * error, 0.0, 1.0);
}

void TestPilot::holdClimb(double climb) {
    if (!moveSurfaces()) return pointPath(climb / std::max(now().tas, 15.0));
    double const error = climb - now().climb;
    pitch_ = std::clamp(pitch_ + 0.015 * error * kTick, -0.3, 0.3);
    holdPitch(std::clamp(pitch_ + 0.02 * error, -0.3, 0.3));
}

void TestPilot::holdPath(double angle) {
    if (!moveSurfaces()) return pointPath(angle);
    double const path = now().climb / std::max(now().tas, 15.0);
    holdPitch(std::clamp(alpha_ + angle + 1.3 * (angle - path), -0.2, 0.25));
}

void TestPilot::holdSink(double climb) {
    if (!moveSurfaces()) return pointPath(climb / std::max(now().tas, 15.0));
    double const load = 1.0 + std::clamp(kSinkGain * (climb - now().climb) / core::kGravity, -0.3, 0.6);
    double const alpha = std::min(load / (bite_ * pressure()) - kZeroLift, mostAlpha);
    double const error = std::clamp(alpha - now().alpha, -0.15, 0.15);
    double const gain = std::min(kReferenceSpeed / std::max(now().tas, 15.0), 2.0);
    double const turning = (now().loadFactor - 1.0) * core::kGravity / std::max(now().tas, 15.0);
    integral_ = std::clamp(integral_ + 10.0 * gain * error * kTick, -1.0, 1.0);
    stick.elevator = std::clamp(gain * (8.0 * error - (now().pitchRate - turning)) + integral_, -1.0, 1.0);
}

void TestPilot::holdAltitude(double altitude, double most) {
    holdClimb(std::clamp(0.3 * (altitude - state().positionWorld.y), -most, most));
}

void TestPilot::holdWings(double bank) {
    double const turning = core::kGravity / std::max(now().tas, 15.0) * core::sin(bank);
    stick.aileron = rollTo(bank);
    stick.rudder = !moveSurfaces() ? 0.0 : std::clamp(2.0 * now().beta - 0.8 * (now().yawRate - turning), -1.0, 1.0);
}

void TestPilot::holdHeading(double heading) {
    holdWings(std::clamp(1.2 * turnBetween(now().heading, heading), -kSteepestTurn, kSteepestTurn));
}

void TestPilot::holdTrack(double course) {
    glm::dvec3 const& v = state().velocityWorld;
    double const track = core::atan2(v.x, -v.z);
    holdWings(std::clamp(1.2 * turnBetween(track, course), -kSteepestTurn, kSteepestTurn));
}

void TestPilot::steerAlong(double heading, double across) {
    holdWings();
    double const off = turnBetween(heading, now().heading);
    stick.rudder = std::clamp(-6.0 * off - 3.0 * now().yawRate - 0.08 * across, -1.0, 1.0);
}

void TestPilot::slipAlong(double heading, double across, double drift, double wind) {
    holdWings(std::clamp(0.013 * wind - 0.02 * across - 0.08 * drift, -0.28, 0.28));
    stick.rudder = std::clamp(-4.0 * turnBetween(heading, now().heading) - 2.0 * now().yawRate, -1.0, 1.0);
}
}  // namespace luftpost::bot
