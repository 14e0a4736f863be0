// The hands of a test pilot: each hold turns what the instruments show into a stick. Called every tick; the input layer
// takes the stick 20 times a second. Only core/math: the flight of a bot has the same bits on every machine.
#pragma once
#include <algorithm>

#include "engine/flight/aircraft_state.h"

namespace luftpost::bot {
class TestPilot {
public:
    flight::Controls stick;
    /// rad of angle of attack beyond which the stick goes forward, whatever is held; as it is, one may stall.
    double mostAlpha = 1.0;
    /// What the stick asks for: with sim and light the surfaces; with normal rates, with easy a bank and a climb. There holds of
    /// pitch become holds of the path, and the rudder is left to the assist but where the nose has to point.
    flight::AssistLevel assist = flight::AssistLevel::sim;

    /// What the instruments show now; before any hold of a tick.
    void look(flight::AircraftState const& state);
    flight::AircraftState const& state() const { return *state_; }
    flight::Readings const& now() const { return state_->readings; }

    /// Forgets what the holds have learnt; the pitch of now is where they begin.
    void takeOver();
    void holdPitch(double pitch);
    /// Calibrated airspeed in m/s, by pitch.
    void holdSpeed(double cas);
    /// Calibrated airspeed in m/s, by power: `gain` of the lever per m/s that is missing.
    void holdSpeedByPower(double cas, double gain = 0.06);
    /// m/s upward, by pitch.
    void holdClimb(double climb);
    /// rad, the path's angle through still air: the pitch that it needs at the angle of attack of the moment.
    void holdPath(double angle);
    /// m/s upward close to the ground: by the lift that it takes at the airspeed of the moment, so that a lull is met as it comes.
    void holdSink(double climb);
    /// m above sea level, by pitch, with at most so many m/s up or down.
    void holdAltitude(double altitude, double most = 4.0);
    void holdWings(double bank = 0.0);
    /// rad clockwise from north, by bank.
    void holdHeading(double heading);
    /// rad clockwise from north, of the way over the ground, by bank.
    void holdTrack(double course);
    /// On the ground, along a line: `across` m to its right, `heading` rad.
    void steerAlong(double heading, double across);
    /// Wing low: the bank keeps the line in so many m/s of wind from the right, the rudder the heading.
    void slipAlong(double heading, double across, double drift, double wind);

private:
    bool moveSurfaces() const { return assist == flight::AssistLevel::sim || assist == flight::AssistLevel::light; }
    /// rad, the stick that takes the path there with assist normal and easy.
    void pointPath(double angle);
    /// -1..1, the stick that takes the wings to a bank of so many rad.
    double rollTo(double bank) const;
    flight::AircraftState const* state_ = nullptr;
    double integral_ = 0.0, pitch_ = 0.0, power_ = 0.5, lastCas_ = 0.0, smoothAcceleration_ = 0.0;
    /// Proportional to the dynamic pressure, (m/s)^2.
    double pressure() const { return std::max(now().cas * now().cas, 225.0); }

    double alpha_ = 0.0;  // rad, smoothed: pitch less path
    double bite_ = 0.0;   // load factor per rad of angle of attack and (m/s)^2 of dynamic pressure, smoothed
};

/// `to` less `from`, -pi..pi.
double turnBetween(double from, double to);
double knots(double metresPerSecond);
double fromKnots(double kt);
}  // namespace luftpost::bot
