#include "engine/weather/ranks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/check.h"
#include "engine/weather/ramp.h"

namespace luftpost::weather {
namespace {
constexpr double kStep = 32.0;         // m, lattice of the ranks
constexpr double kSlotsPerHour = 60.0;  // a pattern's slow change is followed minute by minute
constexpr int kHillNodes = 24;         // steps of the lattice from one node of a hill to the next
static_assert(kHillNodes * kStep == kHillStep);

/// Weights of the four nodes about a point `u` 0..1 beyond the second: the cubic B-spline and its derivatives.
struct Cubic {
    std::array<double, 4> value, slope, bend;
    explicit Cubic(double u) {
        double const v = 1.0 - u;
        value = {v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0, (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0, u * u * u / 6.0};
        slope = {-0.5 * v * v, 1.5 * u * u - 2.0 * u, 2.0 * v - 1.5 * v * v, 0.5 * u * u};
        bend = {v, 3.0 * u - 2.0, 3.0 * v - 2.0, u};
    }
};
}  // namespace

/// One question: where in the lattice, and between which minutes.
struct Ranks::Asked {
    Layer const& layer;
    PointMemo const& memo;
    unsigned seed;
    double x, y;      // steps
    std::int64_t slot;
    double later;     // 0..1 toward the next slot

    double node(std::int64_t i, std::int64_t j, std::int64_t when) const {
        return memo.at(PointMemo::key(i, j, when), [&] {
            Layer then = layer;
            then.phase = static_cast<double>(when) / kSlotsPerHour;
            return static_cast<double>(LayerPattern{then, seed}.drifting(static_cast<double>(i) * kStep, static_cast<double>(j) * kStep));
        });
    }
    double node(std::int64_t i, std::int64_t j) const {
        double const first = node(i, j, slot);
        return first + (node(i, j, slot + 1) - first) * later;
    }
};

Ranks::Ranks(std::vector<unsigned> const& patterns, unsigned seed) : seed_{seed} {
    for (unsigned const pattern : patterns) memos_.emplace_back(pattern, PointMemo{0.0, 1.0});
}

Ranks::Asked Ranks::asked(Layer const& layer, double scale, double east, double north) const {
    auto const memo = std::find_if(memos_.begin(), memos_.end(), [&](auto const& entry) { return entry.first == layer.pattern; });
    CHECK(memo != memos_.end(), "pattern {} is none of the field's", layer.pattern);
    double const slots = layer.phase * kSlotsPerHour, slot = std::floor(slots);
    return {layer, memo->second, seed_, (east - layer.drift.x) / (scale * kStep), (north - layer.drift.y) / (scale * kStep),
            static_cast<std::int64_t>(slot), slots - slot};
}

double Ranks::at(Layer const& layer, double scale, double east, double north) const {
    Asked const a = asked(layer, scale, east, north);
    double const x = std::floor(a.x), y = std::floor(a.y), u = a.x - x, v = a.y - y;
    auto const i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
    double const south = a.node(i, j) * (1.0 - u) + a.node(i + 1, j) * u;
    return south * (1.0 - v) + (a.node(i, j + 1) * (1.0 - u) + a.node(i + 1, j + 1) * u) * v;
}

RankHill Ranks::hill(Layer const& layer, double scale, double foot, double east, double north) const {
    RankHill sum;
    if (!(foot > 0.0)) return sum;
    Asked const a = asked(layer, scale, east, north);
    double const x = std::floor(a.x / kHillNodes), y = std::floor(a.y / kHillNodes), perMetre = 1.0 / (kHillStep * scale);
    Cubic const u{a.x / kHillNodes - x}, v{a.y / kHillNodes - y};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i) {
            auto const column = static_cast<std::int64_t>(x) + static_cast<std::int64_t>(i) - 1;
            auto const row = static_cast<std::int64_t>(y) + static_cast<std::int64_t>(j) - 1;
            double const h = 1.0 - smooth(0.0, foot, a.node(column * kHillNodes, row * kHillNodes));
            sum.value += u.value[i] * v.value[j] * h;
            sum.slope += glm::dvec2{u.slope[i] * v.value[j], u.value[i] * v.slope[j]} * (h * perMetre);
            sum.laplacian += (u.bend[i] * v.value[j] + u.value[i] * v.bend[j]) * h * perMetre * perMetre;
        }
    return sum;
}
}  // namespace luftpost::weather
