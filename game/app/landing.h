// How a landing went: watched tick by tick, told when the aircraft has come to rest or is off again. Changes nothing in the flight.
#pragma once
#include <optional>

#include "engine/flight/aircraft_state.h"
#include "engine/terrain/land.h"

namespace luftpost::app {
/// Distances from the aim: a point on the centre line, so far beyond the threshold that one lands over.
struct FromAim {
    double beyond = 0.0;   // m along the landing's direction, - before it
    double offLine = 0.0;  // m to the right of the centre line
};
inline constexpr double kAimBeyondThreshold = 100.0;  // m

struct Landing {
    double t = 0.0;               // s of flight, of the first touch
    double endT = 0.0;            // s, when it was over
    glm::dvec3 placeWorld{0.0};   // of the first touch
    double touchdownSpeed = 0.0;  // m/s across the ground
    double speed = 0.0;           // m/s calibrated
    double loadFactor = 1.0;      // the highest within a second after the touch
    double drift = 0.0;           // m/s over the ground to the right of the nose's heading
    double bank = 0.0, pitch = 0.0;  // rad
    int bounces = 0;
    bool touchAndGo = false;
    std::optional<FromAim> aim;   // none away from the airfield
};

class LandingWatch {
public:
    /// After each tick of a flight that goes on. A landing when one is over with this tick.
    std::optional<Landing> step(flight::AircraftState const& now, terrain::Runway const& runway, double seconds);
    /// A respawn or crash: what went on does not count.
    void forget() { *this = {}; }

private:
    void touch(flight::AircraftState const& now, terrain::Runway const& runway, double seconds);

    std::optional<Landing> running_;
    double airborne_ = 0.0;  // s since a wheel touched
};

/// Where a touch at that place with that heading lies; none where the runway is too far.
std::optional<FromAim> distanceFromAim(terrain::Runway const& runway, glm::dvec3 const& placeWorld, double heading);
}  // namespace luftpost::app
