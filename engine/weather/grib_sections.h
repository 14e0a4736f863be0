// The envelope of GRIB edition 2 (WMO FM 92): bytes -> fields, each with what it is, when and where it holds, and a message of its
// own for ecCodes to unpack. Everything that ecCodes would trust (lengths, counts, groups) is added up here first, because it stops
// the program where they do not fit. Throws core::Error that names the message and its byte.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/environment.h"

namespace luftpost::weather {
/// A regular grid of latitudes and longitudes (template 3.0): row by row, each row along the longitudes.
struct GribGrid {
    std::size_t columns = 0, rows = 0;
    double lat0 = 0.0, lon0 = 0.0;          // degrees, of the first point
    double latStep = 0.0, lonStep = 0.0;    // degrees, signed; 0 where there is one row or column
    bool around = false;                    // the last column's neighbour is the first

    std::size_t points() const { return columns * rows; }
    /// Where a place lies, in columns and rows from the first point; nothing outside the grid.
    struct Spot {
        double column, row;
    };
    std::optional<Spot> spotOf(double lat_deg, double lon_deg) const;
    double latOf(std::size_t row) const { return lat0 + latStep * static_cast<double>(row); }
    double lonOf(std::size_t column) const;  // -180..180
};

/// Table 4.10; Instant where the product is of one moment.
enum class GribStatistic : int { Instant = -1, Mean = 0, Sum = 1, Maximum = 2, Minimum = 3, Other = 255 };

/// A surface of table 4.5.
struct GribSurface {
    int type = 255;
    double value = 0.0;
};

struct GribField {
    std::string place;  // "message 3 at byte 12345"
    int centre = 0;
    int discipline = 0, category = 0, number = 0;
    GribSurface first, second;
    GribStatistic statistic = GribStatistic::Instant;
    core::UtcSeconds reference = 0.0;        // the run
    core::UtcSeconds from = 0.0, time = 0.0;  // the same for an instant
    GribGrid grid;
    std::string message;  // complete, with this field alone

    bool is(int aDiscipline, int aCategory, int aNumber) const { return discipline == aDiscipline && category == aCategory && number == aNumber; }
};

/// Calls `take` for every field of the file in its order. A field whose `wanted` is false is walked over without a message.
void forEachGribField(std::string_view bytes, std::string const& file, std::function<bool(GribField const&)> const& wanted,
                      std::function<void(GribField const&)> const& take);
}  // namespace luftpost::weather
