// The weather of a recording at one place over its whole length, as the panel's strip draws it, and its moments worth a visit.
// Pure functions; making one asks the field at a few hundred times: do it when the source changes, not each frame.
#pragma once
#include <string>
#include <vector>

#include "engine/weather/field.h"

namespace luftpost::ui {
/// The weather of one column's middle; rain, gust and thunder are the strongest within it.
struct StripColumn {
    core::UtcSeconds time = 0.0;
    double low = 0.0, mid = 0.0, high = 0.0;  // 0..1, cover by level, random overlap within one
    bool fog = false, storm = false;          // fog or cumulonimbus among the low cloud
    weather::Precipitation kind = weather::Precipitation::None;
    double rain = 0.0;           // mm/h
    glm::dvec2 wind{0.0};        // m/s, east and north, where the air goes to, 10 m above ground
    double gust = 0.0;           // m/s
    double temperature_c = 0.0;
    bool thunder = false;
    bool night = false;          // the sun is below the horizon
};

/// An hour to jump to.
struct StripMoment {
    core::UtcSeconds time = 0.0;
    std::string name;  // "front", "thunder", "gust 22 m/s", "rain 12 mm/h"
};

struct WeatherStrip {
    core::UtcSeconds start = 0.0, end = 0.0;
    std::vector<StripColumn> columns;   // ascending, equal steps
    std::vector<StripMoment> moments;   // ascending, at most kMostMoments
};
inline constexpr std::size_t kMostMoments = 5;

/// The strip over the field's own length at a place (m east and north of the origin).
WeatherStrip weatherStrip(weather::Field const& field, glm::dvec2 eastNorth, int columns);
}  // namespace luftpost::ui
