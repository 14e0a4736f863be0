// Which field of a GRIB file is which quantity of a report.
#pragma once
#include <optional>

#include "engine/weather/grib_sections.h"

namespace luftpost::weather {
enum class GribQuantity {
    Temperature, DewPoint, Humidity, EastWind, NorthWind,  // at 2 or 10 m (GribLevel::Ground), or at a level
    Gust, SeaPressure, StationPressure,
    CoverTotal, CoverLow, CoverMid, CoverHigh,
    BaseLow, BaseMid, BaseHigh, TopLow, TopMid, TopHigh,  // pressures
    Visibility, Cape, FreezingLevel, SnowDepth, Elevation,
    Rate, Water, Rain, FreezingRain, IcePellets, Snow,    // kg/m2/s; kg/m2; shares of the step
    Radiation, Longwave,
    Height, Geopotential, Cover                           // at a level
};

enum class GribLevel { Ground, Pressure, AboveGround, AboveSea };

struct GribMeaning {
    GribQuantity quantity;
    GribLevel level = GribLevel::Ground;  // of a cover by level: Pressure where the model's bounds are pressures (ICON)
    double value = 0.0;  // Pa or m, of the level
};

/// Nothing for a field that no report has a place for.
std::optional<GribMeaning> gribMeaning(GribField const& field);
}  // namespace luftpost::weather
