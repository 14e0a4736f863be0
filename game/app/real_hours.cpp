#include "game/app/real_hours.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/source.h"

namespace luftpost::app {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::json;
constexpr double kOverGround = 350.0;   // m: a flight begins so high where the hour says nothing
constexpr double kLeastHeight = 120.0;  // m

/// A part of the file, and where it is: "hours[3].place".
struct Entry {
    Json const& json;
    fs::path const& file;
    std::string place;

    [[noreturn]] void refuse(std::string const& expected) const {
        throw core::Error{file.string(), place, fmt::format("expected {}, found {}", expected, json.is_structured() ? json.type_name() : json.dump())};
    }
    bool has(char const* key) const { return json.is_object() && json.contains(key); }
    Entry operator[](char const* key) const {
        if (!has(key)) refuse(fmt::format("an object with \"{}\"", key));
        return {json.at(key), file, place.empty() ? key : fmt::format("{}.{}", place, key)};
    }
    std::string text() const {
        if (!json.is_string() || json.get_ref<std::string const&>().empty()) refuse("a text");
        return json.get<std::string>();
    }
    double number(double least, double most) const {
        if (!json.is_number() || !(json.get<double>() >= least && json.get<double>() <= most)) refuse(fmt::format("a number {}..{}", least, most));
        return json.get<double>();
    }
    template <class Take>
    void each(Take take) const {
        if (!json.is_array()) refuse("a list");
        for (std::size_t i = 0; i < json.size(); ++i) take(Entry{json[i], file, fmt::format("{}[{}]", place, i)});
    }
};

fs::path recordingOf(Entry const& entry) {
    fs::path const file = entry.file.parent_path() / entry.text();
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) entry.refuse("a recording beside this file");
    return file;
}

RealHour hourOf(Entry const& entry) {
    RealHour hour;
    hour.name = entry["name"].text();
    hour.recording = recordingOf(entry["recording"]);
    auto const time = core::parseUtc(entry["time"].text());
    if (!time) entry["time"].refuse("a time like 2021-06-28T16:00Z");
    hour.time = *time;
    Entry const place = entry["place"];
    hour.placeName = place["name"].text();
    hour.place = {place["lat"].number(-90.0, 90.0), place["lon"].number(-180.0, 180.0), {}};
    if (place.has("altitude_m")) hour.place.altitude_m = place["altitude_m"].number(-500.0, 20000.0);
    if (entry.has("look")) hour.look_deg = glm::dvec2{entry["look"]["azimuth_deg"].number(-720.0, 720.0), entry["look"]["elevation_deg"].number(-90.0, 90.0)};
    hour.why = entry["why"].text();
    return hour;
}
}  // namespace

HoursFile readHours(fs::path const& given) {
    fs::path const file = fs::absolute(given);
    Json const json = Json::parse(core::readFile(file), nullptr, false);
    if (!json.is_object() || json.value("format", Json{}) != "luftpost-hours-1") throw core::Error{file.string(), "format", "expected a luftpost-hours-1 file"};
    Entry const whole{json, file, ""};
    HoursFile hours;
    whole["recordings"].each([&](Entry const& entry) { hours.recordings.push_back({recordingOf(entry["file"]), entry["why"].text()}); });
    whole["hours"].each([&](Entry const& entry) { hours.hours.push_back(hourOf(entry)); });
    return hours;
}

FlightPlan planFor(RealHour const& hour, FlightPlan plan) {
    plan.weather = {.source = "recorded:" + hour.recording.string()};
    weather::Field const field = weather::loadWeather(plan.weather.source, weather::PlaceWish{hour.place.lat_deg, hour.place.lon_deg, {}});
    plan.weatherSha256 = field.origin().sha256;
    plan.place = field.place();
    plan.simulation.time = hour.time;
    FlightStart& start = plan.simulation.start;
    start.runway = false;
    start.altitude = std::max(hour.place.altitude_m.value_or(plan.place.altitude_m + kOverGround), plan.place.altitude_m + kLeastHeight);
    if (hour.look_deg) start.heading = core::radians(hour.look_deg->x);
    return plan;
}
}  // namespace luftpost::app
