// What falls through a point: each layer's share of the report's precipitation, where the layer's cloud is deep. It evaporates on its
// way through air that is not saturated (shaders/lib/falling.glsl says how). Pure. At the report's ground the mean over the plane is its rate.
#pragma once
#include <array>

#include "engine/weather/inside.h"
#include "engine/weather/weather.h"

namespace luftpost::weather {
/// mm/h of water.
struct Falling {
    double rain = 0.0, snow = 0.0, hail = 0.0;
};

/// How readily a genus lets fall what the report says, 0: never.
double showerShare(Genus genus);

/// How deep inside a precipitating layer a rank lies. `cover`: of the cloud to be seen, 0..1; closed stratus rains everywhere alike.
Inside showerInside(Genus genus, double rank, double cover);

/// What falls from one layer; the shaders' twin is LayerFall.
struct Shower {
    double root = 0.0;    // (mm/h)^1/2 under the base where showerInside::here is 1; 0: nothing falls
    double drying = 0.0;  // (mm/h)^1/2 per m2: what it loses times the square of the depth below `from`
    double from = 0.0;    // m above sea level: saturated above
    bool storm = false;   // of a cumulonimbus
    /// 1/m, east and north: where in the cloud stands what falls past a point, times the square of the depth below the base.
    glm::dvec2 lag{0.0};

    bool falls() const { return root > 0.0; }
    /// mm/h at an altitude (m above sea level) under a point of the cloud `inside` deep.
    double rate(double inside, double altitude) const;
    /// m, east and north, from a point at that altitude to where in the cloud its drops stand. `base`: m above sea level.
    glm::dvec2 source(double base, double altitude) const;
};

/// By layer: so that all of them together bring the report's rate to the ground, in the mean over the plane. All empty where no layer is
/// one that precipitates. `visible`: cover as seen, 0..1. 1 us.
std::array<Shower, kMaxLayers> showersOf(Weather const& weather, std::array<double, kMaxLayers> const& visible);

/// Share of a layer's fall that has gathered at an altitude: all below its base, none above its top.
double gathered(double altitude, double base, double top);

/// Liquid share of what falls near the ground, as the report says, else by its temperature (K).
double liquidAtGround(Precipitation kind, double temperature);

/// Splits a fall of `rate` into kinds. Snow above the melting, rain below, as the report says near the ground; rain freezes on what is
/// colder than 0 C (it stays rain here). `height` above ground, m; `temperature` of the point, K; `core` 0..1: how far inside a storm's core.
Falling fallingOf(Weather const& weather, double rate, double core, double height, double altitude, double temperature);

/// kg/m3 of liquid water in rain of a rate: 0.072 R^0.88 g/m3 (Marshall and Palmer 1948, as Rogers and Yau give it).
double rainWater(double rate);

/// 1/m: extinction of rain and snow of a rate, from their water content (Stoelinga and Warner 1999, who give
/// 2.24 C^0.75 and 10.36 C^0.78 per km, C in g/m3; snow's content from its rate at 1 m/s).
double fallExtinction(double rain, double snow);
}  // namespace luftpost::weather
