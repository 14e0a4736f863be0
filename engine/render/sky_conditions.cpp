#include "engine/render/sky_conditions.h"

#include <algorithm>
#include <array>

namespace luftpost::render {
namespace {
// Ci, Cc, Cs, Ac, As, Ns, Sc, St, Cu, Cb, fog. Fog is in the visibility already.
constexpr std::array<double, weather::kGenera> kBeamTaken{0.2, 0.2, 0.35, 0.75, 0.85, 1.0, 0.92, 0.97, 0.9, 1.0, 0.0};

double taken(weather::Layer const& layer) { return kBeamTaken.at(static_cast<std::size_t>(layer.genus)); }

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

sky::AirConditions airConditions(Snapshot const& snapshot) {
    sky::AirConditions conditions;
    conditions.visibility = snapshot.weather.visibility;
    conditions.groundAltitude = snapshot.place.altitude_m;
    if (snapshot.field == nullptr || !snapshot.drawClouds) return conditions;
    conditions.cloudBase = lowestBase(snapshot.weather);
    if (snapshot.weather.precipitationRate > 0.1 && conditions.cloudBase < 9000.0)  // rain veils all it falls through
        conditions.fogDepth = std::max(conditions.cloudBase - conditions.groundAltitude, conditions.fogDepth);
    conditions.cover = coverAbove(snapshot.weather, snapshot.camera.positionWorld.y);
    return conditions;
}
}  // namespace luftpost::render
