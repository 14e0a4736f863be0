#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "engine/core/check.h"
#include "engine/weather/open_meteo.h"

namespace luftpost::weather {
namespace {
constexpr int kHoursBefore = 6, kHoursAfter = 24;
constexpr std::array kSurface{"temperature_2m",    "dew_point_2m",    "precipitation",       "rain",           "showers",
                              "snowfall",          "snow_depth",      "weather_code",        "pressure_msl",   "cloud_cover",
                              "cloud_cover_low",   "cloud_cover_mid", "cloud_cover_high",    "visibility",     "wind_speed_10m",
                              "wind_direction_10m", "wind_gusts_10m", "cape",                "freezing_level_height", "shortwave_radiation"};
constexpr std::array kHeights_m{80, 120, 180};
constexpr std::array kLevels_hpa{1000, 975, 950, 925, 900, 850, 800, 700, 600, 500, 400, 300, 250, 200};
constexpr std::array kAtLevels{"temperature", "relative_humidity", "cloud_cover", "wind_speed", "wind_direction", "geopotential_height"};

std::vector<std::string> variables() {
    std::vector<std::string> names{kSurface.begin(), kSurface.end()};
    for (int const height : kHeights_m)
        for (char const* stem : {"temperature", "wind_speed", "wind_direction"}) names.push_back(fmt::format("{}_{}m", stem, height));
    for (int const level : kLevels_hpa)
        for (char const* stem : kAtLevels) names.push_back(fmt::format("{}_{}hPa", stem, level));
    return names;
}
}  // namespace

std::string openMeteoUrl(std::string const& base, double lat_deg, double lon_deg) {
    CHECK(std::isfinite(lat_deg) && std::isfinite(lon_deg), "place {} {}", lat_deg, lon_deg);
    return fmt::format("{}{}latitude={:.4f}&longitude={:.4f}&timeformat=unixtime&wind_speed_unit=ms&past_hours={}&forecast_hours={}&hourly={}", base,
                       base.find('?') == base.npos ? '?' : '&', lat_deg, lon_deg, kHoursBefore, kHoursAfter, fmt::join(variables(), ","));
}
}  // namespace luftpost::weather
