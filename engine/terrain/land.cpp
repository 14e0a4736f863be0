#include "engine/terrain/land.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/frames.h"
#include "engine/terrain/raw_land.h"

namespace luftpost::terrain {
namespace {
constexpr int kLanes = 8;  // points that one vector of the widest kind we build for holds

__attribute__((always_inline)) inline void rawRow(double const* __restrict east, double const* __restrict north,
                                                  float* __restrict out, std::size_t count, std::uint32_t seed) {
    for (std::size_t i = 0; i < count; ++i) out[i] = raw::height(east[i], north[i], seed);
}
void rawRowPlain(double const* east, double const* north, float* out, std::size_t count, std::uint32_t seed) {
    rawRow(east, north, out, count, seed);
}
#if defined(__x86_64__)
__attribute__((target("avx2"))) void rawRowWide(double const* east, double const* north, float* out, std::size_t count,
                                                std::uint32_t seed) {
    rawRow(east, north, out, count, seed);
}
#endif

void rawHeights(double const* east, double const* north, float* out, std::size_t count, std::uint32_t seed) {
#if defined(__x86_64__)
    static bool const wide = __builtin_cpu_supports("avx2") != 0;
    if (wide) return rawRowWide(east, north, out, count, seed);
#endif
    rawRowPlain(east, north, out, count, seed);
}

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Unit vector of a heading that is a whole number of tens of degrees, by repeated turning: the same bits everywhere.
glm::dvec2 directionOfTens(unsigned tens) {
    constexpr double kCos10 = 0.984807753012208, kSin10 = 0.17364817766693033;
    glm::dvec2 direction{0.0, 1.0};
    for (unsigned i = 0; i < tens; ++i)
        direction = {direction.x * kCos10 + direction.y * kSin10, direction.y * kCos10 - direction.x * kSin10};
    return direction;
}

constexpr double kPadAlong = 560.0, kPadAcross = 75.0;  // half sizes of the level field around the runway, m
constexpr double kPadFade = 850.0;                      // m over which the field runs out into the land
constexpr double kCapFrom = 20000.0, kCapTo = 33000.0;  // m from the field: where its open bowl ends
}  // namespace

glm::dvec2 Runway::alongAcross(double east, double north) const {
    return {east * directionEastNorth.x + north * directionEastNorth.y, east * directionEastNorth.y - north * directionEastNorth.x};
}
bool Runway::contains(double east, double north) const {
    glm::dvec2 const p = alongAcross(east, north);
    return std::abs(p.x) <= 0.5 * length && std::abs(p.y) <= 0.5 * width;
}
glm::dvec2 Runway::threshold(bool reversed) const { return directionEastNorth * (reversed ? 0.5 * length : -0.5 * length); }

Land::Land(unsigned seed, double base) : seed_{seed} {
    CHECK(std::isfinite(base), "the base altitude is {}", base);
    std::uint32_t const h = raw::hashOf(static_cast<int>(seed), 17, 0x51ed270bu);
    unsigned const tens = h % 18u;
    runway_.directionEastNorth = directionOfTens(tens);
    runway_.heading = core::radians(10.0 * tens);
    runway_.altitude = base;
    placeHome();
}

// Tries places of the raw land and keeps the one that suits an airfield best: low and even, dry, with mountains in sight.
void Land::placeHome() {
    double best = 1e30, bestRaw = 0.0;
    for (int candidate = 0; candidate < 160; ++candidate) {
        std::uint32_t const h = raw::hashOf(candidate, static_cast<int>(seed_), 0x2545f491u);
        double const east = 20.0 * static_cast<int>(h & 0xffffu), north = 20.0 * static_cast<int>(h >> 16);
        std::array<double, 40> e, n;
        std::array<float, 40> z;
        constexpr std::array<double, 5> kRings{450.0, 1600.0, 5000.0, 11000.0, 17000.0};
        for (std::size_t i = 0; i < e.size(); ++i) {
            glm::dvec2 const d = directionOfTens(static_cast<unsigned>((i % 8) * 9 / 2 + i / 8)) * kRings[i / 8];
            e[i] = east + d.x, n[i] = north + d.y;
        }
        rawHeights(e.data(), n.data(), z.data(), z.size(), seed_);
        auto const ring = [&](std::size_t first, std::size_t last) { return std::minmax_element(z.begin() + static_cast<long>(8 * first), z.begin() + static_cast<long>(8 * last)); };
        double mean = 0.0;
        for (std::size_t i = 0; i < 8; ++i) mean += static_cast<double>(z[i]) / 8.0;
        auto const [lowNear, highNear] = ring(0, 2);
        auto const [lowMid, highMid] = ring(2, 4);
        auto const [lowFar, highFar] = ring(4, 5);
        double const cost = std::max(0.0, 22.0 - static_cast<double>(*lowNear)) * 20.0 + 4.0 * static_cast<double>(*highNear - *lowNear) +
                            2.0 * std::abs(mean - 45.0) + std::max(0.0, static_cast<double>(*highMid) - mean - 600.0) +
                            0.4 * std::max(0.0, 1100.0 + mean - static_cast<double>(*highFar)) + 2.0 * std::max(0.0, 15.0 + static_cast<double>(*lowMid));
        if (cost < best) best = cost, homeEast_ = east, homeNorth_ = north, bestRaw = mean;
    }
    lift_ = runway_.altitude - bestRaw;
    waterLevel_ = lift_;
}

// Lays the airfield into the land: level on the field, open around it. Heights within 15 km stay below a bowl that rises
// from 2 % at the field to 900 m, so that approaches are clear.
void Land::capNearHome(double east, double north, double& height) const {
    glm::dvec2 const p = runway_.alongAcross(east, north);
    double const a = std::max(0.0, std::abs(p.x) - kPadAlong), b = std::max(0.0, std::abs(p.y) - kPadAcross);
    double const distance = std::sqrt(a * a + b * b);
    if (distance >= kCapTo) return;
    double const excess = (height - runway_.altitude) * smooth(distance / kPadFade);
    double const cap = 6.0 + 0.02 * distance + 2.6e-6 * distance * distance;
    double const soft = 0.25 * cap, gap = excess - cap;
    double const capped = 0.5 * (excess + cap - std::sqrt(gap * gap + soft * soft)) + 0.5 * (std::sqrt(cap * cap + soft * soft) - cap);
    double const share = 1.0 - smooth((distance - kCapFrom) / (kCapTo - kCapFrom));
    height = runway_.altitude + excess + (capped - excess) * share;
}

void Land::heights(std::span<double const> east, std::span<double const> north, std::span<double> out) const {
    CHECK(east.size() == north.size() && east.size() == out.size(), "{}, {} and {} points", east.size(), north.size(), out.size());
    constexpr std::size_t kBlock = 64;
    std::array<double, kBlock> e{}, n{};
    std::array<float, kBlock> z;
    for (std::size_t from = 0; from < east.size(); from += kBlock) {
        std::size_t const count = std::min(kBlock, east.size() - from);
        std::size_t const padded = (count + kLanes - 1) / kLanes * kLanes;  // whole vectors only: no slow remainder
        for (std::size_t i = 0; i < count; ++i) e[i] = east[from + i] + homeEast_, n[i] = north[from + i] + homeNorth_;
        rawHeights(e.data(), n.data(), z.data(), padded, seed_);
        for (std::size_t i = 0; i < count; ++i) {
            out[from + i] = lift_ + static_cast<double>(z[i]);
            capNearHome(east[from + i], north[from + i], out[from + i]);
        }
    }
}

double Land::height(double east, double north) const {
    double out = 0.0;
    heights({&east, 1}, {&north, 1}, {&out, 1});
    return out;
}

core::GroundSample Land::ground(double east, double north) const {
    constexpr double kReach = 1.0;  // m
    std::array<double, 5> const e{east, east - kReach, east + kReach, east, east};
    std::array<double, 5> const n{north, north, north, north - kReach, north + kReach};
    std::array<double, 5> z;
    heights(e, n, z);
    core::GroundSample sample;
    if (z[0] < waterLevel_) {
        sample.height = waterLevel_;
        sample.surface = core::Surface::water;
        return sample;
    }
    sample.height = z[0];
    double const slopeEast = (z[2] - z[1]) / (2.0 * kReach), slopeNorth = (z[4] - z[3]) / (2.0 * kReach);
    sample.normalWorld = glm::dvec3{-slopeEast, 1.0, slopeNorth} / std::sqrt(1.0 + slopeEast * slopeEast + slopeNorth * slopeNorth);
    double const flatness = sample.normalWorld.y;
    if (runway_.contains(east, north)) sample.surface = core::Surface::runway;
    else if (flatness < 0.80) sample.surface = core::Surface::rock;
    else if (z[0] > kSnowLine) sample.surface = core::Surface::snow;
    else if (z[0] < waterLevel_ + 1.5) sample.surface = core::Surface::sand;
    return sample;
}
}  // namespace luftpost::terrain
