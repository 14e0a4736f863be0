#include "engine/weather/relief.h"

#include <atomic>
#include <cmath>

namespace luftpost::weather {
namespace {
constexpr double kNode = 64.0;                     // m, lattice of heights
constexpr double kMean = 256.0;                    // m, lattice of the finest means; each further one is twice as wide
constexpr double kLowest = -1000.0, kHighest = 15000.0;  // m, of any land
constexpr double kWarmStep = 512.0;                // m, lattice of the ground's warmth
constexpr double kWater = 0.25, kSnow = 0.2;       // of the heat that grass gives the air

/// Never given twice, so that what a thread remembers of one relief is never taken for another's.
std::uint64_t nextId() {
    static std::atomic<std::uint64_t> latest{0};
    return ++latest;
}

PointMemo heightMemo() { return PointMemo{kLowest, kHighest}; }

double warmthOf(core::Surface surface) {
    if (surface == core::Surface::water) return kWater;
    return surface == core::Surface::snow ? kSnow : 1.0;
}

/// Weights of three nodes about the nearest one, `t` -0.5..0.5 from it, and their derivatives.
struct Weights {
    std::array<double, 3> value, slope;
    explicit Weights(double t)
        : value{0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)}, slope{t - 0.5, -2.0 * t, t + 0.5} {}
};

/// Bilinear between the four nodes around a point of a lattice.
template <typename Node>
double bilinear(double x, double y, Node const& node) {
    double const wholeX = std::floor(x), wholeY = std::floor(y), u = x - wholeX, v = y - wholeY;
    auto const i = static_cast<std::int64_t>(wholeX), j = static_cast<std::int64_t>(wholeY);
    double const low = node(i, j) + (node(i + 1, j) - node(i, j)) * u;
    double const high = node(i, j + 1) + (node(i + 1, j + 1) - node(i, j + 1)) * u;
    return low + (high - low) * v;
}

/// The mean of 3 x 3 nodes of a lattice twice as fine, weights 1 2 1 both ways.
template <typename Node>
double mean3(std::int64_t x, std::int64_t y, Node const& node) {
    double sum = 0.0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) sum += (2 - std::abs(dx)) * (2 - std::abs(dy)) * node(2 * x + dx, 2 * y + dy);
    return sum / 16.0;
}
}  // namespace

Relief::Relief(core::GroundFunction ground)
    : id_{nextId()}, ground_{std::move(ground)}, heights_{heightMemo()}, warmths_{0.0, 1.0},
      means_{heightMemo(), heightMemo(), heightMemo(), heightMemo()} {}

double Relief::node(std::int64_t x, std::int64_t y) const {
    return heights_.at(PointMemo::key(x, y), [&] { return ground_(static_cast<double>(x) * kNode, static_cast<double>(y) * kNode).height; });
}

double Relief::height(double east, double north) const {
    return bilinear(east / kNode, north / kNode, [&](std::int64_t x, std::int64_t y) { return node(x, y); });
}

double Relief::mean(int level, std::int64_t x, std::int64_t y) const {
    return means_[static_cast<std::size_t>(level)].at(PointMemo::key(x, y), [&] {
        if (level == 0) return mean3(x, y, [&](std::int64_t i, std::int64_t j) { return node(2 * i, 2 * j); });
        return mean3(x, y, [&](std::int64_t i, std::int64_t j) { return mean(level - 1, i, j); });
    });
}

/// The nine means around a point as a thread last asked for them: the strips of a wing all lie in one square.
struct Relief::Patch {
    std::uint64_t owner = 0;
    std::int64_t x = 0, y = 0;
    std::array<double, 9> heights{};
};

Relief::Patch const& Relief::patch(int level, std::int64_t x, std::int64_t y) const {
    thread_local std::array<Patch, kReliefBands> patches;
    Patch& p = patches[static_cast<std::size_t>(level)];
    if (p.owner == id_ && p.x == x && p.y == y) return p;
    p = {id_, x, y, {}};
    for (std::size_t i = 0; i < 9; ++i)
        p.heights[i] = mean(level, x + static_cast<std::int64_t>(i % 3) - 1, y + static_cast<std::int64_t>(i / 3) - 1);
    return p;
}

ReliefBand Relief::spline(int level, double east, double north) const {
    double const perMetre = 1.0 / (kMean * (1 << level)), px = east * perMetre, py = north * perMetre;
    double const x = std::floor(px + 0.5), y = std::floor(py + 0.5);
    Weights const u{px - x}, v{py - y};
    std::array<double, 9> const& h = patch(level, static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)).heights;
    ReliefBand sum;
    for (std::size_t j = 0; j < 3; ++j) {
        double const a = h[3 * j], b = h[3 * j + 1], c = h[3 * j + 2];
        double const value = u.value[0] * a + u.value[1] * b + u.value[2] * c;
        sum.height += v.value[j] * value;
        sum.slope += glm::dvec2{v.value[j] * (u.slope[0] * a + u.slope[1] * b + u.slope[2] * c), v.slope[j] * value} * perMetre;
    }
    return sum;
}

ReliefBands Relief::bands(double east, double north, int finest) const {
    ReliefBands bands;
    ReliefBand coarse;
    for (int level = kReliefBands - 1; level >= finest; --level) {
        ReliefBand const fine = spline(level, east, north);
        bool const first = level == kReliefBands - 1;
        bands[static_cast<std::size_t>(level)] = {first ? 0.0 : fine.height - coarse.height, fine.slope - coarse.slope};
        coarse = fine;
    }
    return bands;
}

double Relief::warmthNode(std::int64_t x, std::int64_t y) const {
    return warmths_.at(PointMemo::key(x, y), [&] {
        return mean3(x, y, [&](std::int64_t i, std::int64_t j) {
            return warmthOf(ground_(static_cast<double>(i) * 0.5 * kWarmStep, static_cast<double>(j) * 0.5 * kWarmStep).surface);
        });
    });
}

double Relief::warmth(double east, double north) const {
    return bilinear(east / kWarmStep, north / kWarmStep, [&](std::int64_t x, std::int64_t y) { return warmthNode(x, y); });
}
}  // namespace luftpost::weather
