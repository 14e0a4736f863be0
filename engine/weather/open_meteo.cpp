#include "engine/weather/open_meteo.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/json_body.h"
#include "engine/weather/open_meteo_keys.h"
#include "engine/weather/report_parts.h"

namespace luftpost::weather {
namespace {
using Json = nlohmann::json;

constexpr double kMostVisible = 24140.0;     // m: where the models' visibility ends, 15 statute miles
constexpr double kCentimetresOfWater = 0.7;  // cm of fresh snow per mm of water (Open-Meteo's own 7 cm to 10 mm)
constexpr double kEarliest = -2208988800.0, kLatest = 4102444800.0;  // 1900 and 2100

/// One block ("hourly") of one place as columns by variable.
struct Block {
    std::string file;
    std::string place;  // "[3].hourly"
    std::vector<core::UtcSeconds> times;
    std::map<std::string, Column, std::less<>> columns;
    std::vector<std::string> models;  // that gave a column, the most knowing first; empty names left out

    std::optional<double> at(std::string_view variable, std::size_t i) const {
        auto const found = columns.find(variable);
        return found == columns.end() ? std::nullopt : found->second.at(i, file);
    }
};

/// All of a block: where it stands, its arrays and its units.
struct Raw {
    std::string const& file;
    std::string place;
    Json const& arrays;
    Json const& units;
};

std::string joined(std::string const& place, std::string_view part) { return place.empty() ? std::string{part} : fmt::format("{}.{}", place, part); }

Column columnOf(Raw const& raw, std::string const& key, OpenMeteoVariable const& row) {
    Column column{&raw.arrays.at(key), joined(raw.place, key), {}, row.range};
    auto const unit = raw.units.find(key);
    std::string const name = unit != raw.units.end() && unit->is_string() ? unit->get<std::string>() : "";
    auto const known = unitNamed(row.quantity, name);
    if (!known)
        throw core::Error(raw.file, joined(raw.place + "_units", key),
                          fmt::format("expected a unit ({}), found \"{}\"", unitNames(row.quantity), oneLine(name, 40)));
    column.unit = *known;
    return column;
}

/// The models by how many figures they know, the most first.
std::vector<std::string> rankedModels(Raw const& raw, std::vector<std::pair<std::string, OpenMeteoKey>> const& keys) {
    std::map<std::string, std::ptrdiff_t> known;
    for (auto const& [key, parts] : keys)
        known[parts.model] += std::count_if(raw.arrays.at(key).begin(), raw.arrays.at(key).end(), [](Json const& value) { return !value.is_null(); });
    std::vector<std::string> models;
    for (auto const& [model, count] : known) models.push_back(model);
    std::stable_sort(models.begin(), models.end(), [&](auto const& a, auto const& b) { return known[a] > known[b]; });
    return models;
}

void addColumns(Raw const& raw, Block& block) {
    std::vector<std::pair<std::string, OpenMeteoKey>> keys;
    for (auto const& [key, values] : raw.arrays.items())
        if (auto parts = openMeteoKey(key)) {
            checkArray(values, block.times.size(), raw.file, joined(raw.place, key));
            if (knowsAnything(values)) keys.emplace_back(key, std::move(*parts));
        }
    std::set<std::string> used;
    auto const models = rankedModels(raw, keys);
    for (std::string const& model : models)
        for (auto const& [key, parts] : keys)
            if (parts.model == model && !block.columns.contains(parts.variable)) {
                block.columns[parts.variable] = columnOf(raw, key, parts.row);
                used.insert(model);
            }
    for (std::string const& model : models)
        if (!model.empty() && used.contains(model)) block.models.push_back(model);
}

core::UtcSeconds timeOf(Json const& json, double offset, std::string const& file, std::string const& place) {
    if (json.is_number_integer()) {
        auto const time = json.get<double>();
        if (time >= kEarliest && time <= kLatest) return time;
    } else if (json.is_string()) {
        // Local by the body's own offset, which stays the same over a change to summer time.
        if (auto const local = core::parseUtc(json.get<std::string>() + "Z")) return *local - offset;
    }
    throw core::Error(file, place, "expected seconds since 1970 or a local time such as \"2024-01-16T09:00\"");
}

std::vector<core::UtcSeconds> timesOf(Json const& json, double offset, std::string const& file, std::string const& place) {
    if (!json.is_array() || json.empty()) throw core::Error(file, place, "expected an array of times");
    if (json.size() > kMostReports) throw core::Error(file, place, fmt::format("expected at most {} times, found {}", kMostReports, json.size()));
    std::vector<core::UtcSeconds> times;
    for (std::size_t i = 0; i < json.size(); ++i) {
        times.push_back(timeOf(json[i], offset, file, fmt::format("{}[{}]", place, i)));
        if (i > 0 && times[i] <= times[i - 1]) throw core::Error(file, fmt::format("{}[{}]", place, i), "expected a time after the one before");
    }
    return times;
}

/// The step that a sum, mean or maximum at time i is of: since the time before; the first is like the second.
double stepBefore(std::vector<core::UtcSeconds> const& times, std::size_t i, double single) {
    if (times.size() < 2) return single;
    return i == 0 ? times[1] - times[0] : times[i] - times[i - 1];
}

/// What fell, by the sums of its kinds, and by the code where they say nothing or it knows better.
std::optional<Precipitation> kindOf(Block const& block, std::size_t i, double water, std::optional<int> code) {
    if (water <= 0.0) return Precipitation::None;
    auto const rain = block.at("rain", i), showers = block.at("showers", i), snow = block.at("snowfall", i);
    bool const rains = rain.value_or(0.0) + showers.value_or(0.0) > 0.0, snows = snow.value_or(0.0) > 0.0;
    bool const freezes = code && (*code == 56 || *code == 57 || *code == 66 || *code == 67), drizzles = code && *code >= 51 && *code <= 55;
    if (rains && snows) return Precipitation::Sleet;
    if (snows) return Precipitation::Snow;
    if (freezes) return Precipitation::FreezingRain;
    if (drizzles) return Precipitation::Drizzle;
    if (rains) return Precipitation::Rain;
    return std::nullopt;
}

/// Millimetres of water in the step: the sum that is given, else of its three parts if all are known.
std::optional<double> waterOf(Block const& block, std::size_t i) {
    if (auto const sum = block.at("precipitation", i)) return sum;
    auto const rain = block.at("rain", i), showers = block.at("showers", i), snow = block.at("snowfall", i);
    if (!rain || !showers || !snow) return std::nullopt;
    return *rain + *showers + *snow * 100.0 / kCentimetresOfWater;
}

void addFall(Block const& block, std::size_t i, double step, Report& report) {
    if (auto const code = block.at("weather_code", i)) {
        report.weatherCode = static_cast<int>(*code);
        report.thunder = *report.weatherCode >= 95;
    }
    if (auto const water = waterOf(block, i)) {
        report.rate_mm_h = std::min(*water * 3600.0 / step, kRate.high);
        report.precipitationKind = kindOf(block, i, *water, report.weatherCode);
    }
    report.radiation_w_m2 = block.at("shortwave_radiation", i);
    if (report.rate_mm_h || report.gust_mps || report.radiation_w_m2) report.interval_s = step;
}

void addSky(Block const& block, std::size_t i, Report& report) {
    report.coverLow = block.at("cloud_cover_low", i);
    report.coverMid = block.at("cloud_cover_mid", i);
    report.coverHigh = block.at("cloud_cover_high", i);
    report.coverTotal = block.at("cloud_cover", i);
    report.visibility_m = block.at("visibility", i);
    report.visibilityIsMinimum = report.visibility_m && std::abs(*report.visibility_m - kMostVisible) < 1.0;
    report.cape_j_kg = block.at("cape", i);
    report.freezingLevel_m = block.at("freezing_level_height", i);
    report.snowDepth_m = block.at("snow_depth", i);
}

/// "80m" and "850hPa", every height of which the block knows something.
std::set<std::string> heightsOf(Block const& block) {
    std::set<std::string> heights;
    for (auto const& [variable, column] : block.columns) {
        auto const digits = variable.find_last_of('_');
        std::string const height = digits == variable.npos ? "" : variable.substr(digits + 1);
        if (!height.empty() && height.front() >= '0' && height.front() <= '9' && height != "2m" && height != "10m") heights.insert(height);
    }
    return heights;
}

/// One height; nothing where its altitude is not known or nothing is said of it.
std::optional<ReportedLevel> levelOf(Block const& block, std::size_t i, std::string const& height, std::optional<double> elevation) {
    auto const at = [&](char const* stem) { return block.at(fmt::format("{}_{}", stem, height), i); };
    double metres = 0.0;
    auto const [end, error] = std::from_chars(height.data(), height.data() + height.size(), metres);
    std::optional<double> altitude = at("geopotential_height");
    if (error == std::errc{} && std::string_view{end} == "m") altitude = elevation ? std::optional{*elevation + metres} : std::nullopt;
    if (!altitude) return std::nullopt;
    ReportedLevel level{*altitude, at("temperature"), at("dew_point"), {}, {}, at("cloud_cover")};
    if (!level.dew_point_c) level.dew_point_c = dewPoint_c(level.temperature_c, at("relative_humidity"));
    setWind(at("wind_speed"), at("wind_direction"), level.speed_mps, level.from_deg);
    bool const said = level.temperature_c || level.dew_point_c || level.speed_mps || level.cover;
    return said ? std::optional{level} : std::nullopt;
}

Report reportOf(Block const& block, std::size_t i, double single, std::set<std::string> const& heights, std::optional<double> elevation) {
    Report report;
    report.time = block.times[i];
    setWind(block.at("wind_speed_10m", i), block.at("wind_direction_10m", i), report.speed_mps, report.from_deg);
    report.gust_mps = block.at("wind_gusts_10m", i);
    report.temperature_c = block.at("temperature_2m", i);
    report.dew_point_c = block.at("dew_point_2m", i);
    if (!report.dew_point_c) report.dew_point_c = dewPoint_c(report.temperature_c, block.at("relative_humidity_2m", i));
    report.pressure_hpa = block.at("pressure_msl", i);
    auto const station = block.at("surface_pressure", i);
    if (!report.pressure_hpa && station && elevation)
        fillSeaPressure(report, *station, *elevation, block.file, fmt::format("{}[{}]", joined(block.place, "surface_pressure"), i));
    addFall(block, i, stepBefore(block.times, i, single), report);
    addSky(block, i, report);
    for (std::string const& height : heights)
        if (auto const level = levelOf(block, i, height, elevation)) report.levels.push_back(*level);
    orderLevels(report.levels, elevation.value_or(kAltitude.low) + 10.0);
    return report;
}

/// `current` as arrays of one, so that it reads as the others do.
Json asArrays(Json const& current) {
    Json arrays = Json::object();
    for (auto const& [key, value] : current.items()) arrays[key] = Json::array({value});
    return arrays;
}

/// The finest block that says most: hourly, else minutely_15, else current.
std::string_view blockName(Json const& body, std::string const& file, std::string const& place) {
    for (std::string_view const name : {"hourly", "minutely_15", "current"})
        if (auto const found = body.find(name); found != body.end() && !found->is_null()) {
            if (!found->is_object()) throw core::Error(file, joined(place, name), "expected an object");
            return name;
        }
    throw core::Error(file, place, "expected hourly, minutely_15 or current values of Open-Meteo");
}

Site siteOf(Json const& body, std::string const& file, std::string const& place, std::set<std::string>& models) {
    if (!body.is_object()) throw core::Error(file, place, "expected an object for each place");
    Site site;
    site.lat_deg = requiredNumber(body, "latitude", kLatitude, file, place);
    site.lon_deg = requiredNumber(body, "longitude", kLongitude, file, place);
    site.elevation_m = optionalNumber(body, "elevation", kElevation, file, place);
    site.name = coordinateName(*site.lat_deg, *site.lon_deg);
    double const offset = optionalNumber(body, "utc_offset_seconds", {-86400.0, 86400.0}, file, place).value_or(0.0);
    std::string_view const name = blockName(body, file, place);
    bool const current = name == "current";
    Json const held = current ? asArrays(body.at(name)) : Json();
    Json const none = Json::object();
    auto const units = body.find(std::string{name} + "_units");
    Raw const raw{file, joined(place, name), current ? held : body.at(name), units != body.end() && units->is_object() ? *units : none};
    auto const time = raw.arrays.find("time");
    if (time == raw.arrays.end()) throw core::Error(file, raw.place, "expected the key \"time\"");
    Block block{file, raw.place, timesOf(*time, offset, file, joined(raw.place, "time")), {}, {}};
    addColumns(raw, block);
    double single = 3600.0;  // s: what one lone figure is the sum of
    if (current) single = optionalNumber(body.at(name), "interval", kInterval, file, raw.place).value_or(single);
    auto const heights = heightsOf(block);
    for (std::size_t i = 0; i < block.times.size(); ++i) site.reports.push_back(reportOf(block, i, single, heights, site.elevation_m));
    keepWhatSpeaks(site.reports);
    if (site.reports.empty()) throw core::Error(file, raw.place, "expected at least one hour with a value that is read here");
    models.insert(block.models.begin(), block.models.end());
    return site;
}

void refuseError(Json const& json, std::string const& file) {
    if (!json.is_object()) return;
    auto const error = json.find("error");
    if (error == json.end() || !error->is_boolean() || !error->get<bool>()) return;
    auto const reason = json.find("reason");
    std::string const text = reason != json.end() && reason->is_string() ? oneLine(reason->get<std::string>()) : "no reason given";
    throw core::Error(file, "error", "expected weather, Open-Meteo says: " + text);
}
}  // namespace

bool looksLikeOpenMeteo(std::string_view bytes) {
    auto const first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos || (bytes[first] != '{' && bytes[first] != '[')) return false;
    auto const has = [bytes](std::string_view mark) { return bytes.find(mark) != bytes.npos; };
    if (has("\"luftpost-weather-1\"")) return false;
    return has("\"generationtime_ms\"") || (has("\"latitude\"") && (has("\"hourly\"") || has("\"minutely_15\"") || has("\"current\""))) ||
           (has("\"error\"") && has("\"reason\""));
}

Recording parseOpenMeteo(std::string_view bytes, std::string const& file) {
    Json const json = parseJson(bytes, file, "a body of Open-Meteo");
    refuseError(json, file);
    bool const several = json.is_array();
    if (several && json.empty()) throw core::Error(file, "", "expected at least one place");
    if (several && json.size() > kMostSites)
        throw core::Error(file, "", fmt::format("expected at most {} places, found {}", kMostSites, json.size()));
    Recording recording;
    std::set<std::string> models;
    for (std::size_t i = 0; i < (several ? json.size() : 1); ++i) {
        recording.sites.push_back(several ? siteOf(json[i], file, fmt::format("[{}]", i), models) : siteOf(json, file, "", models));
        checkCounts(recording.sites, file);
    }
    Site const& first = recording.sites.front();
    recording.file = file;
    recording.name = fmt::format("Open-Meteo {}{}, {}", first.name, several ? fmt::format(" and {} more", json.size() - 1) : "",
                                 dayName(first.reports.front().time));
    recording.source = "Open-Meteo (model data)";
    for (std::string const& model : models) recording.source += (model == *models.begin() ? ": " : ", ") + oneLine(model, 60);
    recording.licence = "CC BY 4.0, Weather data by Open-Meteo.com";
    recording.sha256 = sha256Hex(bytes);
    return recording;
}
}  // namespace luftpost::weather
