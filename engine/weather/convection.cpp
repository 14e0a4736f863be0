#include "engine/weather/convection.h"

#include <algorithm>

namespace luftpost::weather {
namespace {
constexpr double kEdge = 0.2;  // rank, from the outline to full lift

double smooth(double low, double high, double x) {
    double const u = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

/// How far inside the outline, 0..1, and its mean over the plane.
struct Inside {
    double here, mean;
};
Inside insideOf(UnderCloud const& at) {
    double const threshold = std::clamp(at.threshold, 0.0, 1.0);
    double const edge = std::min(kEdge, threshold);
    if (edge <= 0.0) return {0.0, 0.0};
    return {smooth(0.0, edge, threshold - at.rank), threshold - 0.5 * edge};
}

/// A thermal gathers speed in the lowest third, slows toward the base, and ends at the cloud's top.
double thermalShape(UnderCloud const& at) {
    double const depth = std::max(at.base - at.ground, 100.0);
    if (at.altitude <= at.base) {
        double const r = std::max(at.altitude - at.ground, 0.0) / depth;
        return smooth(0.0, 0.4, r) * (1.0 - 0.35 * smooth(0.5, 1.0, r));
    }
    double const q = (at.altitude - at.base) / std::max(at.top - at.base, 50.0);
    return q < 1.0 ? (0.65 + q) * (1.0 - q) : 0.0;
}

/// 0 outside the cloud's heights, 1 well inside.
double within(UnderCloud const& at) {
    double const margin = std::min(150.0, 0.3 * (at.top - at.base));
    return smooth(0.0, margin, at.altitude - at.base) * smooth(0.0, margin, at.top - at.altitude);
}
}  // namespace

Convection cumulusConvection(UnderCloud const& at) {
    Inside const inside = insideOf(at);
    double const speed = (0.8 + std::min(at.top - at.base, 2500.0) / 1200.0) * (0.2 + 0.8 * at.heating);
    Convection result;
    result.lift = speed * (inside.here - inside.mean) * thermalShape(at);
    result.sigma = inside.here * (0.25 * speed * thermalShape(at) + 0.7 * within(at));
    return result;
}

Convection stormConvection(UnderCloud const& at) {
    Inside const inside = insideOf(at);
    double const wet = std::min(at.rain / 20.0, 1.0);
    double const height = std::max(at.altitude - at.ground, 0.0), depth = std::max(at.base - at.ground, 100.0);
    // The shaft is fastest at two thirds of the way down and has spread out at the ground.
    double const shaft = smooth(0.0, 0.35 * depth, height) * (1.0 - 0.7 * smooth(0.5 * depth, depth + 300.0, height));
    double const below = 1.0 - smooth(at.base - 100.0, at.base + 300.0, at.altitude);
    Convection result;
    result.lift = inside.here * ((1.5 * (1.0 - wet) - 5.0 * wet) * shaft * below + 9.0 * within(at) * (1.0 - below));
    result.sigma = inside.here * (4.0 * within(at) + 1.2 * wet * below * smooth(0.0, 100.0, height));
    return result;
}
}  // namespace luftpost::weather
