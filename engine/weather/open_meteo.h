// Open-Meteo: what a request asks for, and a body of its forecast or archive -> a recording. Model data.
#pragma once
#include <string>
#include <string_view>

#include "engine/weather/recording.h"

namespace luftpost::weather {
/// What openMeteoUrl takes as its base unless a setting names another.
inline constexpr std::string_view kOpenMeteoForecast = "https://api.open-meteo.com/v1/forecast";

/// The request for the weather over one place from 6 hours before now to 24 hours after: unixtime, m/s, and every variable that
/// parseOpenMeteo reads, pressure levels from 1000 to 200 hPa among them. `base` is the endpoint without a query, or with one that
/// is to be kept ("...?apikey=KEY"). Pure.
std::string openMeteoUrl(std::string const& base, double lat_deg, double lon_deg);

/// True for JSON that has the marks of such a body (also one that says what went wrong). Cheap, never throws.
bool looksLikeOpenMeteo(std::string_view bytes);

/// Reads `hourly`, else `minutely_15`, else `current`. One place or several; units and times in whatever way they were asked for.
/// Of several models each quantity is taken from the first that knows it, the one with the most values first: one site a place.
/// Sums, means and maxima are those of the step before each time (`interval_s`). An hour of which nothing is known is left out.
/// Throws core::Error: not such a body, with the place in it; an error body, with the provider's reason.
Recording parseOpenMeteo(std::string_view bytes, std::string const& file);
}  // namespace luftpost::weather
