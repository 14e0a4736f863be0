// What stirs the air of a place and hour: the sun's heating, which clouds, rain and snow take away, and the calm of a clear night. Pure.
#pragma once
#include "engine/core/environment.h"
#include "engine/core/frames.h"
#include "engine/weather/weather.h"

namespace luftpost::weather {
struct Stirring {
    double heating = 0.0;  // 0..1: how much of a high sun's heat the ground gives the air
    double stable = 0.0;   // 0 neutral or unstable .. 1 clear, windless night
    double dry = 0.0;      // 0..1: strength of thermals without cloud
    double depth = 0.0;    // m above ground, to which these reach
};

/// The sun that the ground has taken up: the mean of its height now and an hour and a half before (mornings lag), as 0..1.
double sunHeating(core::Place const& place, core::UtcSeconds time);

/// `sun`: of sunHeating. Where it is no warmer than in the standard atmosphere nothing says that the ground is hot, and there are no
/// thermals without cloud.
Stirring stirringOf(Weather const& weather, double sun);

/// Share of the sky that takes the sun away, 0..1, all layers together (random overlap; thin high cloud counts a third).
double shadingCover(Weather const& weather);

/// Deardorff's velocity scale of free convection, m/s, for a kinematic heat flux of 0.2 K m/s at full heating: 2.1 at 1500 m.
double convectiveSpeed(double heating, double depth);
}  // namespace luftpost::weather
