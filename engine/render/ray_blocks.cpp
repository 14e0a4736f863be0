#include "engine/render/ray_blocks.h"

#include <algorithm>

namespace luftpost::render {
namespace {
constexpr double kOldest = 0.5;          // s
constexpr double kMemory = 8.0;          // frames
constexpr double kAhead = 0.9;           // share of the limit under which blocks grow again

/// Frames until a block's first ray is marched again, less one: what its oldest ray has seen go by.
int framesOf(int side) { return side * side - 1; }
}  // namespace

void RayBlocks::note(double frameSeconds, double weatherSeconds) {
    double const taken = std::max(frameSeconds / kOldest, weatherSeconds / kOldestWeatherSeconds);
    if (taken <= 0.0) return;
    mean_ = mean_ > 0.0 ? mean_ + (taken - mean_) / kMemory : taken;
    constexpr double kExact = 1.0 + 1e-9;
    while (side_ > 1 && mean_ * framesOf(side_) > kExact) side_ /= 2;
    while (side_ < 4 && mean_ * framesOf(2 * side_) <= kAhead) side_ *= 2;
}

int RayBlocks::side(int widest) const { return std::min(side_, widest); }

int blockSide(float share) { return share > 0.5f ? 1 : share > 0.125f ? 2 : 4; }
}  // namespace luftpost::render
