// Lift and sink that belong to a visible cloud: thermals under cumulus, sinking air between them, the shaft of rain and the
// updraught of a cumulonimbus. Pure.
#pragma once
#include "engine/weather/weather.h"

namespace luftpost::weather {
/// Where a point lies with regard to a convective layer.
struct UnderCloud {
    double rank = 1.0;       // of the layer's pattern there
    double threshold = 0.0;  // of the rank, below which there is cloud (calibrated cover), 0..1
    double altitude = 0.0, ground = 0.0, base = 0.0, top = 0.0;  // m above sea level
    double heating = 0.0;    // 0 by night .. 1 under a high sun
    double rain = 0.0;       // mm/h on the ground
};

struct Convection {
    double lift = 0.0;       // m/s, up
    double sigma = 0.0;      // m/s, rms of the turbulence it adds
};

/// Of a cumulus: over the plane the lift sums to nothing, because ranks are uniform. m/s, gentle: 1 to 3 under the middle of
/// a cloud at noon.
Convection cumulusConvection(UnderCloud const& at);

/// Of a cumulonimbus: rain drags the air down under the base, above it the air rises.
Convection stormConvection(UnderCloud const& at);
}  // namespace luftpost::weather
