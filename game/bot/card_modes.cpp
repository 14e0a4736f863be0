// The cards of motion: phugoid, short period, Dutch roll, roll, spiral, trim.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "game/bot/cards.h"
#include "game/bot/oscillation.h"

namespace luftpost::bot {
namespace {
constexpr double kTick = core::kTickSeconds;
}  // namespace

/// The nose up a little for three seconds, then let go; the wings are kept level.
Manoeuvre Card::phugoid() {
    double const mean = now().tas;
    std::vector<double> record;
    for (double t = 0.0; t < 70.0; t += kTick, co_await nextTick()) {
        pilot_.stick.elevator = t < 3.0 ? 0.06 : 0.0;
        pilot_.stick.aileron = std::clamp(-1.5 * now().roll - 0.4 * now().rollRate, -1.0, 1.0);
        if (t > 5.0) record.push_back(now().tas);
    }
    Oscillation const mode = oscillation(record, kTick, mean);
    put("phugoid_s", mode.period);
    put("phugoid_damping", mode.damping);
}

/// Elevator 0.1 for half a second: the peaks, what swings after it, and what is left 1.5 s after its end.
Manoeuvre Card::shortPeriod() {
    double const trim = now().alpha;
    double alpha = 0.0, rate = 0.0, alphaLeft = 0.0, rateLeft = 0.0;
    std::vector<double> record;
    for (double t = 0.0; t < 4.0; t += kTick, co_await nextTick()) {
        pilot_.stick.elevator = t < 0.5 ? 0.1 : 0.0;
        alpha = std::max(alpha, now().alpha - trim);
        rate = std::max(rate, now().pitchRate);
        if (t < 2.0) alphaLeft = now().alpha - trim, rateLeft = now().pitchRate;
        if (t > 0.55) record.push_back(now().pitchRate);
    }
    Oscillation const mode = oscillation(record, kTick, 0.0);
    put("short_period_s", mode.period);
    put("short_period_damping", mode.damping);
    put("pulse_alpha_deg", core::degrees(alpha));
    put("pulse_q_dps", core::degrees(rate));
    put("pulse_alpha_left_deg", core::degrees(alphaLeft));
    put("pulse_q_left_dps", core::degrees(rateLeft));
}

/// A pedal to each side, then feet off.
Manoeuvre Card::dutchRoll() {
    std::vector<double> record;
    for (double t = 0.0; t < 14.0; t += kTick, co_await nextTick()) {
        pilot_.stick.rudder = t < 1.0 ? 0.5 : t < 2.0 ? -0.5 : 0.0;
        if (t > 2.3) record.push_back(now().yawRate);
    }
    Oscillation const mode = oscillation(record, kTick, 0.0);
    put("dutch_roll_s", mode.period);
    put("dutch_roll_damping", mode.damping);
}

/// Level at a speed until it is trimmed: the stick of the last ten seconds is what may be held hands off.
Manoeuvre Card::flyLevel(double cas, double seconds) {
    constexpr double kMean = 10.0;  // s
    flight::Controls sum;
    double alpha = 0.0;
    pilot_.takeOver();
    for (double t = 0.0; t < seconds; t += kTick, co_await nextTick()) {
        pilot_.holdAltitude(altitude_);
        pilot_.holdSpeedByPower(cas);
        pilot_.holdHeading(course_);
        if (t < seconds - kMean) continue;
        double const share = kTick / kMean;
        sum.throttle += share * pilot_.stick.throttle;
        sum.elevator += share * pilot_.stick.elevator;
        sum.aileron += share * pilot_.stick.aileron;
        sum.rudder += share * pilot_.stick.rudder;
        alpha += share * now().alpha;
    }
    handsOff_ = pilot_.stick = sum;
    alpha_ = alpha;
}

/// The fastest roll with the aileron at its stop, and the time to 63 % of it.
Manoeuvre Card::fullAileron() {
    std::vector<double> rates;
    for (double t = 0.0; t < 1.5; t += kTick, co_await nextTick()) {
        pilot_.stick.aileron = 1.0;
        rates.push_back(now().rollRate);
    }
    measured_ = *std::max_element(rates.begin(), rates.end());
    auto const there =
        std::find_if(rates.begin(), rates.end(), [&](double rate) { return rate > 0.632 * measured_; });
    constant_ = static_cast<double>(there - rates.begin()) * kTick;
}

Manoeuvre Card::roll() {
    co_await fullAileron();
    put("roll_cruise_dps", core::degrees(measured_));
    put("roll_time_constant_s", constant_);
    co_await flyLevel(stalls(1.37), 90.0);
    co_await fullAileron();
    put("roll_slow_dps", core::degrees(measured_));
}

/// Banked by 10 degrees, hands off: in how many seconds the bank doubles; negative: halves.
Manoeuvre Card::leaveToItself() {
    for (double t = 0.0; t < 6.0; t += kTick, co_await nextTick()) {
        double const off = core::radians(10.0) - now().roll;
        pilot_.stick = handsOff_;
        pilot_.stick.aileron = std::clamp(off - 0.3 * now().rollRate + handsOff_.aileron, -1.0, 1.0);
    }
    pilot_.stick = handsOff_;
    for (double t = 0.0; t < 4.0; t += kTick) co_await nextTick();
    double const before = now().roll;
    for (double t = 0.0; t < 12.0; t += kTick) co_await nextTick();
    measured_ = 12.0 * core::log(2.0) / core::log(std::abs(now().roll / before));
}

Manoeuvre Card::spiral() {
    handsOff_ = pilot_.stick;  // of the start's trim
    co_await leaveToItself();
    put("spiral_slow_doubling_s", measured_);
    co_await flyLevel(stalls(1.96), 120.0);
    co_await leaveToItself();
    put("spiral_cruise_doubling_s", measured_);
}

Manoeuvre Card::trim() {
    for (double share : {1.18, 1.49, 1.96, 2.35}) {
        co_await turnBack(std::max(now().cas, stalls(1.3)));
        co_await flyLevel(stalls(share), 80.0);
        put(fmt::format("trim_{:.0f}_kcas_alpha_deg", knots(stalls(share))), core::degrees(alpha_));
    }
}
}  // namespace luftpost::bot
