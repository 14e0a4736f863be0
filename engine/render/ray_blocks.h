// How many of the clouds' rays are marched a frame, by how long frames take.
#pragma once

namespace luftpost::render {
/// Nothing that was seen longer ago by the weather's clock is kept, s: a cloud's outline, at 5 km, moves by less than a pixel
/// of a coarse picture beyond its drift.
inline constexpr double kOldestWeatherSeconds = 20.0;

/// One pixel of each block is marched a frame, the others in turn. Blocks are 4, 2 or 1 pixels wide: the widest of which no ray
/// gets older than half a second of the player's time or twenty of the weather's clock, which may run faster.
class RayBlocks {
public:
    /// Takes what the latest frame took, s of either clock; 0 (a flight that stands still) says nothing.
    void note(double frameSeconds, double weatherSeconds);
    /// Side of the block, pixels; never more than `widest`.
    int side(int widest) const;

private:
    double mean_ = 0.0;  // of how much of the longest age a frame takes, over the last frames
    int side_ = 4;
};

/// Side of the blocks of which a share of the rays is one: 4, 2 or 1 pixels. At least so many rays are marched.
int blockSide(float share);
}  // namespace luftpost::render
