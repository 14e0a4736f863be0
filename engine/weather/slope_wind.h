// What the land does to the wind: lift before a slope and sink behind it, speed over crests and shelter in hollows, a turn along
// the slope, turbulence over steep ground and rotors in the lee. Pure.
#pragma once
#include "engine/weather/relief.h"

namespace luftpost::weather {
struct SlopeWind {
    glm::dvec2 wind{0.0};   // m/s, east and north: added to the mean wind
    double lift = 0.0;      // m/s, up
    double variance = 0.0;  // m2/s2, of the turbulence it adds
};

/// The finest size of the relief that is felt at a height above ground, m; kReliefBands: none, and slopeWind gives nothing.
int finestFelt(double height);

/// `wind`: the mean wind at the point, m/s. `height`: above the ground, m. `stable`: 0..1.
///
/// Over gentle hills the flow is that of a potential: hills of wave number k lift the wind by V . grad(h) at the ground, hasten it
/// by the share k h over crests and slow it as much over hollows, and both die away as exp(-k z) (Jackson and Hunt 1975, Quarterly
/// Journal 101: the outer layer; Taylor and Lee 1984, Climatological Bulletin 18: 2 H/L over a ridge). Every size of the relief has
/// its own k; what glider pilots say of a ridge, full lift near it and none beyond twice its height, is made of that: each size is
/// felt in full up to 130 m, then fades and ends. Lift and sink sum to nothing over the land. Steep slopes are not followed wholly:
/// behind them the flow comes off, and in a strong wind a rotor rolls there. Stable air does not climb: less lift near the ground.
SlopeWind slopeWind(ReliefBands const& relief, glm::dvec2 wind, double height, double stable);
}  // namespace luftpost::weather
