// The downburst of a cumulonimbus: air that its rain drags down, spreads over the ground and lifts what it meets. Pure.
#pragma once
#include "engine/weather/ranks.h"

namespace luftpost::weather {
struct Outflow {
    glm::dvec2 wind{0.0};   // m/s, east and north
    double lift = 0.0;      // m/s, up; negative in the shaft, positive before the gust front
    double variance = 0.0;  // m2/s2
};

/// Where a storm stands over the point.
struct StormHeights {
    double height = 0.0;  // of the point above ground, m
    double base = 0.0;    // of the cloud above ground, m
};

/// Rank below which a storm's downburst stands, for the storm's threshold: well inside its rain.
double burstFoot(double threshold);

/// `hill`: of the storm's pattern with the foot of burstFoot. `strength` 0..1.
///
/// With height the flow is Oseguera and Bowles' (1988, NASA TM-100632): outward as exp(-z/z*) - exp(-z/e), e = 0.08 z*, most at
/// 80 m above ground, and down as the integral of that. Their downburst is one round Gaussian; ours are as the storm's pattern has
/// them: the wind is -K grad(B), B the hill of the pattern's ranks, so that it blows out of the rain in all directions, and the lift is
/// K times B's Laplacian, so that no air comes from nowhere: down in the middle, up in a ring about it. Above half the cloud's base the
/// downdraught fades, fed by an inflow. At most 25 m/s outward and 15 m/s down.
Outflow downburst(RankHill const& hill, StormHeights const& at, double strength);

/// Above this height over the ground a downburst of a storm with this base (m above ground) is not felt.
double burstTop(double base);
}  // namespace luftpost::weather
