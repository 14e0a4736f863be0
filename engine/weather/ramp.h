// One smooth step, used all over the air.
#pragma once
#include <algorithm>

namespace luftpost::weather {
/// 0 at and below `low`, 1 at and above `high`, smooth between: 3 u^2 - 2 u^3.
inline double smooth(double low, double high, double x) {
    double const u = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}
}  // namespace luftpost::weather
