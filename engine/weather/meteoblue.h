// meteoblue: what a request asks for, and a body of its packages basic-1h and clouds-1h -> a recording. Model data.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "engine/weather/recording.h"

namespace luftpost::weather {
/// What meteoblueUrl takes as its base unless a setting names another.
inline constexpr std::string_view kMeteobluePackages = "https://my.meteoblue.com/packages/basic-1h_clouds-1h";

/// The request for one place with the user's own key; without an altitude (m above sea level) meteoblue takes the land's. Pure.
std::string meteoblueUrl(std::string const& base, std::string const& key, double lat_deg, double lon_deg, std::optional<double> altitude_m);

/// True for JSON that has the marks of such a body (also one that says what went wrong). Cheap, never throws.
bool looksLikeMeteoblue(std::string_view bytes);

/// Reads `data_1h`. Layers meet at 4 and 8 km; the total leaves cirrus out, so that no high cloud is ever concluded from it.
/// Throws core::Error: not such a body, with the place in it; an error body, with the provider's reason.
Recording parseMeteoblue(std::string_view bytes, std::string const& file);
}  // namespace luftpost::weather
