#include "game/app/response_trial.h"

#include <utility>

#include "engine/core/frames.h"

namespace luftpost::app {
namespace {
constexpr double kAltitude = 1000.0, kSpeed = 50.0;  // m, m/s
constexpr int kTicksPerPoint = 12;

core::AirSample stillAir(glm::dvec3 const&, core::UtcSeconds) { return {}; }
core::GroundSample flatGround(double, double) { return {}; }

/// The hand: stick to the right and let go, stick back and let go, pedal and let go.
flight::Controls handAt(double t, double throttle) {
    auto const within = [t](double from, double to) { return t >= from && t < to ? 1.0 : 0.0; };
    return {.throttle = throttle,
            .elevator = 0.4 * within(6.0, 7.0),
            .aileron = within(0.5, 1.5),
            .rudder = within(11.0, 12.5)};
}

bool same(flight::AssistSettings const& a, flight::AssistSettings const& b) {
    flight::AssistSettings left = a, right = b;
    core::SettingList one, other;
    core::appendSettings(one, left, flight::assistFields);
    core::appendSettings(other, right, flight::assistFields);
    return core::changedSettings(one) == core::changedSettings(other);
}
}  // namespace

ResponseTrial::ResponseTrial(flight::Airframe airframe) : airframe_{std::move(airframe)} {}

ResponseTrial::Run ResponseTrial::begin(PilotSettings const& pilot,
                                        flight::AssistSettings const& assist) const {
    constexpr double kPayload = 240.0, kFuel = 100.0;
    Run run{flight::Aircraft{airframe_, kPayload, kFuel}, pilot, assist};
    run.aircraft.startInAir({0.0, kAltitude, 0.0}, 0.0, kSpeed, stillAir, flatGround, 0.0);
    return run;
}

bool ResponseTrial::fly(Run& run, int& ticks) {
    constexpr int kEnd = static_cast<int>(kSeconds * core::kTicksPerSecond);
    double const trimmed = run.aircraft.state().trim.throttle;
    for (; ticks > 0 && run.tick < kEnd; --ticks, ++run.tick) {
        double const t = run.tick * core::kTickSeconds;
        flight::Controls const hand = handAt(t, trimmed);
        run.aircraft.step(hand, run.pilot.assist, run.assist, stillAir, flatGround, 0.0);
        if (run.tick % kTicksPerPoint != 0) continue;
        flight::Readings const& now = run.aircraft.state().readings;
        run.points.push_back({t, hand.aileron, hand.elevator, hand.rudder, now.roll, now.pitchRate,
                              now.yawRate, run.assist.maxThrottle});
    }
    return run.tick >= kEnd;
}

void ResponseTrial::follow(PilotSettings const& pilot, flight::AssistSettings const& assist, int ticks) {
    bool const otherPilot = !usual_ || usual_->pilot.assist != pilot.assist;
    if (otherPilot) usual_ = begin(pilot, {}), usualDone_ = false;
    if (otherPilot || !now_ || !same(now_->assist, assist)) now_ = begin(pilot, assist), nowDone_ = false;
    if (!usualDone_ && (usualDone_ = fly(*usual_, ticks))) curves_.usual = usual_->points;
    if (!nowDone_ && (nowDone_ = fly(*now_, ticks))) curves_.now = now_->points;
}
}  // namespace luftpost::app
