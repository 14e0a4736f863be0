#include "engine/weather/convection.h"

#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/inside.h"
#include "engine/weather/stirring.h"

namespace luftpost::weather {
namespace {
constexpr double kEdge = 0.2;           // rank, from the outline of a cumulus to full lift
constexpr double kDryShare = 0.15;      // of the land under thermals without cloud: 0.1 to 0.2 (Lenschow and Stephens 1980)
constexpr double kPeak = 2.0;           // of a thermal's middle over its mean
constexpr double kLatent = 0.25;        // of a noon's strength: what a cloud lifts by its own warmth
constexpr double kCoreShare = 0.3;      // of the plane under a storm's cores where all of it is storm
constexpr double kWeakCores = 6.0, kStrongCores = 16.0;  // m/s, at no CAPE and at 2500 J/kg

double cubeRoot(double x) { return x > 0.0 ? core::pow(x, 1.0 / 3.0) : 0.0; }

/// Share of the speed that a thermal under a cloud has: most in the middle of its way, 0.84 at the base, none at the cloud's top.
double cloudThermal(UnderCloud const& at) {
    double const depth = std::max(at.base - at.ground, 100.0);
    if (at.altitude <= at.base) {
        double const r = std::clamp((at.altitude - at.ground) / depth, 0.0, 1.0);
        return cubeRoot(r) * (1.0 - 0.5 * r) / 0.595;
    }
    double const q = (at.altitude - at.base) / std::max(at.top - at.base, 50.0);
    return q < 1.0 ? (0.84 + 0.6 * q) * (1.0 - q) : 0.0;
}

/// 0 outside the cloud's heights, 1 well inside.
double within(UnderCloud const& at) {
    double const margin = std::min(150.0, 0.3 * (at.top - at.base));
    return smooth(0.0, margin, at.altitude - at.base) * smooth(0.0, margin, at.top - at.altitude);
}
}  // namespace

double riseSpeed(double thickness) { return 3.0 + std::min(thickness, 2500.0) / 900.0; }

glm::dvec2 thermalLean(glm::dvec2 windSurface, glm::dvec2 windCloud, double below, double depth, double speed) {
    double const share = std::min(below / std::max(depth, 1.0), 1.0), ground = 0.25 * share * share;
    return (ground * windSurface + (1.0 - ground) * windCloud) * (below / speed);
}

Convection cumulusConvection(UnderCloud const& at) {
    Inside const inside = insideOf(at.rank, at.threshold, std::min(kEdge, at.threshold));
    double const latent = kLatent * (1.0 - at.heating) * smooth(at.base - 100.0, at.base + 200.0, at.altitude);
    double const speed = (1.2 + std::min(at.top - at.base, 2500.0) / 900.0) * (at.heating + latent);
    Convection result;
    result.lift = speed * (inside.here - inside.mean) * cloudThermal(at);
    result.sigma = inside.here * (0.25 * speed * cloudThermal(at) + 0.7 * within(at));
    return result;
}

Convection dryConvection(double rank, double height, double depth, double heating, double strength) {
    double const r = height / depth;
    if (r <= 0.0 || r >= 1.0 / 1.1) return {};
    Inside const inside = insideOf(rank, kDryShare, kDryShare);
    double const speed = kPeak * strength * convectiveSpeed(heating, depth) * cubeRoot(r) * (1.0 - 1.1 * r);
    return {speed * (inside.here - inside.mean), 0.25 * speed * inside.here};
}

Convection stormUpdraught(UnderCloud const& at, double cape) {
    double const threshold = std::min(at.threshold, kCoreShare);
    Inside const inside = insideOf(at.rank, threshold, threshold);
    double const depth = std::max(at.base - at.ground, 100.0), thickness = std::max(at.top - at.base, 50.0);
    double const speed = kWeakCores + (kStrongCores - kWeakCores) * smooth(0.0, 2500.0, cape);
    // It draws in from half the way to the ground and is strongest in the middle of the cloud.
    double const shape = smooth(at.base - 0.5 * depth, at.base + 0.3 * thickness, at.altitude) *
                         (1.0 - smooth(at.top - 0.4 * thickness, at.top, at.altitude));
    return {speed * (inside.here - inside.mean) * shape, inside.here * 4.0 * within(at)};
}
}  // namespace luftpost::weather
