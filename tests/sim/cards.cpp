#include "tests/sim/cards.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace luftpost::flight {
namespace {
constexpr double kTick = core::kTickSeconds;
constexpr double kFoot = core::kMetresPerFoot;
double sinceNorth(double heading) { return heading > core::kPi ? heading - 2.0 * core::kPi : heading; }
}  // namespace

TestPilot::TestPilot(TestFlight& flight) : flight_{flight}, pitch_{flight.now().pitch} {}

void TestPilot::holdPitch(double pitch) {
    Readings const& now = flight_.now();
    double const error = pitch - now.pitch;
    double const gain = std::min(51.0 / std::max(now.tas, 15.0), 2.0);
    integral_ = std::clamp(integral_ + 1.5 * gain * error * kTick, -1.0, 1.0);
    flight_.stick.elevator = std::clamp(gain * (3.0 * error - 0.8 * now.pitchRate) + integral_, -1.0, 1.0);
}

void TestPilot::holdSpeed(double cas) {
    double const acceleration = (flight_.now().cas - lastCas_) / kTick;
    if (lastCas_ > 0.0) smoothAcceleration_ += 0.01 * (acceleration - smoothAcceleration_);
    lastCas_ = flight_.now().cas;
    double const wanted = 0.012 * (flight_.now().cas - cas) + 0.03 * smoothAcceleration_;
    pitch_ = std::clamp(pitch_ + 1.2 * wanted * kTick, -0.5, 0.5);
    holdPitch(std::clamp(pitch_ + wanted, -0.5, 0.5));
}

void TestPilot::holdClimb(double climb) {
    double const error = climb - flight_.now().climb;
    pitch_ = std::clamp(pitch_ + 0.015 * error * kTick, -0.3, 0.3);
    holdPitch(std::clamp(pitch_ + 0.02 * error, -0.3, 0.3));
}

void TestPilot::holdWings(double bank) {
    Readings const& now = flight_.now();
    flight_.stick.aileron = std::clamp(1.5 * (bank - now.roll) - 0.4 * now.rollRate, -1.0, 1.0);
    flight_.stick.rudder = std::clamp(2.0 * now.beta - 0.8 * now.yawRate, -1.0, 1.0);
}

void TestPilot::steerNorth() {
    Readings const& now = flight_.now();
    holdWings();
    flight_.stick.rudder = std::clamp(
        -6.0 * sinceNorth(now.heading) - 3.0 * now.yawRate - 0.08 * flight_.state().positionWorld.x, -1.0,
        1.0);
}

double stallSpeed_kt(double flaps) {
    TestFlight flight;
    flight.inAir(500.0, fromKnots(65.0));
    TestPilot pilot{flight};
    flight.stick.throttle = 0.0;
    flight.stick.flaps = flaps;
    double least = 1e9;
    flight.fly(60.0, [&](double t) {
        pilot.holdSpeed(fromKnots(t < 10.0 ? 63.0 : 73.0 - t));
        pilot.holdWings();
        if (t > 10.0) least = std::min(least, flight.now().cas);
        return flight.now().stalled < 0.5;
    });
    return knots(least);
}

SteadyPath steadyPath(double altitude, double cas_kt, double power) {
    TestFlight flight;
    flight.inAir(altitude, fromKnots(cas_kt) / std::sqrt(isaAir(altitude).density / 1.225));
    TestPilot pilot{flight};
    flight.stick.throttle = power;
    auto const hold = [&](double) {
        pilot.holdSpeed(fromKnots(cas_kt));
        pilot.holdWings();
        return true;
    };
    flight.fly(30.0, hold);
    // Height as energy, so that a little speed gained or lost counts too.
    auto const energyHeight = [&] {
        return flight.state().positionWorld.y + 0.5 * flight.now().tas * flight.now().tas / core::kGravity;
    };
    glm::dvec3 const start = flight.state().positionWorld;
    double const height = energyHeight();
    flight.fly(40.0, hold);
    glm::dvec3 const way = flight.state().positionWorld - start;
    return {(energyHeight() - height) / 40.0, std::hypot(way.x, way.z)};
}

Best bestGlide() {
    Best best{0.0, 0.0};
    for (double kt = 60.0; kt <= 84.0; kt += 4.0) {
        SteadyPath const path = steadyPath(500.0, kt, 0.0);
        double const ratio = path.run_m / (-path.climb_mps * 40.0);
        if (ratio > best.value) best = {ratio, kt};
    }
    return best;
}

Best bestClimb_fpm(double altitude) {
    Best best{-1e9, 0.0};
    double const low = altitude > 1000.0 ? 62.0 : 67.0;
    for (double kt = low; kt <= low + 16.0; kt += 3.0) {
        double const climb = steadyPath(altitude, kt, 1.0).climb_mps / kFoot * 60.0;
        if (climb > best.value) best = {climb, kt};
    }
    return best;
}

double levelSpeed_kt() {
    TestFlight flight;
    flight.inAir(10.0, fromKnots(115.0));
    TestPilot pilot{flight};
    flight.stick.throttle = 1.0;
    flight.fly(90.0, [&](double) {
        pilot.holdClimb(0.3 * (10.0 - flight.state().positionWorld.y));
        pilot.holdWings();
        return true;
    });
    return knots(flight.now().cas);
}

double ceiling_ft() {
    double low = 10000.0, high = 17000.0;
    double atLow = bestClimb_fpm(low * kFoot).value, atHigh = bestClimb_fpm(high * kFoot).value;
    return low + (high - low) * (atLow - 100.0) / (atLow - atHigh);
}

Distances takeOff() {
    TestFlight flight;
    flight.onRunway();
    flight.stick.throttle = 1.0;
    flight.stick.flaps = 1.0 / 3.0;
    TestPilot pilot{flight};
    Distances answer;
    flight.fly(60.0, [&](double) {
        pilot.steerNorth();
        if (flight.now().cas > fromKnots(50.0)) pilot.holdPitch(0.17);
        double const gone = -flight.state().positionWorld.z / kFoot;
        answer.off_m = std::max(answer.off_m, std::abs(flight.state().positionWorld.x));
        if (answer.roll_ft == 0.0 && flight.now().height > 0.3) answer.roll_ft = gone;
        answer.over50ft_ft = gone;
        return flight.now().height < 50.0 * kFoot && !flight.state().crashed();
    });
    answer.crashed = flight.state().crashed();
    return answer;
}

Distances landing(double windFromRight_kt) {
    TestFlight flight;
    flight.wind = {-fromKnots(windFromRight_kt), 0.0, 0.0};
    flight.inAir(60.0, fromKnots(64.0));
    // Crabbed, so that the path over the ground is north.
    double const crab = std::asin(fromKnots(windFromRight_kt) / fromKnots(64.0));
    flight.aircraft.startInAir({0.0, 60.0, 0.0}, crab, fromKnots(64.0), flight.air, flight.ground, 0.0);
    TestPilot pilot{flight};
    flight.stick.throttle = 0.0;
    Distances answer;
    double at50ft = 0.0, touched = 0.0, pitch = 0.0;
    flight.fly(90.0, [&](double) {
        Readings const& now = flight.now();
        double const x = flight.state().positionWorld.x, drift = flight.state().velocityWorld.x;
        double const gone = -flight.state().positionWorld.z / kFoot;
        bool const down = touched > 0.0;
        flight.stick.flaps = 1.0;
        if (down) {
            flight.stick.brakes = 0.5;
            pilot.steerNorth();
            flight.stick.aileron = std::clamp(windFromRight_kt / 15.0 - 1.5 * now.roll, -1.0, 1.0);
            flight.stick.elevator = 0.3;
        } else {
            // Wing low: the bank keeps the line, the rudder the heading.
            pilot.holdWings(std::clamp(-0.02 * x - 0.06 * drift, -0.25, 0.25));
            flight.stick.rudder = std::clamp(-4.0 * sinceNorth(now.heading) - 2.0 * now.yawRate, -1.0, 1.0);
            if (now.height > 9.0) {
                pilot.holdSpeed(fromKnots(63.0));
                pitch = now.pitch;
            } else {  // flare
                double const wanted = -0.35 - 0.26 * now.height;
                pitch = std::clamp(pitch + 0.2 * (wanted - now.climb) * kTick, -0.1, 0.2);
                pilot.holdPitch(pitch + 0.04 * (wanted - now.climb));
            }
        }
        if (at50ft == 0.0 && now.height < 50.0 * kFoot) at50ft = gone;
        if (!down && flight.state().touchdownTick >= 0) {
            touched = gone;
            answer.touchdown_mps = flight.state().touchdownSpeed;
        }
        if (touched > 0.0) answer.off_m = std::max(answer.off_m, std::abs(x));
        answer.roll_ft = gone - touched;
        answer.over50ft_ft = gone - at50ft;
        return !(down && now.groundSpeed < 1.0) && !flight.state().crashed();
    });
    answer.crashed = flight.state().crashed();
    return answer;
}

Oscillation oscillation(std::vector<double> const& record, double step, double mean) {
    std::vector<double> times, sizes;
    for (std::size_t i = 1; i + 1 < record.size() && sizes.size() < 3; ++i) {
        double const a = record[i - 1] - mean, b = record[i] - mean, c = record[i + 1] - mean;
        if ((b > 0.0 && b > a && b >= c) || (b < 0.0 && b < a && b <= c)) {
            if (!sizes.empty() && (b > 0.0) == (sizes.back() > 0.0)) continue;  // one extreme a side
            times.push_back(static_cast<double>(i) * step);
            sizes.push_back(b);
        }
    }
    if (sizes.size() < 2) return {};
    double const decrement = std::log(std::abs(sizes[0] / sizes[1]));  // over half a period
    return {2.0 * (times[1] - times[0]), decrement / std::hypot(core::kPi, decrement)};
}

Oscillation phugoid() {
    TestFlight flight;
    flight.inAir(304.8, fromKnots(100.0));
    double const mean = flight.now().tas;
    std::vector<double> record;
    flight.fly(70.0, [&](double t) {
        flight.stick.elevator = t < 3.0 ? 0.06 : 0.0;
        flight.stick.aileron = std::clamp(-1.5 * flight.now().roll - 0.4 * flight.now().rollRate, -1.0, 1.0);
        if (t > 5.0) record.push_back(flight.now().tas);
        return true;
    });
    return oscillation(record, kTick, mean);
}

Oscillation shortPeriod() {
    TestFlight flight;
    flight.inAir(304.8, fromKnots(100.0));
    std::vector<double> record;
    flight.fly(4.0, [&](double t) {
        flight.stick.elevator = t < 0.5 ? 0.1 : 0.0;
        if (t > 0.55) record.push_back(flight.now().pitchRate);
        return true;
    });
    return oscillation(record, kTick, 0.0);
}

Oscillation dutchRoll() {
    TestFlight flight;
    flight.inAir(304.8, fromKnots(100.0));
    std::vector<double> record;
    flight.fly(14.0, [&](double t) {
        flight.stick.rudder = t < 1.0 ? 0.5 : t < 2.0 ? -0.5 : 0.0;
        if (t > 2.3) record.push_back(flight.now().yawRate);
        return true;
    });
    return oscillation(record, kTick, 0.0);
}

Roll fullAileron(double kt) {
    TestFlight flight;
    flight.inAir(304.8, fromKnots(kt));
    std::vector<double> rates;
    flight.stick.aileron = 1.0;
    flight.fly(1.5, [&](double) { return rates.push_back(flight.now().rollRate), true; });
    double const most = *std::max_element(rates.begin(), rates.end());
    auto const there = std::find_if(rates.begin(), rates.end(), [&](double r) { return r > 0.632 * most; });
    return {core::degrees(most), static_cast<double>(there - rates.begin()) * kTick};
}

double spiralDoubling_s(double kt) {
    TestFlight flight;
    flight.inAir(600.0, fromKnots(kt));
    flight.fly(6.0, [&](double) {
        Readings const& now = flight.now();
        flight.stick.aileron = std::clamp(core::radians(10.0) - now.roll - 0.3 * now.rollRate, -1.0, 1.0);
        return true;
    });
    flight.stick.aileron = 0.0;
    flight.fly(4.0);
    double const before = flight.now().roll;
    flight.fly(12.0);
    return 12.0 * std::log(2.0) / std::log(flight.now().roll / before);
}

Pulse elevatorPulse() {
    TestFlight flight;
    flight.inAir(304.8, fromKnots(100.0));
    double const trim = flight.now().alpha;
    Pulse pulse{};
    flight.fly(2.0, [&](double t) {
        flight.stick.elevator = t < 0.5 ? 0.1 : 0.0;
        pulse.alpha_deg = std::max(pulse.alpha_deg, core::degrees(flight.now().alpha - trim));
        pulse.pitchRate_dps = std::max(pulse.pitchRate_dps, core::degrees(flight.now().pitchRate));
        return true;
    });
    pulse.leftAlpha_deg = core::degrees(flight.now().alpha - trim);
    pulse.leftPitchRate_dps = core::degrees(flight.now().pitchRate);
    return pulse;
}

double gustLoad_g(double w20_fps) {
    // Vertical gusts of the Dryden spectrum (MIL-F-8785C) frozen along the way: a sum of waves with random
    // phases.
    constexpr int kWaves = 400;
    double const scale = 500.0 * kFoot, sigma = 0.1 * w20_fps * kFoot;
    std::mt19937 random{7};
    std::vector<double> number(kWaves), size(kWaves), phase(kWaves);
    double const low = 0.02 / scale, high = 200.0 / scale, ratio = std::pow(high / low, 1.0 / kWaves);
    for (int i = 0; i < kWaves; ++i) {
        double const k = low * std::pow(ratio, i + 0.5), lk = scale * k;
        double const spectrum =
            sigma * sigma * scale / core::kPi * (1.0 + 3.0 * lk * lk) / std::pow(1.0 + lk * lk, 2.0);
        number[i] = k;
        size[i] = std::sqrt(2.0 * spectrum * k * (std::sqrt(ratio) - 1.0 / std::sqrt(ratio)));
        phase[i] = 2.0 * core::kPi * (static_cast<double>(random()) / 4294967296.0);
    }
    TestFlight flight;
    flight.air = [&](glm::dvec3 const& p, core::UtcSeconds) {
        core::AirSample sample = isaAir(p.y);
        for (int i = 0; i < kWaves; ++i) sample.windWorld.y += size[i] * std::cos(number[i] * p.z + phase[i]);
        return sample;
    };
    flight.inAir(500.0 * kFoot, fromKnots(100.0));
    TestPilot pilot{flight};
    double squares = 0.0;
    int count = 0;
    flight.fly(60.0, [&](double t) {
        pilot.holdWings();
        if (t > 3.0) squares += std::pow(flight.now().loadFactor - 1.0, 2.0), ++count;
        return true;
    });
    return std::sqrt(squares / count);
}
}  // namespace luftpost::flight
