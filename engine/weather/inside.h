// How far inside the outline of a cloud one is, when all that is known is the rank of the layer's pattern. Pure.
#pragma once
#include "engine/weather/ramp.h"

namespace luftpost::weather {
/// 0 outside the outline, growing to 1 over `edge` of rank inside it; and the mean of that over the plane, exact because ranks are
/// uniform. A `threshold` beyond 1 (a closed layer) leaves nothing outside.
struct Inside {
    double here = 0.0, mean = 0.0;
};

inline Inside insideOf(double rank, double threshold, double edge) {
    if (!(threshold > 0.0) || !(edge > 0.0)) return {};
    // The integral of smooth(0, edge, x) from 0.
    auto const integral = [edge](double x) {
        double const u = std::clamp(x / edge, 0.0, 1.0);
        return edge * u * u * u * (1.0 - 0.5 * u) + std::max(x - edge, 0.0);
    };
    return {smooth(0.0, edge, threshold - rank), integral(threshold) - integral(threshold - 1.0)};
}
}  // namespace luftpost::weather
