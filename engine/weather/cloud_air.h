// What clouds and heated ground do to the air at a point: lift, turbulence, outflow, what falls, what dims and what freezes. Pure.
#pragma once
#include <array>

#include "engine/weather/cloud_settings.h"
#include "engine/weather/ranks.h"
#include "engine/weather/relief.h"
#include "engine/weather/showers.h"
#include "engine/weather/stirring.h"
#include "engine/weather/weather.h"
#include "shaders/shared/cloud.glsl.h"

namespace luftpost::weather {
struct NoiseVolumes;

/// The clouds of one weather, all but their ranks.
struct CloudsNow {
    Weather weather;
    glsl::CloudColumn column;
    glsl::CloudShape shape;     // with noise volumes only
    Stirring stirring;
    std::array<Shower, kMaxLayers> showers{};
    std::array<double, kMaxLayers> visible{};  // share of the plane where a layer is seen: the rank below which there is cloud

    /// Whether what falls comes from clouds that are known.
    bool fallsFromClouds() const;
};
/// `sun`: of sunHeating.
CloudsNow cloudsOf(Weather const& weather, unsigned seed, CloudSettings const& settings, bool withShape, double sun);

/// The pattern of the thermals that have no cloud; Ranks must know it.
inline constexpr unsigned kDryPattern = 0x7e3a11u;
/// The layer that carries it: it drifts with the boundary layer. `hours` since the recording's start.
Layer dryLayer(glm::dvec2 drift, double hours);

/// A point and the mean air there.
struct AirPoint {
    glm::dvec3 positionWorld{0.0};
    double east = 0.0, north = 0.0, altitude = 0.0;  // m
    double ground = 0.0, height = 0.0;               // m above sea level, and of the point above it
    double temperature = 288.15;                     // K
};

/// All that is asked beside the clouds; references that live as long as the question.
struct CloudAirSources {
    Ranks const& ranks;
    Relief const& relief;
    Layer const& dry;
    NoiseVolumes const* noise;  // none: clouds dim nothing
    double scale;               // CloudSettings::weatherScale
};

struct CloudEffect {
    glm::dvec2 wind{0.0};                    // m/s, east and north
    double lift = 0.0, variance = 0.0;       // m/s, m2/s2
    double extinction = 0.0, icing = 0.0;    // 1/m, kg/m3
    double rain = 0.0, snow = 0.0, hail = 0.0;  // mm/h of water
};
CloudEffect cloudEffect(CloudsNow const& sky, AirPoint const& at, CloudAirSources const& from);
}  // namespace luftpost::weather
