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
    std::optional<double> cape;           // J/kg
    std::optional<int> code;              // WMO weather code
    CoverBounds bounds;
    double low = 0.0, mid = 0.0, high = 0.0;  // cover by level
};

/// The genera of a sky of which only cover by level is known, lowest first.
std::vector<FullLayer> diagnosedLayers(Signs const& signs);

/// The genus of one layer of which only cover and base above ground are known.
Genus diagnosedGenus(Signs const& signs, double cover, std::optional<double> baseAboveGround);

/// Base and top of a genus where nobody reported them. m above sea level.
double typicalBase(Signs const& signs, Genus genus);
double typicalTop(Signs const& signs, Genus genus, double cover, double base);
}  // namespace luftpost::weather
