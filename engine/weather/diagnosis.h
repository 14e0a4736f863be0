// Which clouds stand behind bare figures: genera from cover by level, bases and tops from the genus table.
#pragma once
#include <optional>
#include <vector>

#include "engine/weather/fill.h"

namespace luftpost::weather {
/// What the rules look at.
struct Signs {
    double elevation = 0.0;               // m
    double spread = 8.0;                  // K, temperature less dew point
    double windSpeed = 3.0;               // m/s
    double rate = 0.0;                    // mm/h
    bool thunder = false;
    bool day = true;
    double sunSine = 0.5;                 // of the sun's height
    double temperature = 288.15;          // K
    double dewPoint = 280.15;             // K
    std::optional<double> radiation, longwave;  // W/m2, coming down: of the sun, of the sky
    std::optional<double> cape;           // J/kg
    std::optional<int> code;              // WMO weather code
    CoverBounds bounds;
    double low = 0.0, mid = 0.0, high = 0.0;  // cover by level
};

/// The genera of a sky of which only cover by level is known, lowest first.
std::vector<FullLayer> diagnosedLayers(Signs const& signs);

/// The share of the long-wave radiation that a clear sky lacks against a black one and that the clouds give back: near 0.8 under
/// a closed low cloud, near 0 under cirrus. Clear sky after Brutsaert (1975). Nothing where the radiation is unknown.
std::optional<double> skyReturn(Signs const& signs);

/// Cover from what comes down, where nobody looked up: by day of the sun (clear sky after Haurwitz 1945, cover after Kasten and
/// Czeplak 1980), else of the sky.
std::optional<double> coverFromRadiation(Signs const& signs);

/// The one layer of a sky of which only the total cover is known; none of no cover. With the sky's radiation, which tells low
/// cloud from high, the genus is the observer's at Basel in 54 of 100 cases (docs/weather.md); without it low cloud is taken.
std::vector<FullLayer> layersOfTotal(Signs const& signs, double cover);

/// The genus of one layer of which only cover and base above ground are known.
Genus diagnosedGenus(Signs const& signs, double cover, std::optional<double> baseAboveGround);

/// Base and top of a genus where nobody reported them. m above sea level.
double typicalBase(Signs const& signs, Genus genus);
double typicalTop(Signs const& signs, Genus genus, double cover, double base);
}  // namespace luftpost::weather
