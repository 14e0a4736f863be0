#include "engine/render/sky_conditions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luftpost::render {
namespace {
// Ci, Cc, Cs, Ac, As, Ns, Sc, St, Cu, Cb, fog. Fog is in the visibility already.
constexpr std::array<double, weather::kGenera> kBeamTaken{0.2, 0.2, 0.35, 0.75, 0.85, 1.0, 0.92, 0.97, 0.9, 1.0, 0.0};

// Share of the clear day's light under a sky closed by them. Kasten and Czeplak 1980 give a quarter in the mean of all; how
// it differs by genus is set here about that mean, thin and high ones above it, Ns and Cb below.
constexpr std::array<double, weather::kGenera> kLeft{0.61, 0.61, 0.61, 0.27, 0.27, 0.16, 0.25, 0.18, 0.25, 0.12, 0.25};
constexpr double kDarkRain = 3.5;  // mm/h: the water of such a rain halves what its cloud leaves (about its square root)
constexpr double kDarkest = 20.0;  // mm/h: a cloudburst is narrow, light comes in from beside it

double taken(weather::Layer const& layer) { return kBeamTaken.at(static_cast<std::size_t>(layer.genus)); }

/// What the sky's layers leave where they close it: the darkest counts most.
double closedShare(weather::Weather const& weather) {
    double sum = 0.0, weights = 1e-9;
    for (int i = 0; i < weather.layerCount; ++i) {
        weather::Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        double const left = kLeft.at(static_cast<std::size_t>(layer.genus)), dims = static_cast<double>(layer.cover) * (1.0 - left);
        sum += dims * dims * left;
        weights += dims * dims;
    }
    double const rain = weather.precipitation == weather::Precipitation::None ? 0.0 : std::min(weather.precipitationRate, kDarkest);
    return (sum + 1e-9 * 0.25) / weights / (1.0 + std::sqrt(rain / kDarkRain));
}

/// Share of the light from above that the sky's layers send back, and the altitude of their tops, weighed by it.
void setAlbedo(weather::Weather const& weather, sky::AirConditions& conditions) {
    double open = 1.0, tops = 0.0, weights = 0.0;
    for (int i = 0; i < weather.layerCount; ++i) {
        weather::Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        double const sent = taken(layer) * static_cast<double>(layer.cover) * (1.0 - kLeft.at(static_cast<std::size_t>(layer.genus)));
        open *= 1.0 - sent;
        tops += sent * static_cast<double>(layer.top);
        weights += sent;
    }
    if (weights < 1e-6) return;
    conditions.cloudAlbedo = 1.0 - open;
    conditions.cloudTop = tops / weights;
}

/// Lowest base of layers that dim the sun, else far above the air's haze.
double lowestBase(weather::Weather const& weather) {
    double base = 1.0e5;
    for (int i = 0; i < weather.layerCount; ++i) {
        weather::Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        if (taken(layer) * static_cast<double>(layer.cover) > 0.05) base = std::min(base, static_cast<double>(layer.base));
    }
    return base;
}
}  // namespace

double coverAbove(weather::Weather const& weather, double altitude) {
    double open = 1.0;
    for (int i = 0; i < weather.layerCount; ++i) {
        weather::Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        double const depth = std::max(static_cast<double>(layer.top - layer.base), 1.0);
        double const above = std::clamp((static_cast<double>(layer.top) - altitude) / depth, 0.0, 1.0);
        open *= 1.0 - taken(layer) * static_cast<double>(layer.cover) * above;
    }
    return 1.0 - open;
}

namespace {
/// coverAbove; but where it rains there is cloud overhead, whatever share of the land has some.
double dimmingCover(weather::Weather const& weather, double altitude, double cloudBase) {
    double const cover = coverAbove(weather, altitude);
    if (weather.precipitation == weather::Precipitation::None || cover <= 0.0) return cover;
    double const rain = std::clamp(weather.precipitationRate / 2.0, 0.0, 1.0);
    double const below = std::clamp((cloudBase + 500.0 - altitude) / 500.0, 0.0, 1.0);
    return std::lerp(cover, std::max(cover, 0.99), rain * below);
}
}  // namespace

sky::AirConditions airConditions(Snapshot const& snapshot) {
    sky::AirConditions conditions;
    conditions.visibility = snapshot.weather.visibility;
    conditions.groundAltitude = snapshot.place.altitude_m;
    if (snapshot.field == nullptr || !snapshot.drawClouds) return conditions;
    conditions.cloudBase = lowestBase(snapshot.weather);
    if (snapshot.weather.precipitationRate > 0.1 && conditions.cloudBase < 9000.0)  // rain veils all it falls through
        conditions.fogDepth = std::max(conditions.cloudBase - conditions.groundAltitude, conditions.fogDepth);
    conditions.cover = dimmingCover(snapshot.weather, snapshot.camera.positionWorld.y, conditions.cloudBase);
    conditions.landCover = dimmingCover(snapshot.weather, std::min(snapshot.camera.positionWorld.y, snapshot.place.altitude_m), conditions.cloudBase);
    setAlbedo(snapshot.weather, conditions);
    conditions.closedShare = closedShare(snapshot.weather);
    return conditions;
}
}  // namespace luftpost::render
