// Test cards: each flies one manoeuvre with the bare stick (assist sim) and gives its figures.
#pragma once
#include <vector>

#include "tests/sim/test_flight.h"

namespace luftpost::flight {
/// The test pilot: holds a pitch attitude, a climb or an airspeed with the elevator, the wings level, the
/// ball centred.
class TestPilot {
public:
    explicit TestPilot(TestFlight& flight);

    void holdPitch(double pitch);
    /// Calibrated airspeed in m/s, by pitch.
    void holdSpeed(double cas);
    /// m/s upward, by pitch.
    void holdClimb(double climb);
    void holdWings(double bank = 0.0);
    /// On the ground: along the line x = 0 to the north.
    void steerNorth();

private:
    TestFlight& flight_;
    double integral_ = 0.0, pitch_ = 0.0, lastCas_ = 0.0, smoothAcceleration_ = 0.0;
};

/// Power off, slowing by 1 kt/s: the least calibrated airspeed before half the wing has stalled.
double stallSpeed_kt(double flaps);

/// The steady path at a calibrated airspeed and a share of power, measured over 40 s.
struct SteadyPath {
    double climb_mps, run_m;
};
SteadyPath steadyPath(double altitude, double cas_kt, double power);
struct Best {
    double value, speed_kt;
};
Best bestGlide();  // ratio
Best bestClimb_fpm(double altitude);
double levelSpeed_kt();
double ceiling_ft();  // 100 ft/min left

struct Distances {
    double roll_ft = 0.0, over50ft_ft = 0.0, touchdown_mps = 0.0, off_m = 0.0;
    bool crashed = false;
};
Distances takeOff();
Distances landing(double windFromRight_kt);

/// A damped oscillation read from the extremes of a record about `mean`.
struct Oscillation {
    double period_s = 0.0, damping = 0.0;
};
Oscillation oscillation(std::vector<double> const& record, double step, double mean);
Oscillation phugoid();
Oscillation shortPeriod();
Oscillation dutchRoll();

struct Roll {
    double rate_dps, timeConstant_s;
};
Roll fullAileron(double kt);
/// Seconds in which a bank of 10 degrees doubles; negative: halves.
double spiralDoubling_s(double kt);
struct Pulse {
    double alpha_deg, pitchRate_dps, leftAlpha_deg, leftPitchRate_dps;
};
/// Elevator 0.1 for half a second: the peaks, and what is left 1.5 s after its end.
Pulse elevatorPulse();
/// rms of the load factor about 1 in Dryden turbulence at 100 kt and 500 ft, for a wind at 20 ft in ft/s.
double gustLoad_g(double w20_fps);
}  // namespace luftpost::flight
