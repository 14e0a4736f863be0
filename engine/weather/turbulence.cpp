#include "engine/weather/turbulence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/ramp.h"

namespace luftpost::weather {
namespace {
constexpr double kFoot = core::kMetresPerFoot;
constexpr double kLow = 1000.0, kHigh = 2000.0, kHighLength = 1750.0;  // ft
constexpr double kFade = 2000.0;  // m, above 2000 ft: the free air is smoother than the boundary layer
constexpr double kStableFrom = 50.0, kStableTo = 300.0, kStableLoss = 0.7;  // m above ground; of the rms

/// Height, so that small tables can stand for the powers: MIL-F-8785C's h below 1000 ft.
double shape(double feet) { return 0.177 + 0.000823 * feet; }

/// sigma_w above 2000 ft for a wind at 20 ft: through (0, 0), (15 kt, 5 ft/s), (30, 10), (45, 20), then on.
double severity(double windGround) {
    double const knots = windGround / core::kMetresPerSecondPerKnot;
    double const feet = knots <= 30.0 ? knots / 3.0 : 10.0 + (knots - 30.0) * (10.0 / 15.0);
    return feet * kFoot;
}

/// The sizes of the noise: distance of its lattice points, m.
constexpr std::array<double, 6> kSizes{9.0, 22.0, 55.0, 140.0, 350.0, 880.0};
using Shares = std::array<double, kSizes.size()>;
/// Mean square of the noise, that of values uniform on -1..1.
constexpr double kNoiseSquare = 1.0 / 3.0;

/// The amplitude of each size, by the length of the gusts. Such noise is white for waves longer than its lattice and ends below:
/// shares of the variance near the lattice's distance over the length, cut off where it is longer, sum to Dryden's spectra within a
/// third from a twentieth of the wave number 1/L up to the smallest size, for lengths above 50 m (fitted; turbulence_test measures it).
/// Tables in the square root of the length, because the air asks thousands of times a second.
class Amplitudes {
public:
    explicit Amplitudes(bool vertical) {
        for (std::size_t n = 0; n < kNodes; ++n) nodes_[n] = made(vertical, lengthOf(n));
    }
    Shares at(double length) const {
        double const x = std::clamp(std::sqrt(length) * kPerRoot, 1.0, kNodes - 1.001);
        auto const n = static_cast<std::size_t>(x);
        double const u = x - static_cast<double>(n);
        Shares shares;
        for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = nodes_[n][i] + (nodes_[n + 1][i] - nodes_[n][i]) * u;
        return shares;
    }

private:
    static constexpr std::size_t kNodes = 98;
    static constexpr double kHorizontalCut = 2.7, kVerticalCut = 1.67;  // lengths
    static constexpr double kPerRoot = 4.0;  // nodes a root metre: to 580 m
    static double lengthOf(std::size_t n) {
        double const root = std::max(static_cast<double>(n), 1.0) / kPerRoot;
        return root * root;
    }
    static Shares made(bool vertical, double length) {
        Shares shares;
        double sum = 0.0;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            double const y = kSizes[i] / length, cut = y / (vertical ? kVerticalCut : kHorizontalCut);
            shares[i] = y * core::exp(-cut * cut * cut);
            if (i == 0) shares[i] = std::max(shares[i], 1e-30);  // shorter gusts than the smallest size have that
            sum += shares[i];
        }
        for (double& share : shares) share = std::sqrt(share / (sum * kNoiseSquare));
        return shares;
    }
    std::array<Shares, kNodes> nodes_{};
};

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

/// Noise between values uniform on -1..1 at the points of a lattice, three components at once. What the mixing of eight values takes from their
/// variance is given back, so that no altitude is smoother than another.
glm::dvec3 noise(glm::dvec3 const& p, std::uint64_t seed) {
    glm::dvec3 const whole{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    auto const part = [](double n, std::uint64_t factor) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(n)) * factor; };
    constexpr std::uint64_t kX = 0x9E3779B97F4A7C15u, kY = 0xC2B2AE3D27D4EB4Fu, kZ = 0x165667B19E3779F9u;
    std::uint64_t const x = part(whole.x, kX), y = part(whole.y, kY), z = part(whole.z, kZ);
    double const u = fade(p.x - whole.x), v = fade(p.y - whole.y), w = fade(p.z - whole.z);
    double const along[2]{1.0 - u, u}, up[2]{1.0 - v, v}, across[2]{1.0 - w, w};
    glm::dvec3 sum{0.0};
    for (unsigned corner = 0; corner < 8; ++corner) {
        unsigned const i = corner & 1u, j = corner >> 1 & 1u, k = corner >> 2;
        std::uint64_t h = seed ^ (x + i * kX) ^ (y + j * kY) ^ (z + k * kZ);
        h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9u;
        h ^= h >> 32;
        double const weight = along[i] * up[j] * across[k];
        auto const value = [h](unsigned from) { return static_cast<double>(static_cast<std::int32_t>(h >> from & 0x1FFFFFu)); };
        sum += weight * glm::dvec3{value(0), value(21), value(42)};
    }
    auto const kept = [](double t) { return t * t + (1.0 - t) * (1.0 - t); };
    return (sum * (2.0 / 2097151.0) - glm::dvec3{1.0}) / std::sqrt(kept(u) * kept(v) * kept(w));
}
}  // namespace

Gustiness drydenGustiness(double windGround, double height, AirStability stability) {
    double const feet = std::max(height, 3.0) / kFoot;
    double const low = std::min(feet, kLow);
    double const root = core::pow(shape(low), 0.4);
    Gustiness g;
    double const left = 1.0 - kStableLoss * stability.stable * smooth(kStableFrom, kStableTo, height);
    g.sigmaVertical = 0.1 * windGround * left;
    g.sigmaHorizontal = g.sigmaVertical / root;
    g.lengthVertical = low * kFoot;
    g.lengthHorizontal = low * kFoot / (root * root * root);
    if (feet <= kLow) return g;
    double const up = std::min((feet - kLow) / (kHigh - kLow), 1.0);
    double const above = std::max(0.0, (feet - kHigh) * kFoot);
    double const free = left * stability.mixing * severity(windGround) * core::exp(-above / kFade);
    auto const toward = [up](double a, double b) { return a + (b - a) * up; };
    return {toward(g.sigmaHorizontal, free), toward(g.sigmaVertical, free), toward(g.lengthHorizontal, kHighLength * kFoot),
            toward(g.lengthVertical, kHighLength * kFoot)};
}

glm::dvec3 gustAt(glm::dvec3 const& point, Gustiness const& g, unsigned seed) {
    glm::dvec3 gust{0.0};
    if (g.sigmaHorizontal <= 0.0 && g.sigmaVertical <= 0.0) return gust;
    static Amplitudes const horizontal{false}, vertical{true};
    Shares const across = horizontal.at(g.lengthHorizontal), up = vertical.at(g.lengthVertical);
    for (std::size_t i = 0; i < kSizes.size(); ++i) {
        double const a = g.sigmaHorizontal * across[i], b = g.sigmaVertical * up[i];
        if (a * a + b * b < 1e-6) continue;
        glm::dvec3 const n = noise(point / kSizes[i] + glm::dvec3{0.37 * static_cast<double>(i)}, (std::uint64_t{seed} << 8) + i * 0x9E3779B9u + 1u);
        gust += glm::dvec3{a * n.x, b * n.y, a * n.z};
    }
    return gust;
}
}  // namespace luftpost::weather
