// Frames of reference and the constants that tie them together. World frame: x east, y up, z south, metres,
// double; origin at the place's latitude and longitude at sea level. Angles are radians.
#pragma once
#include <glm/glm.hpp>

namespace luftpost::core {
inline constexpr double kEarthRadius = 6'371'000.0;  // m, mean radius, the one the contract fixes
inline constexpr double kGravity = 9.80665;          // m/s2, standard gravity (ISO 80000-3)
inline constexpr int kTicksPerSecond = 240;
inline constexpr double kTickSeconds = 1.0 / kTicksPerSecond;
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kMetresPerFoot = 0.3048;
inline constexpr double kMetresPerSecondPerKnot = 1852.0 / 3600.0;

constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double degrees(double angle) { return angle * (180.0 / kPi); }

/// A point of the Earth that the world frame is anchored to. Degrees because it crosses the border of the program.
struct Place {
    double lat_deg = 0.0;
    double lon_deg = 0.0;
    double altitude_m = 0.0;  // above sea level; raises the procedural land (`land.base_m`)
};

/// World position of a point east and north of the origin, `altitude` above sea level.
constexpr glm::dvec3 worldFromEastNorth(double east, double north, double altitude) {
    return glm::dvec3{east, altitude, -north};
}
}  // namespace luftpost::core
