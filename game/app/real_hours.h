// Hours worth seeing: entries of assets/weather/hours.json ("luftpost-hours-1"), each a recording with a moment, a place and a reason.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/weather/field.h"
#include "game/app/flight_plan.h"

namespace luftpost::app {
struct RealHour {
    std::string name;
    std::filesystem::path recording;  // absolute
    core::UtcSeconds time = 0.0;
    std::string placeName;
    weather::PlaceWish place;                 // its altitude, if any, is the eye's
    std::optional<glm::dvec2> look_deg;       // azimuth clockwise from true north, elevation
    std::string why;
};

/// A recording that is offered in the menu, and why.
struct BundledRecording {
    std::filesystem::path file;  // absolute
    std::string why;
};

struct HoursFile {
    std::vector<BundledRecording> recordings;
    std::vector<RealHour> hours;
};

inline constexpr std::string_view kHoursFile = "assets/weather/hours.json";

/// Recordings are named as they lie beside the file. Throws core::Error naming file, place in it and what was expected; a
/// recording that is not there is refused.
HoursFile readHours(std::filesystem::path const& file);

/// The flight that begins at this hour in the air, looking where the hour looks; aircraft, settings and seed stay those of `before`. Throws core::Error where the
/// recording does not load.
FlightPlan planFor(RealHour const& hour, FlightPlan before);
}  // namespace luftpost::app
