// The hands of a test pilot: each hold turns what the instruments show into a stick. Called every tick; the input layer
// takes the stick 20 times a second. Only core/math: the flight of a bot has the same bits on every machine.
#pragma once
#include "engine/flight/aircraft_state.h"

namespace luftpost::bot {
class TestPilot {
public:
    flight::Controls stick;
    /// rad of angle of attack beyond which the stick goes forward, whatever is held; as it is, one may stall.
    double mostAlpha = 1.0;

    /// What the instruments show now; before any hold of a tick.
    void look(flight::AircraftState const& state);
    flight::AircraftState const& state() const { return *state_; }
    flight::Readings const& now() const { return state_->readings; }

    /// Forgets what the holds have learnt; the pitch of now is where they begin.
    void takeOver();
    void holdPitch(double pitch);
    /// Calibrated airspeed in m/s, by pitch.
    void holdSpeed(double cas);
    /// Calibrated airspeed in m/s, by power.
    void holdSpeedByPower(double cas);
    /// m/s upward, by pitch.
    void holdClimb(double climb);
    /// rad, the path's angle through still air: the pitch that it needs at the angle of attack of the moment.
    void holdPath(double angle);
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
    flight::AircraftState const* state_ = nullptr;
    double integral_ = 0.0, pitch_ = 0.0, power_ = 0.5, lastCas_ = 0.0, smoothAcceleration_ = 0.0;
    double alpha_ = 0.0;  // rad, smoothed: pitch less path
};

/// `to` less `from`, -pi..pi.
double turnBetween(double from, double to);
double knots(double metresPerSecond);
double fromKnots(double kt);
}  // namespace luftpost::bot
