// Live weather: whether, from whom, how often.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include "engine/core/settings.h"
#include "engine/weather/meteoblue.h"
#include "engine/weather/open_meteo.h"

namespace luftpost::app {
enum class WeatherProvider { openMeteo, metar, meteoblue };
inline constexpr std::array<std::string_view, 3> kProviderWords{"open-meteo", "metar", "meteoblue"};
enum class CacheUse { window, always, never };
inline constexpr std::array<std::string_view, 3> kCacheWords{"window", "always", "never"};

/// Not of the flight: what a feed brings enters the flight as an input.
struct WeatherSettings {
    bool live = false;
    WeatherProvider provider = WeatherProvider::openMeteo;
    int interval = 900;     // s
    float timeout = 20.0f;  // s
    CacheUse cache = CacheUse::window;
    std::string openMeteoUrl{weather::kOpenMeteoForecast};
    std::string metarUrl{"https://aviationweather.gov/api/data/metar"};
    std::string meteoblueUrl{weather::kMeteobluePackages};
    std::string meteoblueKey;
    bool operator==(WeatherSettings const&) const = default;
};
inline constexpr std::tuple weatherFields{
    core::Field{&WeatherSettings::live, "weather.live", "Fetch the weather of now over the network (as --weather live does)"},
    core::Field{&WeatherSettings::provider, "weather.provider", kProviderWords,
                "Where live weather comes from: a model at the aircraft's place (open-meteo), stations around it (metar), a model with a key (meteoblue)"},
    core::Field{&WeatherSettings::interval, "weather.interval_s", 1, 21600,
                "Seconds between two requests (never more often than the provider's limit below)"},
    core::Field{&WeatherSettings::timeout, "weather.timeout_s", 0.1f, 120.0f, "Seconds after which a request is given up"},
    core::Field{&WeatherSettings::cache, "weather.cache", kCacheWords,
                "Keep the last answer on disk for the next start: with a window only, always, never"},
    core::Field{&WeatherSettings::openMeteoUrl, "weather.openMeteoUrl", "Address of Open-Meteo's forecast, or of a server that answers like it"},
    core::Field{&WeatherSettings::metarUrl, "weather.metarUrl", "Address of the METAR service of aviationweather.gov, or of a server that answers like it"},
    core::Field{&WeatherSettings::meteoblueUrl, "weather.meteoblueUrl", "Address of meteoblue's packages, or of a server that answers like it"},
    core::Field{&WeatherSettings::meteoblueKey, "weather.meteoblueKey", "The player's own key for meteoblue; shown nowhere else and written to no other file"}};

/// A value that no log, report or list may show.
inline bool isSecret(std::string_view key) { return key == "weather.meteoblueKey"; }
}  // namespace luftpost::app
