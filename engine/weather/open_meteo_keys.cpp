#include "engine/weather/open_meteo_keys.h"

#include <array>
#include <utility>

namespace luftpost::weather {
namespace {
constexpr Range kHumidity{0.0, 1.2}, kWater{0.0, 2000.0}, kSnowfall{0.0, 20.0}, kStationPressure{300.0, 1100.0};

/// One figure an hour. Longer names stand before those that they begin with.
constexpr std::array kVariables{
    OpenMeteoVariable{"temperature_2m", Quantity::Temperature, kTemperature},
    OpenMeteoVariable{"relative_humidity_2m", Quantity::Share, kHumidity},
    OpenMeteoVariable{"dew_point_2m", Quantity::Temperature, kDewPoint},
    OpenMeteoVariable{"precipitation", Quantity::Water, kWater},
    OpenMeteoVariable{"rain", Quantity::Water, kWater},
    OpenMeteoVariable{"showers", Quantity::Water, kWater},
    OpenMeteoVariable{"snowfall", Quantity::Length, kSnowfall},
    OpenMeteoVariable{"snow_depth", Quantity::Length, kSnowDepth},
    OpenMeteoVariable{"weather_code", Quantity::Code, kWeatherCode},
    OpenMeteoVariable{"pressure_msl", Quantity::Pressure, kPressure},
    OpenMeteoVariable{"surface_pressure", Quantity::Pressure, kStationPressure},
    OpenMeteoVariable{"cloud_cover_low", Quantity::Share, kCover},
    OpenMeteoVariable{"cloud_cover_mid", Quantity::Share, kCover},
    OpenMeteoVariable{"cloud_cover_high", Quantity::Share, kCover},
    OpenMeteoVariable{"cloud_cover", Quantity::Share, kCover},
    OpenMeteoVariable{"visibility", Quantity::Length, kVisibility},
    OpenMeteoVariable{"wind_speed_10m", Quantity::Speed, kSpeed},
    OpenMeteoVariable{"wind_direction_10m", Quantity::Direction, kDegrees},
    OpenMeteoVariable{"wind_gusts_10m", Quantity::Speed, kSpeed},
    OpenMeteoVariable{"cape", Quantity::Energy, kCape},
    OpenMeteoVariable{"freezing_level_height", Quantity::Length, kFreezingLevel},
    OpenMeteoVariable{"shortwave_radiation", Quantity::Flux, kRadiation},
};

/// A variable of many heights: "wind_speed_850hPa", "temperature_80m".
constexpr std::array kStems{
    OpenMeteoVariable{"temperature", Quantity::Temperature, kTemperature},
    OpenMeteoVariable{"relative_humidity", Quantity::Share, kHumidity},
    OpenMeteoVariable{"dew_point", Quantity::Temperature, kDewPoint},
    OpenMeteoVariable{"cloud_cover", Quantity::Share, kCover},
    OpenMeteoVariable{"wind_speed", Quantity::Speed, kSpeed},
    OpenMeteoVariable{"wind_direction", Quantity::Direction, kDegrees},
    OpenMeteoVariable{"geopotential_height", Quantity::Length, kAltitude},
};

/// How the API spelt its variables until October 2023.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kOldSpelling{{
    {"relativehumidity", "relative_humidity"},
    {"dewpoint", "dew_point"},
    {"windspeed", "wind_speed"},
    {"winddirection", "wind_direction"},
    {"windgusts", "wind_gusts"},
    {"cloudcover", "cloud_cover"},
    {"weathercode", "weather_code"},
    {"freezinglevel", "freezing_level"},
}};

/// What may follow a variable's name without being a model: another variable that begins with the same words.
constexpr std::array<std::string_view, 12> kNotModels{"probability", "height", "water", "instant", "type",   "hours",
                                                      "previous",    "sum",    "max",   "min",     "spread", "anomaly"};

std::string spelling(std::string_view key) {
    for (auto const& [old, now] : kOldSpelling)
        if (key.starts_with(old)) return std::string{now} + std::string{key.substr(old.size())};
    return std::string{key};
}

/// What stands behind a name: nothing, or "_model".
std::optional<std::string> modelOf(std::string_view rest) {
    if (rest.empty()) return "";
    if (rest.size() < 2 || rest.front() != '_') return std::nullopt;
    rest.remove_prefix(1);
    if (rest.front() >= '0' && rest.front() <= '9') return std::nullopt;
    for (std::string_view const word : kNotModels)
        if (rest.starts_with(word)) return std::nullopt;
    return std::string{rest};
}

/// "_850hPa" or "_80m" at the front of what stands behind a stem; `rest` loses it.
bool takeHeight(std::string_view& rest) {
    std::size_t i = 1;
    while (i < rest.size() && rest[i] >= '0' && rest[i] <= '9') ++i;
    if (rest.empty() || rest.front() != '_' || i == 1 || i > 5) return false;
    std::string_view const unit = rest.substr(i);
    std::size_t const length = unit.starts_with("hPa") ? 3 : unit.starts_with("m") ? 1 : 0;
    if (length == 0) return false;
    rest = unit.substr(length);
    return true;
}
}  // namespace

std::optional<OpenMeteoKey> openMeteoKey(std::string_view key) {
    std::string const spelt = spelling(key);
    for (OpenMeteoVariable const& variable : kVariables)
        if (spelt.starts_with(variable.name))
            if (auto model = modelOf(std::string_view{spelt}.substr(variable.name.size())))
                return OpenMeteoKey{std::string{variable.name}, variable, std::move(*model)};
    for (OpenMeteoVariable const& stem : kStems) {
        if (!spelt.starts_with(stem.name)) continue;
        std::string_view rest = std::string_view{spelt}.substr(stem.name.size());
        if (!takeHeight(rest)) continue;
        if (auto model = modelOf(rest)) return OpenMeteoKey{spelt.substr(0, spelt.size() - rest.size()), stem, std::move(*model)};
    }
    return std::nullopt;
}
}  // namespace luftpost::weather
