// What one floor hands another: the air and the ground as functions, so that flight, weather and terrain need not
// know each other. Both are pure and may be called from any thread.
#pragma once
#include <functional>

#include <glm/glm.hpp>

namespace luftpost::core {
/// Seconds since 1970-01-01T00:00Z, leap seconds not counted.
using UtcSeconds = double;

/// The air at one point: the answer of `air(position, time)`.
struct AirSample {
    glm::dvec3 windWorld{0.0};    // m/s, where the air goes to, gusts, turbulence, lift and sink included
    double turbulence = 0.0;      // m/s, rms of the vertical gust component
    double density = 1.225;       // kg/m3
    double temperature = 288.15;  // K
    double pressure = 101325.0;   // Pa
    double visibility = 1.0e5;    // m, meteorological optical range (5 % contrast)
    double icing = 0.0;           // kg/m3, supercooled liquid water
    double rain = 0.0;            // mm/h that fall through this point, of water; freezing rain too
    double snow = 0.0;            // mm/h of water; sleet counts half here, half as rain
    double hail = 0.0;            // mm/h of water
};
using AirFunction = std::function<AirSample(glm::dvec3 const& positionWorld, UtcSeconds time)>;

enum class Surface { grass, rock, snow, sand, runway, water };

/// The ground under one point: the same height function that the chunks draw.
struct GroundSample {
    double height = 0.0;                   // m above sea level; of the water's face where there is water
    glm::dvec3 normalWorld{0.0, 1.0, 0.0};  // unit
    Surface surface = Surface::grass;
};
using GroundFunction = std::function<GroundSample(double east, double north)>;
}  // namespace luftpost::core
