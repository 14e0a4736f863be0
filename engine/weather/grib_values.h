// The numbers of a GRIB field, unpacked by ecCodes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/weather/grib_sections.h"

namespace luftpost::weather {
/// All points in the grid's order, in the units of WMO's tables; NaN where the bitmap has a hole. Throws core::Error. Any thread,
/// one at a time (ecCodes has one context for all).
std::vector<double> gribValues(GribField const& field, std::string const& file);

/// At a spot of the grid: bilinear between the four points around it; where one of them is a hole, the nearest if it is none.
std::optional<double> gribValueAt(std::vector<double> const& values, GribGrid const& grid, GribGrid::Spot spot);
}  // namespace luftpost::weather
