#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/field.h"

namespace luftpost::weather {
namespace {
constexpr double kAnemometer = 10.0;       // m above ground
constexpr double kRoughness = 0.05;        // m, open country (WMO-No. 8, class 4 to 5)
constexpr double kPower = 0.16;            // of the power law, open country by day
constexpr double kBoundaryTop = 1000.0;    // m above ground: the surface rubs no further
constexpr double kThermalWind = 0.15e-3;   // 1/m: what the westerlies gain above, as a share of the surface wind
constexpr double kVeering = 25.0;          // deg, from the surface to the free air
constexpr double kVeeringHeight = 350.0;   // m
constexpr double kLevelFrom = 3000.0;      // m above the site: from here on levels ignore the land
constexpr double kFreeFrom = 300.0, kFreeTo = 1500.0;  // m above ground: from the wind of the moment to that of the hours

/// Wind speed at a height over that at 10 m.
double speedFactor(double height) {
    if (height < kAnemometer)
        return core::log((std::max(height, 0.0) + kRoughness) / kRoughness) / core::log((kAnemometer + kRoughness) / kRoughness);
    double const below = core::pow(std::min(height, kBoundaryTop) / kAnemometer, kPower);
    return below + std::max(0.0, height - kBoundaryTop) * kThermalWind;
}

/// How far the wind has turned to the right (to the left in the south) since 10 m. Radians.
double veering(double height, bool southern) {
    double const turn = core::radians(kVeering) * (1.0 - core::exp(-std::max(0.0, height - kAnemometer) / kVeeringHeight));
    return southern ? -turn : turn;
}

/// What the ground does to the wind at a height: a turn by the angle and a factor, as a table (both are smooth in the square
/// root of the height), because the air asks thousands of times a second.
class Rub {
public:
    struct At {
        double along, across;  // factor times cosine and sine of the turn to the right
    };

    explicit Rub(bool southern) {
        for (int i = 0; i < kNodes; ++i) {
            double const height = heightOf(i), angle = veering(height, southern), factor = speedFactor(height);
            nodes_[static_cast<std::size_t>(i)] = {factor * core::cos(angle), factor * core::sin(angle)};
        }
    }
    At at(double height) const {
        double const x = std::clamp(std::sqrt(std::max(height, 0.0)) * kPerRoot, 0.0, kNodes - 1.001);
        auto const i = static_cast<std::size_t>(x);
        double const u = x - static_cast<double>(i);
        At const& a = nodes_[i];
        At const& b = nodes_[i + 1];
        return {a.along + (b.along - a.along) * u, a.across + (b.across - a.across) * u};
    }
    static glm::dvec2 turned(glm::dvec2 wind, At by) {
        return {wind.x * by.along + wind.y * by.across, wind.y * by.along - wind.x * by.across};
    }

private:
    static constexpr int kNodes = 512;
    static constexpr double kPerRoot = 4.0;  // nodes a root metre: to 16 km
    static double heightOf(int i) { return (i / kPerRoot) * (i / kPerRoot); }
    std::array<At, kNodes> nodes_{};
};

Rub const& rubOf(bool southern) {
    static Rub const north{false}, south{true};
    return southern ? south : north;
}

glm::dvec2 fromSurface(Profile const& p, double height) {
    double const u = std::clamp((height - kFreeFrom) / (kFreeTo - kFreeFrom), 0.0, 1.0);
    glm::dvec2 const anchor = p.windSurface + (p.windMean - p.windSurface) * (u * u * (3.0 - 2.0 * u));
    return Rub::turned(anchor, rubOf(p.southern).at(height));
}

/// Above the topmost level its wind goes on growing and turning as it would from the surface.
glm::dvec2 aboveLevels(Profile const& p, glm::dvec2 top, double topHeight, double height) {
    auto const from = rubOf(p.southern).at(topHeight), to = rubOf(p.southern).at(height);
    double const square = from.along * from.along + from.across * from.across;
    return Rub::turned(top, {(to.along * from.along + to.across * from.across) / square,
                             (to.across * from.along - to.along * from.across) / square});
}

/// Levels follow the land where they are near it, and lie level where they are high.
double levelHeight(Profile const& p, int i, double lift) {
    double const own = p.altitude[static_cast<std::size_t>(i)] - p.elevation;
    return own - lift * std::clamp(own / kLevelFrom, 0.0, 1.0);
}
}  // namespace

glm::dvec2 windAt(Profile const& p, double altitude, double ground) {
    double const height = altitude - ground;
    if (p.levels == 0 || height <= kAnemometer) return fromSurface(p, height);
    double const lift = ground - p.elevation;
    auto const windOf = [&](int i) { return p.wind[static_cast<std::size_t>(i)]; };
    int above = 0;
    while (above < p.levels && levelHeight(p, above, lift) < height) ++above;
    if (above == p.levels) {
        double const topHeight = levelHeight(p, p.levels - 1, lift);
        if (topHeight <= kAnemometer) return fromSurface(p, height);
        return aboveLevels(p, windOf(p.levels - 1), topHeight, height);
    }
    double const lowHeight = above == 0 ? kAnemometer : std::max(kAnemometer, levelHeight(p, above - 1, lift));
    glm::dvec2 const low = above == 0 || levelHeight(p, above - 1, lift) < kAnemometer ? p.windSurface : windOf(above - 1);
    double const high = levelHeight(p, above, lift);
    double const u = high > lowHeight ? std::clamp((height - lowHeight) / (high - lowHeight), 0.0, 1.0) : 1.0;
    return low + (windOf(above) - low) * u;
}
}  // namespace luftpost::weather
