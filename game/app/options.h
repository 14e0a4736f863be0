// Reading texts of the command line. All throw core::Error{OPTION, "", "expected ..., found ..."}: one line,
// exit 2.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "engine/core/environment.h"
#include "engine/core/frames.h"

namespace luftpost::app {
/// A finite number min..max.
double numberOption(std::string_view option, std::string_view text, double min, double max);
/// A whole number min..max.
long long wholeOption(std::string_view option, std::string_view text, long long min, long long max);
/// Numbers separated by commas, as many as min..max of them, all finite. `form` is what is expected
/// ("LAT,LON").
std::vector<double> numbersOption(std::string_view option, std::string_view text, std::size_t minCount,
                                  std::size_t maxCount, std::string_view form);
/// "1280x720", each 1..16384.
glm::ivec2 sizeOption(std::string_view option, std::string_view text);
/// ISO 8601 UTC.
core::UtcSeconds timeOption(std::string_view option, std::string_view text);

/// Threads for a tool that has the machine to itself: one for each core, 1..32.
int toolWorkers();

/// A place of the command line; without an altitude the command takes the nearest site's elevation.
struct PlaceOption {
    double lat_deg = 0.0;
    double lon_deg = 0.0;
    std::optional<double> altitude_m;
};
PlaceOption placeOption(std::string_view option, std::string_view text);
}  // namespace luftpost::app
