#include "engine/weather/cloud_pattern.h"

#include <cmath>

#include "engine/weather/cloud_rank.h"

namespace luftpost::weather {
namespace {
struct Octave {
    double along, across;  // m, size of an element
    double weight;
    bool billow;
};

/// How a genus is laid out. Sizes of elements after the WMO Cloud Atlas: cumulus 0.5-2 km, altocumulus 1-5 degrees
/// (0.1-0.5 km overhead), stratocumulus rolls and cells over 5 degrees (1-3 km).
struct Plan {
    double warpSize, warpReach;  // m
    std::array<Octave, 4> octaves;
    bool turned;                 // laid along an axis of its own
};

constexpr std::array<Plan, kGenera> kPlans{{
    /* Ci */ {6000, 1300, {{{8000, 2600, 1.0, false}, {6000, 900, 0.8, false}, {3500, 380, 0.5, false}, {2400, 190, 0.3, false}}}, true},
    /* Cc */ {3000, 500, {{{6000, 4500, 1.1, false}, {1900, 1400, 0.5, false}, {420, 300, 0.7, true}, {200, 160, 0.25, false}}}, true},
    /* Cs */ {6000, 1500, {{{8000, 5200, 1.0, false}, {6000, 2400, 0.5, false}, {3000, 700, 0.22, false}, {2000, 330, 0.1, false}}}, true},
    /* Ac */ {2500, 450, {{{5500, 4200, 0.9, false}, {1700, 1200, 0.45, false}, {620, 460, 0.85, true}, {260, 220, 0.3, false}}}, true},
    /* As */ {5000, 900, {{{7500, 5000, 1.0, false}, {3400, 2000, 0.5, false}, {1500, 900, 0.25, false}, {600, 420, 0.12, false}}}, true},
    /* Ns */ {5000, 900, {{{7500, 6000, 1.0, false}, {3200, 2600, 0.5, false}, {1400, 1100, 0.28, false}, {600, 500, 0.14, false}}}, true},
    /* Sc */ {3000, 650, {{{6000, 4200, 0.75, false}, {2300, 1350, 0.9, true}, {900, 650, 0.35, false}, {380, 300, 0.18, false}}}, true},
    /* St */ {4000, 800, {{{6500, 5000, 1.0, false}, {2700, 2200, 0.5, false}, {1100, 950, 0.3, false}, {480, 420, 0.16, false}}}, true},
    /* Cu */ {1500, 420, {{{4800, 4800, 0.55, false}, {1900, 1900, 1.0, true}, {850, 850, 0.42, false}, {370, 370, 0.2, false}}}, false},
    /* Cb */ {3200, 900, {{{8000, 8000, 1.1, false}, {5200, 5200, 0.7, true}, {2400, 2400, 0.25, false}, {1200, 1200, 0.06, false}}}, false},
    /* fog */ {4000, 800, {{{6500, 5000, 1.0, false}, {2700, 2200, 0.5, false}, {1100, 950, 0.3, false}, {480, 420, 0.16, false}}}, true},
}};
constexpr double kCoarsest = 3000.0;       // m, the finest element that the coarse rank knows
constexpr double kTurnMetresPerHour = 520.0;  // an element of this size turns over once an hour, a larger one slower
constexpr double kTurnPeriod = 1275.0;         // turns: after these every gradient, at its own rate, has gone full circles

constexpr std::array<glm::ivec2, 8> kAxes{{{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}}};

double wrapped(double v, double period) { return v - period * std::floor(v / period); }
}  // namespace

LayerPattern::LayerPattern(Layer const& layer, unsigned seed, PatternDetail detail)
    : seed_{glsl::hashOf(layer.pattern + glsl::hashOf(seed))}, drift_{layer.drift}, genus_{layer.genus}, detail_{detail} {
    Plan const& plan = kPlans[static_cast<std::size_t>(layer.genus)];
    if (plan.turned) lattice_ = kAxes[glsl::hashOf(seed_) & 7u];
    // One period of the turned lattice is this many metres along its axes.
    double const period = kPatternPeriod / std::sqrt(static_cast<double>(lattice_.x * lattice_.x + lattice_.y * lattice_.y));
    auto const cells = [&](double size) { return static_cast<int>(period / size + 0.5); };
    auto const turns = [&](double size) { return static_cast<float>(wrapped(layer.phase * kTurnMetresPerHour / size, kTurnPeriod)); };
    for (Octave const& octave : plan.octaves) {
        double const size = std::sqrt(octave.along * octave.across);
        if (detail == PatternDetail::Coarse && octaveCount_ > 0 && octave.across < kCoarsest) continue;
        octaves_[static_cast<std::size_t>(octaveCount_++)] = {
            glm::ivec2{cells(octave.along), cells(octave.across)}, static_cast<float>(octave.weight), turns(size),
            octave.billow ? 1.0f : 0.0f};
    }
    warpCells_ = glm::ivec2{cells(plan.warpSize)};
    warpTurns_ = turns(plan.warpSize);
    warpReach_ = detail == PatternDetail::Coarse ? 0.0f : static_cast<float>(plan.warpReach / period);
}

float LayerPattern::value(double east, double north) const {
    double const along = east * lattice_.x + north * lattice_.y;
    double const across = north * lattice_.x - east * lattice_.y;
    glm::vec2 unit{static_cast<float>(wrapped(along, kPatternPeriod) / kPatternPeriod),
                   static_cast<float>(wrapped(across, kPatternPeriod) / kPatternPeriod)};
    if (warpReach_ > 0.0f) unit += glsl::patternWarp(unit, warpCells_, warpTurns_, warpReach_, seed_ + 5u);
    float sum = 0.0f;
    for (int i = 0; i < octaveCount_; ++i)
        sum += glsl::patternOctave(unit, octaves_[static_cast<std::size_t>(i)], seed_ + 17u * static_cast<unsigned>(i));
    return sum;
}

float LayerPattern::drifting(double east, double north) const {
    return rankOf(genus_, detail_ == PatternDetail::Coarse, value(east, north));
}

glm::vec2 LayerPattern::axis() const { return glm::normalize(glm::vec2{lattice_}); }
}  // namespace luftpost::weather
