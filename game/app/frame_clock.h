// How many ticks a frame simulates.
#pragma once
#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::app {
struct FrameStep {
    long long ticks = 0;
    double share = 1.0;    // how far the picture lies between the last two ticks
    double seconds = 0.0;  // of simulated time
    double wall = 0.0;     // of the player's time
};

/// A window's clock: at most 0.25 s of the player's time a frame, then the flight slows down.
class FrameClock {
public:
    static constexpr double kLongestFrame = 0.25;  // s

    /// `pace`: seconds of flight to one of the player's.
    FrameStep step(double wallSeconds, bool paused, double pace = 1.0) {
        if (paused) return {0, debt_, 0.0, wallSeconds};
        double const seconds = pace * std::clamp(wallSeconds, 0.0, kLongestFrame);
        debt_ += seconds * core::kTicksPerSecond;
        auto const ticks = static_cast<long long>(debt_);
        debt_ -= static_cast<double>(ticks);
        return {ticks, debt_, seconds, wallSeconds};
    }

private:
    double debt_ = 0.0;  // ticks, below 1
};

/// The frames of a simulated clock: frame `number` (from 1) shows the flight at number / frameRate seconds.
inline FrameStep simulatedStep(long long number, double frameRate) {
    double const perFrame = core::kTicksPerSecond / frameRate;
    double const before = std::floor(static_cast<double>(number - 1) * perFrame);
    double const now = static_cast<double>(number) * perFrame;
    return {static_cast<long long>(std::floor(now) - before), now - std::floor(now), 1.0 / frameRate,
            1.0 / frameRate};
}
}  // namespace luftpost::app
