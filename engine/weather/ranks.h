// The ranks of the layers' patterns as the air asks for them: remembered at the nodes of lattices that drift with their layers, at
// whole minutes; linear between nodes and minutes, so that nothing jumps. Any thread; the same bits whoever asks first.
#pragma once
#include <vector>

#include "engine/weather/cloud_pattern.h"
#include "engine/weather/point_memo.h"

namespace luftpost::weather {
/// A hill over the plane, made of ranks: value, slope (per m, east and north) and the sum of its second derivatives (per m2).
struct RankHill {
    double value = 0.0;
    glm::dvec2 slope{0.0};
    double laplacian = 0.0;
};

/// The nodes of a RankHill stand this far apart, m (times the scale of the patterns).
inline constexpr double kHillStep = 768.0;

class Ranks {
public:
    Ranks(std::vector<unsigned> const& patterns, unsigned seed);

    /// The rank over a point, m east and north. `scale`: CloudSettings::weatherScale. The layer's pattern must be one of the constructor's.
    double at(Layer const& layer, double scale, double east, double north) const;

    /// The hill that stands 1 where the rank is 0 and falls to 0 where it reaches `foot`, seen over about a kilometre: a cubic spline,
    /// so that its second derivatives have kinks but no steps. They sum to nothing over the plane.
    RankHill hill(Layer const& layer, double scale, double foot, double east, double north) const;

private:
    struct Asked;
    Asked asked(Layer const& layer, double scale, double east, double north) const;
    std::vector<std::pair<unsigned, PointMemo>> memos_;  // by pattern
    unsigned seed_;
};
}  // namespace luftpost::weather
