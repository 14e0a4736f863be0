#include "engine/weather/outflow.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/ramp.h"

namespace luftpost::weather {
namespace {
constexpr double kMostAt = 80.0;                    // m above ground: the strongest outflow
constexpr double kOutflow = kMostAt / 0.22;         // z*, m
constexpr double kFriction = kMostAt / 2.75;        // e, m
constexpr double kPeak = 0.7386;                    // of exp(-z/z*) - exp(-z/e), at 80 m
constexpr double kSpread = 30000.0;                 // K, m2/s
constexpr double kStrongest = 25.0, kDown = 15.0;   // m/s
constexpr double kFade = 2500.0;                    // m above the base: where the downdraught begins
constexpr double kGusty = 0.15;                     // of the outflow, rms

/// Goes over from x to +-bound without a kink.
double bounded(double x, double bound) { return x / std::sqrt(1.0 + x * x / (bound * bound)); }
}  // namespace

double burstFoot(double threshold) { return std::clamp(threshold, 0.0, 0.5); }
double burstTop(double base) { return base + kFade; }

Outflow downburst(RankHill const& hill, StormHeights const& at, double strength) {
    Outflow result;
    double const from = 0.5 * at.base, to = burstTop(at.base);
    if (at.height >= to || !(strength > 0.0)) return result;
    double const z = std::max(at.height, 0.0);
    double const slow = core::exp(-z / kOutflow), fast = core::exp(-z / kFriction);
    double const outward = (slow - fast) / kPeak;
    double const integral = (kOutflow * (1.0 - slow) - kFriction * (1.0 - fast)) / kPeak;
    double const u = std::clamp((z - from) / (to - from), 0.0, 1.0);
    double const left = 1.0 - u * u * (3.0 - 2.0 * u), leaving = 6.0 * u * (1.0 - u) / (to - from);
    double const k = kSpread * strength;
    glm::dvec2 const wind = hill.slope * (-k * (outward * left - integral * leaving));
    double const speed = glm::length(wind);
    result.wind = wind / std::sqrt(1.0 + speed * speed / (kStrongest * kStrongest));
    result.lift = bounded(k * hill.laplacian * integral * left, kDown);
    double const gusty = kGusty * (std::min(speed, kStrongest) + std::abs(result.lift));
    result.variance = gusty * gusty;
    return result;
}
}  // namespace luftpost::weather
