// What falls through a point: each layer's share of the report's precipitation, where the layer's cloud is deep. Pure. Over the plane
// the mean is the report's rate.
#pragma once
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

/// mm/h that fall per unit of showerInside::here and of showerShare, so that all layers of the weather together fall at its rate in the
/// mean over the plane. 0 where no layer is one that precipitates.
double showerRate(Weather const& weather);

/// Share of a layer's fall that has gathered at an altitude: all below its base, none above its top.
double gathered(double altitude, double base, double top);

/// Splits a fall of `rate` into kinds. Snow above the melting, rain below, as the report says near the ground; rain freezes on what is
/// colder than 0 C (it stays rain here). `height` above ground, m; `temperature` of the point, K; `core` 0..1: how far inside a storm's core.
Falling fallingOf(Weather const& weather, double rate, double core, double height, double altitude, double temperature);

/// kg/m3 of liquid water in rain of a rate: 0.072 R^0.88 g/m3 (Marshall and Palmer 1948, as Rogers and Yau give it).
double rainWater(double rate);

/// 1/m: extinction of rain and snow of a rate, from their water content (Stoelinga and Warner 1999, who give
/// 2.24 C^0.75 and 10.36 C^0.78 per km, C in g/m3; snow's content from its rate at 1 m/s).
double fallExtinction(double rain, double snow);
}  // namespace luftpost::weather
