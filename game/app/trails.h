// What the aircraft leaves in the air: dust and spray behind its wheels, the smoke of a touch, vapour off the wing tips. For
// pictures only: it follows the flight and changes nothing in it.
#pragma once
#include <vector>

#include "engine/core/environment.h"
#include "engine/flight/aircraft.h"
#include "engine/render/snapshot.h"

namespace luftpost::app {
/// What one frame knows of the aircraft's surroundings.
struct TrailScene {
    flight::Airframe const& airframe;
    flight::AircraftState const& state;
    flight::AircraftPose pose;    // as this frame shows it
    core::AirSample air;          // at the aircraft
    core::GroundFunction ground;
    double spread = 5.0;          // K, of temperature over dew point at the aircraft
};

class Trails {
public:
    /// Moves on by so many seconds of flight; 0 while paused.
    void advance(TrailScene const& scene, double seconds);
    void clear() { puffs_.clear(); }
    void addTo(std::vector<render::Puff>& puffs) const;

private:
    struct Drift {
        glm::dvec3 positionWorld{0.0}, velocityWorld{0.0};
        double age = 0.0, life = 1.0;       // s
        double radius = 0.3, growth = 1.0;  // m, m/s
        glm::vec4 colour{1.0f};
    };
    void followWheels(TrailScene const& scene, double seconds);
    void followTips(TrailScene const& scene, double seconds);
    /// How many of so many a second fall into this frame.
    int due(double& owed, double rate, double seconds);

    std::vector<Drift> puffs_;
    std::array<double, flight::kMaxWheels> owedByWheel_{};
    double owedByTips_ = 0.0;
    long long touchdownTick_ = -1;
    unsigned made_ = 0;
};
}  // namespace luftpost::app
