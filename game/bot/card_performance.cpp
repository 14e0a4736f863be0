// The cards of performance: stall, glide, climb, level speed, ceiling.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "game/bot/cards.h"

namespace luftpost::bot {
namespace {
constexpr double kTick = core::kTickSeconds;
constexpr double kFoot = core::kMetresPerFoot;
constexpr double kSettle = 30.0;  // s on a new speed before the measuring begins

/// Height that the speed is worth, too: a little speed gained or lost counts.
double energyHeight(flight::AircraftState const& state) {
    return state.positionWorld.y + 0.5 * state.readings.tas * state.readings.tas / core::kGravity;
}
/// The highest of a row of values at equal steps: the vertex of the parabola through it and its neighbours.
struct Peak {
    double at = 0.0, value = -1.0e9;
};
Peak peakOf(std::vector<double> const& values, double from, double step) {
    auto const most = std::max_element(values.begin(), values.end());
    double const at = from + step * static_cast<double>(most - values.begin());
    if (most == values.begin() || most + 1 == values.end()) return {at, *most};
    double const slope = 0.5 * (most[1] - most[-1]), bend = most[-1] - 2.0 * *most + most[1];
    if (!(bend < 0.0)) return {at, *most};
    return {at - step * slope / bend, *most - 0.5 * slope * slope / bend};
}
double feetPerMinute(double climb) { return climb / kFoot * 60.0; }
}  // namespace

Manoeuvre Card::stall() {
    co_await slowDown("stall_clean_kcas");
    for (double t = 0.0; t < 45.0; t += kTick, co_await nextTick()) {  // recover, and up again
        pilot_.stick.throttle = 1.0;
        pilot_.stick.flaps = 0.0;
        pilot_.holdSpeed(stalls(1.45));
        pilot_.holdHeading(course_);
    }
    pilot_.stick.flaps = 1.0;
    co_await slowDown("stall_full_flap_kcas");
}

/// Power off, slowing by 1 kt/s: the least calibrated airspeed before half the wing has stalled.
Manoeuvre Card::slowDown(std::string key) {
    double const from = knots(stalls(1.24));
    double least = 1.0e9;
    pilot_.stick.throttle = 0.0;
    for (double t = 0.0; t < 60.0 && now().stalled < 0.5; t += kTick, co_await nextTick()) {
        pilot_.holdSpeed(fromKnots(from - std::max(t - 10.0, 0.0)));
        pilot_.holdWings();
        least = std::min(least, now().cas);
    }
    if (now().stalled >= 0.5) put(std::move(key), knots(least));
}

/// To the opposite course at a speed, so that the air work stays where it is.
Manoeuvre Card::turnBack(double cas) {
    course_ += course_ > core::kPi ? -core::kPi : core::kPi;
    while (std::abs(turnBetween(now().heading, course_)) > 0.05) {
        pilot_.holdSpeed(cas);
        pilot_.holdHeading(course_);
        co_await nextTick();
    }
}

/// The steady path at a calibrated airspeed with the lever as it is: settles, then is measured.
Manoeuvre Card::flyPath(double cas) {
    double height = 0.0, run = 0.0;
    for (double t = 0.0; t < kSettle + kPathSeconds; t += kTick, co_await nextTick()) {
        pilot_.holdSpeed(cas);
        pilot_.holdHeading(course_);
        if (t < kSettle)
            height = energyHeight(pilot_.state());
        else
            run += std::sqrt(std::max(now().tas * now().tas - now().climb * now().climb, 0.0)) * kTick;
    }
    path_ = {(energyHeight(pilot_.state()) - height) / kPathSeconds, run};
}

Manoeuvre Card::glide() {
    std::vector<double> ratios;
    double const slowest = knots(stalls(1.18));
    for (double kt = slowest; kt <= slowest + 24.0; kt += 4.0) {
        pilot_.stick.throttle = 0.0;
        co_await turnBack(stalls(1.45));
        co_await flyPath(fromKnots(kt));
        ratios.push_back(path_.run_m / (-path_.climb_mps * kPathSeconds));
    }
    Peak const best = peakOf(ratios, slowest, 4.0);
    put("glide_ratio", best.value);
    put("glide_kcas", best.at);
}

/// Back down with the lever back, and level.
Manoeuvre Card::descend(double altitude) {
    pilot_.stick.throttle = 0.0;
    while (pilot_.state().positionWorld.y > altitude + 25.0) {
        pilot_.holdSpeed(stalls(1.6));
        pilot_.holdHeading(course_);
        co_await nextTick();
    }
    pilot_.takeOver();
    for (double t = 0.0; t < 10.0; t += kTick, co_await nextTick()) {
        pilot_.holdAltitude(altitude);
        pilot_.holdSpeedByPower(stalls(1.45));
        pilot_.holdHeading(course_);
    }
}

/// Sawtooth climbs at full power through the same air.
Manoeuvre Card::climb() {
    std::vector<double> climbs;
    double const slowest = knots(stalls(1.31));
    for (double kt = slowest; kt <= slowest + 16.0; kt += 3.0) {
        pilot_.stick.throttle = 1.0;
        co_await flyPath(fromKnots(kt));
        climbs.push_back(path_.climb_mps);
        co_await turnBack(stalls(1.6));
        co_await descend(altitude_);
    }
    Peak const best = peakOf(climbs, slowest, 3.0);
    put("climb_fpm", feetPerMinute(best.value));
    put("climb_kcas", best.at);
    put("climb_from_m", altitude_);
}

Manoeuvre Card::level() {
    pilot_.stick.throttle = 1.0;
    for (double t = 0.0; t < 90.0; t += kTick, co_await nextTick()) {
        pilot_.holdAltitude(altitude_);
        pilot_.holdHeading(course_);
    }
    put("level_kcas", knots(now().cas));
    put("level_ktas", knots(now().tas));
    put("level_at_m", pilot_.state().positionWorld.y);
}

/// Climbs at full power until 100 ft/min are left over half a minute.
Manoeuvre Card::ceiling() {
    pilot_.stick.throttle = 1.0;
    double const cas = stalls(1.27);
    for (double climb = 1.0e9; feetPerMinute(climb) > 100.0;) {
        double const before = energyHeight(pilot_.state());
        for (double t = 0.0; t < 30.0; t += kTick, co_await nextTick()) {
            pilot_.holdSpeed(cas);
            pilot_.holdHeading(course_);
        }
        climb = (energyHeight(pilot_.state()) - before) / 30.0;
    }
    put("ceiling_ft", pilot_.state().positionWorld.y / kFoot);
    put("ceiling_mass_kg", now().mass);
}
}  // namespace luftpost::bot
