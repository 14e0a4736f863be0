// Lift and sink that belong to a visible cloud: thermals under cumulus, sinking air between them, thermals without cloud, the
// updraught of a cumulonimbus. Pure. Over the plane each sums to nothing.
#pragma once
#include "engine/weather/weather.h"

namespace luftpost::weather {
/// Where a point lies with regard to a convective layer.
struct UnderCloud {
    double rank = 1.0;       // of the layer's pattern over the foot of what rises here
    double threshold = 0.0;  // of the rank, below which there is cloud to be seen, 0..1
    double altitude = 0.0, ground = 0.0, base = 0.0, top = 0.0;  // m above sea level
    double heating = 0.0;    // 0 by night .. 1 under a high sun
};

struct Convection {
    double lift = 0.0;       // m/s, up
    double sigma = 0.0;      // m/s, rms of the turbulence it adds
};

/// Of a cumulus. Below the base the profile of a mixed layer's updraughts, (z/zi)^(1/3) near the ground (Lenschow and Stephens 1980;
/// Allen 2006, AIAA 2006-1510), but alive at the base, where the cloud takes over. 1 to 3 m/s under a
/// cloud at noon; by night only what the cloud's own warmth lifts inside it.
Convection cumulusConvection(UnderCloud const& at);

/// Thermals without cloud: Allen's model with Deardorff's speed, w = w* (z/zi)^(1/3) (1 - 1.1 z/zi) in the mean over a thermal and
/// twice that in its middle. `rank`: of a pattern of their own; they take 15 % of the land. `height` above ground, `depth` of
/// the mixed layer, m. `strength` 0..1 scales the speed.
Convection dryConvection(double rank, double height, double depth, double heating, double strength);

/// Of a cumulonimbus: the cores above its base, by CAPE (J/kg), at most 16 m/s; `at.rank` is that of the cores.
Convection stormUpdraught(UnderCloud const& at, double cape);

/// The speed at which the warm air itself rises, for its lean: m/s, from the cloud's thickness, m. It is about twice the lift that an
/// aircraft meets, the mean over what is as wide as its turn.
double riseSpeed(double thickness);

/// What rises through a point meets the cloud's base this far away, m east and north: the wind, over the time that the rest of the way
/// takes. The mean wind from the height z to the base b is that at the cloud and, by (1 - z/b)^2 / 4, that at the ground: within 2 % of
/// the power law 0.16's. `below`: b - z, m, 0..`depth`; `depth`: b, m above ground.
glm::dvec2 thermalLean(glm::dvec2 windSurface, glm::dvec2 windCloud, double below, double depth, double speed);
}  // namespace luftpost::weather
