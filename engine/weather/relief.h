// The land as the wind feels it: heights at nodes, and means over a few hundred metres to some kilometres with their slopes.
// What the ground function said is remembered. Any thread; the same bits whoever asks first.
#pragma once
#include <array>

#include "engine/core/environment.h"
#include "engine/weather/point_memo.h"

namespace luftpost::weather {
/// One scale of the relief at a point: how much higher the land is for what is of this size (m), and the slope of it (east, north).
struct ReliefBand {
    double height = 0.0;
    glm::dvec2 slope{0.0};
};

/// By size: what a mean over 400 m keeps and one over 800 m does not, then 800 m to 1.6 km, 1.6 to 3 km, and all that is larger
/// (its height is left 0: nothing says what it stands above). The slopes sum to that of the mean over 400 m.
inline constexpr int kReliefBands = 4;
using ReliefBands = std::array<ReliefBand, kReliefBands>;

class Relief {
public:
    explicit Relief(core::GroundFunction ground);

    /// Height at a point: heights of nodes 64 m apart, bilinear between them, so that the wind does not feel a single boulder.
    double height(double east, double north) const;

    /// The four sizes: quadratic splines through means at nodes, so that slopes have kinks but no steps. The first question near a
    /// place asks some thousand heights, each further kilometre a few hundred.
    /// Sizes below `finest` are left 0.
    ReliefBands bands(double east, double north, int finest = 0) const;

    /// How well the sun heats the air over the ground, 0..1: grass and rock 1, snow and water much less.
    double warmth(double east, double north) const;

private:
    struct Patch;
    double node(std::int64_t x, std::int64_t y) const;
    Patch const& patch(int level, std::int64_t x, std::int64_t y) const;
    double mean(int level, std::int64_t x, std::int64_t y) const;
    double warmthNode(std::int64_t x, std::int64_t y) const;
    ReliefBand spline(int level, double east, double north) const;

    std::uint64_t id_;
    core::GroundFunction ground_;
    PointMemo heights_, warmths_;
    std::array<PointMemo, kReliefBands> means_;
};
}  // namespace luftpost::weather
