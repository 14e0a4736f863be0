#include "engine/weather/cloud_pattern.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/weather/cloud_rank.h"

namespace luftpost::weather {
namespace {
struct Octave {
    double along, across;  // m, size of an element
    double weight;
    bool billow;
    bool uneven = false;  // billows of very different sizes
};

/// How a genus is laid out. Sizes of elements after the WMO Cloud Atlas: cumulus 0.5-2 km, altocumulus 1-5 degrees
/// (0.1-0.5 km overhead), stratocumulus rolls and cells over 5 degrees (1-3 km). Cumulonimbus: cells of very different strength, and
/// in each the turrets of its updraughts.
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
    /* Cb */ {3700, 740, {{{7950, 7950, 1.0, true, true}, {2700, 2700, 0.17, true, true}, {1850, 1850, 0.05, false}, {860, 860, 0.02, false}}}, false},
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
            octave.billow ? (octave.uneven ? 2.0f : 1.0f) : 0.0f};
    }
    warpCells_ = glm::ivec2{cells(plan.warpSize)};
    warpTurns_ = turns(plan.warpSize);
    warpReach_ = detail == PatternDetail::Coarse ? 0.0f : static_cast<float>(plan.warpReach / period);
}

// Octave by octave over all points: nothing in a loop over points depends on the octave's kind, so each is
// vector code.
__attribute__((always_inline)) inline void LayerPattern::row(double const* __restrict east,
                                                             double const* __restrict north,
                                                             float* __restrict out, std::size_t count) const {
    std::array<float, kBlock> x, y;
    double const axisX = lattice_.x, axisY = lattice_.y;
    for (std::size_t i = 0; i < count; ++i) {
        double const along = east[i] * axisX + north[i] * axisY;
        double const across = north[i] * axisX - east[i] * axisY;
        x[i] = static_cast<float>(wrapped(along, kPatternPeriod) / kPatternPeriod);
        y[i] = static_cast<float>(wrapped(across, kPatternPeriod) / kPatternPeriod);
        out[i] = 0.0f;
    }
    if (warpReach_ > 0.0f) {
        glm::ivec2 const cells = warpCells_;
        float const turns = warpTurns_, reach = warpReach_;
        unsigned const seed = seed_ + 5u;
        for (std::size_t i = 0; i < count; ++i) {
            glm::vec2 const warp = glsl::patternWarp(glm::vec2{x[i], y[i]}, cells, turns, reach, seed);
            x[i] += warp.x;
            y[i] += warp.y;
        }
    }
    for (int o = 0; o < octaveCount_; ++o) {
        glsl::PatternOctave octave = octaves_[static_cast<std::size_t>(o)];
        unsigned const seed = seed_ + 17u * static_cast<unsigned>(o);
        if (octave.billow > 1.5f) {
            octave.billow = 2.0f;  // a constant leaves one kind of noise in the loop
            for (std::size_t i = 0; i < count; ++i)
                out[i] += glsl::patternOctave(glm::vec2{x[i], y[i]}, octave, seed);
        } else if (octave.billow > 0.5f) {
            octave.billow = 1.0f;
            for (std::size_t i = 0; i < count; ++i)
                out[i] += glsl::patternOctave(glm::vec2{x[i], y[i]}, octave, seed);
        } else {
            octave.billow = 0.0f;
            for (std::size_t i = 0; i < count; ++i)
                out[i] += glsl::patternOctave(glm::vec2{x[i], y[i]}, octave, seed);
        }
    }
}

// Flattened: a noise that stays a call keeps its loop scalar.
__attribute__((flatten)) void LayerPattern::rowPlain(double const* east, double const* north, float* out,
                                                     std::size_t count) const {
    row(east, north, out, count);
}
#if defined(__x86_64__)
__attribute__((flatten, target("avx2"))) void LayerPattern::rowWide(double const* east, double const* north,
                                                                    float* out, std::size_t count) const {
    row(east, north, out, count);
}
#endif

float LayerPattern::value(double east, double north) const {
    float out = 0.0f;
    rowPlain(&east, &north, &out, 1);
    return out;
}

float LayerPattern::drifting(double east, double north) const {
    return rankOf(genus_, detail_ == PatternDetail::Coarse, value(east, north));
}

void LayerPattern::drifting(std::span<double const> east, std::span<double const> north,
                            std::span<float> ranks) const {
    CHECK(east.size() == north.size() && east.size() == ranks.size(), "{}, {} and {} points", east.size(),
          north.size(), ranks.size());
    for (std::size_t from = 0; from < east.size(); from += kBlock) {
        std::size_t const count = std::min(kBlock, east.size() - from);
#if defined(__x86_64__)
        static bool const wide = __builtin_cpu_supports("avx2") != 0;
        if (wide)
            rowWide(&east[from], &north[from], &ranks[from], count);
        else
#endif
            rowPlain(&east[from], &north[from], &ranks[from], count);
    }
    for (float& rank : ranks) rank = rankOf(genus_, detail_ == PatternDetail::Coarse, rank);
}

glm::vec2 LayerPattern::axis() const { return glm::normalize(glm::vec2{lattice_}); }
}  // namespace luftpost::weather
