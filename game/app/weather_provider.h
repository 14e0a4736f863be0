// Who gives live weather, and one request to one of them.
#pragma once
#include <algorithm>
#include <atomic>
#include <optional>
#include <string>

#include "engine/core/environment.h"
#include "engine/platform/http.h"
#include "engine/weather/recording.h"
#include "game/app/weather_settings.h"

namespace luftpost::app {
/// What a player has to know of a provider.
struct ProviderFacts {
    std::string_view name, attribution, limits;
    int shortestInterval = 0;  // s, between requests to the provider's own server
};
ProviderFacts const& factsOf(WeatherProvider provider);

/// Where weather is asked for.
struct FeedPlace {
    double lat_deg = 0.0, lon_deg = 0.0;
};
/// m, along the ground.
double distance(FeedPlace const& a, FeedPlace const& b);

/// An answer that became weather.
struct WeatherNews {
    std::string recording;             // text in our format
    core::UtcSeconds lastReport = 0.0; // of all its sites; of a forecast in the future
    FeedPlace place;

    /// The time that it is weather of when it was asked for at `asked`: a report is good for an hour, no longer.
    core::UtcSeconds givenAt(core::UtcSeconds asked) const { return std::min(asked, lastReport + 3600.0); }
};

/// What a server says to make the next request cheaper.
struct Validators {
    std::string etag, lastModified, url;
};

core::UtcSeconds lastReport(weather::Recording const& recording);

/// How a request went.
struct Fetched {
    std::optional<WeatherNews> news;
    bool unchanged = false;              // what is known is still true
    std::string error;                   // one line for player and log, without any key; empty: all is well
    bool refused = false;                // the server wants another request, not the same again soon (4xx)
    std::optional<double> retryAfter_s;
};

/// One request, and all that comes is read (weather::parseSource). Blocks at most the time-out and the reading. `validators` are
/// sent when they are of the same address, and renewed. Any thread; never throws.
Fetched fetchWeather(WeatherSettings const& settings, FeedPlace const& place, core::UtcSeconds now, Validators& validators,
                     std::atomic<bool> const& abort);

/// Older than two intervals: no longer live.
bool isStale(core::UtcSeconds given, core::UtcSeconds now, WeatherSettings const& settings);

/// Seconds between two requests as settings and provider have it: its limit does not bind another server in its place.
double intervalOf(WeatherSettings const& settings);
}  // namespace luftpost::app
