#include "game/bot/oscillation.h"

#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::bot {
Oscillation oscillation(std::vector<double> const& record, double step, double mean) {
    std::vector<double> times, sizes;
    for (std::size_t i = 1; i + 1 < record.size() && sizes.size() < 2; ++i) {
        double const a = record[i - 1] - mean, b = record[i] - mean, c = record[i + 1] - mean;
        if ((b > 0.0 && b > a && b >= c) || (b < 0.0 && b < a && b <= c)) {
            if (!sizes.empty() && (b > 0.0) == (sizes.back() > 0.0)) continue;  // one extreme a side
            times.push_back(static_cast<double>(i) * step);
            sizes.push_back(b);
        }
    }
    if (sizes.size() < 2) return {};
    double const decrement = core::log(std::abs(sizes[0] / sizes[1]));  // over half a period
    return {2.0 * (times[1] - times[0]), decrement / std::sqrt(core::kPi * core::kPi + decrement * decrement)};
}
}  // namespace luftpost::bot
