// Gusts after Dryden (MIL-F-8785C) as a function of place and time: smooth noise of six sizes that the wind carries along, its
// share per size taken from Dryden's spectrum. The same bits for the same point; no state.
#pragma once
#include <glm/glm.hpp>

namespace luftpost::weather {
/// Rms and length of the gusts at a height: along and across the wind (u, v) alike, and vertical (w).
struct Gustiness {
    double sigmaHorizontal = 0.0, sigmaVertical = 0.0;    // m/s
    double lengthHorizontal = 533.4, lengthVertical = 533.4;  // m
};

/// How much the air keeps of the specification's turbulence, which is that of a neutral one.
struct AirStability {
    double mixing = 1.0;  // 0..1, of the rms above 2000 ft: where neither sun nor wind stirs the air, the ground's gusts do not reach up there
    double stable = 0.0;  // 0..1: a clear, windless night, in which they die away within some hundred metres
};

/// Below 1000 ft: Lw = h, Lu = h/(0.177 + 0.000823 h)^1.2, sigma_w = 0.1 W20, sigma_u = sigma_w/(0.177 + 0.000823 h)^0.4, h in feet;
/// linear to 2000 ft; above, L = 1750 ft and the round severities (5, 10, 20 ft/s at 15, 30, 45 kt), fading over 2 km.
/// `windGround`: W20, m/s, the wind 20 ft above ground. `height` above ground, m.
Gustiness drydenGustiness(double windGround, double height, AirStability stability = {});

/// The gust at a point of the frame that drifts with the boundary layer (m east, up, north). Mean 0, rms as asked.
glm::dvec3 gustAt(glm::dvec3 const& point, Gustiness const& gustiness, unsigned seed);
}  // namespace luftpost::weather
