// Test cards: each flies one manoeuvre with the bare stick (assist sim) and gives its figures.
#pragma once
#include <algorithm>
#include <vector>

#include "tests/sim/test_flight.h"

namespace luftpost::flight {
/// The test pilot: holds a pitch attitude or an airspeed with the elevator, the wings level, the ball centred.
class TestPilot {
public:
    explicit TestPilot(TestFlight& flight) : flight_{flight} {}

    void holdPitch(double pitch) {
        Readings const& now = flight_.now();
        double const error = pitch - now.pitch;
        double const gain = std::min(51.0 / std::max(now.tas, 15.0), 2.0);
        integral_ = std::clamp(integral_ + 1.5 * gain * error * core::kTickSeconds, -1.0, 1.0);
        flight_.stick.elevator = std::clamp(gain * (3.0 * error - 0.8 * now.pitchRate) + integral_, -1.0, 1.0);
    }
    /// Calibrated airspeed in m/s, by pitch.
    void holdSpeed(double cas) {
        double const acceleration = (flight_.now().cas - lastCas_) / core::kTickSeconds;
        if (lastCas_ > 0.0) smoothAcceleration_ += 0.01 * (acceleration - smoothAcceleration_);
        lastCas_ = flight_.now().cas;
        double const wanted = 0.012 * (flight_.now().cas - cas) + 0.03 * smoothAcceleration_;
        pitch_ = std::clamp(pitch_ + 0.3 * wanted * core::kTickSeconds * 4.0, -0.5, 0.5);
        holdPitch(std::clamp(pitch_ + wanted, -0.5, 0.5));
    }
    void holdWings(double bank = 0.0) {
        Readings const& now = flight_.now();
        flight_.stick.aileron = std::clamp(1.5 * (bank - now.roll) - 0.4 * now.rollRate, -1.0, 1.0);
        flight_.stick.rudder = std::clamp(2.0 * now.beta - 0.8 * now.yawRate, -1.0, 1.0);
    }
    void startAtPitch() { pitch_ = flight_.now().pitch; }

private:
    TestFlight& flight_;
    double integral_ = 0.0, pitch_ = 0.0, lastCas_ = 0.0, smoothAcceleration_ = 0.0;
};

/// Power off, slowing by 1 kt/s: the least calibrated airspeed, kt.
inline double stallSpeed_kt(double flaps) {
    TestFlight flight;
    flight.inAir(500.0, fromKnots(65.0));
    TestPilot pilot{flight};
    pilot.startAtPitch();
    flight.stick.throttle = 0.0;
    flight.stick.flaps = flaps;
    double least = 1e9;
    flight.fly(60.0, [&](double t) {
        pilot.holdSpeed(fromKnots(t < 10.0 ? 63.0 : 63.0 - (t - 10.0)));
        pilot.holdWings();
        if (t > 10.0) least = std::min(least, flight.now().cas);
        return flight.now().stalled < 0.5;
    });
    return knots(least);
}

struct Climb {
    double speed_kt, rate_mps, distance;
};
/// Steady path at a calibrated airspeed and a share of power from `altitude`: mean climb over 40 s and ground covered.
inline Climb steadyClimb(double altitude, double cas_kt, double power) {
    TestFlight flight;
    double const sigma = isaAir(altitude).density / 1.225;
    flight.inAir(altitude, fromKnots(cas_kt) / std::sqrt(sigma));
    TestPilot pilot{flight};
    pilot.startAtPitch();
    double start = 0.0, east = 0.0;
    double const settle = 40.0;
    flight.stick.throttle = power;
    flight.fly(settle + 40.0, [&](double t) {
        pilot.holdSpeed(fromKnots(cas_kt));
        pilot.holdWings();
        if (t <= settle) start = flight.state().positionWorld.y, east = flight.state().positionWorld.z;
        return true;
    });
    return {knots(flight.now().cas), (flight.state().positionWorld.y - start) / 40.0,
            std::abs(flight.state().positionWorld.z - east)};
}
}  // namespace luftpost::flight
