#include "engine/weather/meteoblue.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/json_body.h"
#include "engine/weather/report_parts.h"

namespace luftpost::weather {
namespace {
using Json = nlohmann::json;

constexpr CoverBounds kBounds{4000.0, 8000.0};
constexpr double kHour = 3600.0;
constexpr double kEarliest = -2208988800.0, kLatest = 4102444800.0;  // 1900 and 2100
constexpr Range kHumidity{0.0, 1.2}, kWater{0.0, 2000.0}, kPictocode{0.0, 100.0};

/// A field of `data_1h`, the key of its unit, and the unit where the API has no choice and may not name it.
struct Variable {
    std::string_view name, unitKey;
    Quantity quantity;
    Range range;
    std::string_view onlyUnit;
};
constexpr std::array kVariables{
    Variable{"temperature", "temperature", Quantity::Temperature, kTemperature, ""},
    Variable{"windspeed", "windspeed", Quantity::Speed, kSpeed, ""},
    Variable{"gust", "windspeed", Quantity::Speed, kSpeed, ""},
    Variable{"winddirection", "winddirection", Quantity::Direction, kDegrees, "degree"},
    Variable{"precipitation", "precipitation", Quantity::Water, kWater, ""},
    Variable{"snowfraction", "snowfraction", Quantity::Code, kCover, ""},
    Variable{"relativehumidity", "relativehumidity", Quantity::Share, kHumidity, "percent"},
    Variable{"sealevelpressure", "pressure", Quantity::Pressure, kPressure, "hPa"},
    Variable{"pictocode", "pictocode", Quantity::Code, kPictocode, ""},
    Variable{"lowclouds", "cloudcover", Quantity::Share, kCover, "percent"},
    Variable{"midclouds", "cloudcover", Quantity::Share, kCover, "percent"},
    Variable{"highclouds", "cloudcover", Quantity::Share, kCover, "percent"},
    Variable{"totalcloudcover", "cloudcover", Quantity::Share, kCover, "percent"},
    Variable{"visibility", "visibility", Quantity::Length, kVisibility, "m"},
};

struct Hours {
    std::string const& file;
    std::vector<core::UtcSeconds> times;
    std::map<std::string_view, Column> columns;

    std::optional<double> at(std::string_view name, std::size_t i) const {
        auto const found = columns.find(name);
        return found == columns.end() ? std::nullopt : found->second.at(i, file);
    }
};

Column columnOf(Json const& values, Json const& units, Variable const& variable, std::string const& file) {
    Column column{&values, fmt::format("data_1h.{}", variable.name), {}, variable.range};
    auto const unit = units.find(variable.unitKey);
    std::string name{variable.onlyUnit};
    if (unit != units.end() && unit->is_string()) name = unit->get<std::string>();
    auto const known = unitNamed(variable.quantity, name);
    if (!known)
        throw core::Error(file, fmt::format("units.{}", variable.unitKey),
                          fmt::format("expected a unit ({}), found \"{}\"", unitNames(variable.quantity), oneLine(name, 40)));
    column.unit = *known;
    return column;
}

/// "+02:00" or "+0200" behind a time, in seconds.
std::optional<double> offsetOf(std::string_view text) {
    if (text == "Z") return 0.0;
    std::string digits;
    for (char const c : text.substr(std::min<std::size_t>(1, text.size())))
        if (c != ':') digits += c;
    bool const sane = digits.size() == 4 && digits.find_first_not_of("0123456789") == digits.npos && (text.front() == '+' || text.front() == '-');
    if (!sane) return std::nullopt;
    double const minutes = 60.0 * std::stod(digits.substr(0, 2)) + std::stod(digits.substr(2));
    return (text.front() == '-' ? -60.0 : 60.0) * minutes;
}

/// A time in any of the three formats; `local` is set where it carries no offset of its own.
std::optional<core::UtcSeconds> timeOf(Json const& json, double offset, bool& local) {
    local = false;
    if (json.is_number_integer()) {
        auto time = json.get<double>();
        if (std::abs(time) > 1e11) time /= 1000.0;  // milliseconds: as seconds that would be the year 5138
        return time >= kEarliest && time <= kLatest ? std::optional{std::floor(time)} : std::nullopt;
    }
    if (!json.is_string()) return std::nullopt;
    auto text = json.get<std::string>();
    if (text.size() < 16) return std::nullopt;
    if (text[10] == ' ') text[10] = 'T';
    local = text.size() == 16;
    std::size_t const clock = text.size() >= 19 && text[16] == ':' ? 19 : 16;  // seconds or none
    auto const own = local ? std::optional{offset} : offsetOf(std::string_view{text}.substr(clock));
    auto const time = core::parseUtc(text.substr(0, clock) + "Z");
    if (!own || !time) return std::nullopt;
    return *time - *own;
}

/// Local times step by no or two hours where summer time ends or begins: an hour all the same.
std::vector<core::UtcSeconds> timesOf(Json const& json, double offset, std::string const& file) {
    if (!json.is_array() || json.empty()) throw core::Error(file, "data_1h.time", "expected an array of times");
    if (json.size() > kMostReports)
        throw core::Error(file, "data_1h.time", fmt::format("expected at most {} times, found {}", kMostReports, json.size()));
    std::vector<core::UtcSeconds> times;
    double shift = 0.0;
    for (std::size_t i = 0; i < json.size(); ++i) {
        std::string const place = fmt::format("data_1h.time[{}]", i);
        bool local = false;
        auto time = timeOf(json[i], offset, local);
        if (!time)
            throw core::Error(file, place, "expected a time such as \"2026-04-20 00:00\", \"2026-04-20T00:00+02:00\" or milliseconds since 1970");
        *time += shift;
        if (local && i > 0 && (*time == times[i - 1] || *time == times[i - 1] + 2.0 * kHour)) {
            shift += times[i - 1] + kHour - *time;
            *time = times[i - 1] + kHour;
        }
        if (i > 0 && *time <= times[i - 1]) throw core::Error(file, place, "expected a time after the one before");
        times.push_back(*time);
    }
    return times;
}

/// The share that falls as snow tells the kind.
std::optional<Precipitation> kindOf(double water, std::optional<double> snow) {
    if (water <= 0.0) return Precipitation::None;
    if (!snow) return std::nullopt;
    return *snow <= 0.05 ? Precipitation::Rain : *snow >= 0.95 ? Precipitation::Snow : Precipitation::Sleet;
}

Report reportOf(Hours const& hours, std::size_t i) {
    Report report;
    report.time = hours.times[i];
    setWind(hours.at("windspeed", i), hours.at("winddirection", i), report.speed_mps, report.from_deg);
    report.gust_mps = hours.at("gust", i);
    report.temperature_c = hours.at("temperature", i);
    report.dew_point_c = dewPoint_c(report.temperature_c, hours.at("relativehumidity", i));
    report.pressure_hpa = hours.at("sealevelpressure", i);
    if (auto const water = hours.at("precipitation", i)) {
        report.rate_mm_h = *water;
        report.precipitationKind = kindOf(*water, hours.at("snowfraction", i));
    }
    if (report.rate_mm_h || report.gust_mps) report.interval_s = kHour;
    // The hourly pictograms 27, 28 and 30 are rain with "thunderstorms likely"; the others say nothing of thunder.
    auto const picture = hours.at("pictocode", i);
    if (picture && (*picture == 27.0 || *picture == 28.0 || *picture == 30.0)) report.thunder = true;
    report.coverLow = hours.at("lowclouds", i);
    report.coverMid = hours.at("midclouds", i);
    report.coverHigh = hours.at("highclouds", i);
    report.coverTotal = hours.at("totalcloudcover", i);
    report.coverBounds = kBounds;
    report.visibility_m = hours.at("visibility", i);
    return report;
}

void refuseError(Json const& json, std::string const& file) {
    for (char const* key : {"error_message", "message", "reason", "error"}) {
        auto const found = json.find(key);
        if (found != json.end() && found->is_string())
            throw core::Error(file, "error", "expected weather, meteoblue says: " + oneLine(found->get<std::string>()));
    }
    if (auto const error = json.find("error"); error != json.end() && error->is_boolean() && error->get<bool>())
        throw core::Error(file, "error", "expected weather, meteoblue says: no reason given");
}

Json const& objectAt(Json const& json, char const* key, std::string const& file) {
    auto const found = json.find(key);
    if (found == json.end() || !found->is_object())
        throw core::Error(file, key, fmt::format("expected an object \"{}\" of meteoblue's basic-1h or clouds-1h", key));
    return *found;
}
}  // namespace

std::string meteoblueUrl(std::string const& base, std::string const& key, double lat_deg, double lon_deg, std::optional<double> altitude_m) {
    CHECK(std::isfinite(lat_deg) && std::isfinite(lon_deg), "place {} {}", lat_deg, lon_deg);
    std::string safe;
    for (char const c : key) {
        bool const plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        safe += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return fmt::format("{}{}lat={:.4f}&lon={:.4f}{}&timeformat=iso8601&format=json&apikey={}", base, base.find('?') == base.npos ? '?' : '&', lat_deg,
                       lon_deg, altitude_m ? fmt::format("&asl={:.0f}", *altitude_m) : "", safe);
}

bool looksLikeMeteoblue(std::string_view bytes) {
    auto const first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos || bytes[first] != '{') return false;
    auto const has = [bytes](std::string_view mark) { return bytes.find(mark) != bytes.npos; };
    if (has("\"luftpost-weather-1\"")) return false;
    return has("\"data_1h\"") || has("\"error_message\"") || (has("\"metadata\"") && has("\"modelrun_utc\""));
}

Recording parseMeteoblue(std::string_view bytes, std::string const& file) {
    Json const json = parseJson(bytes, file, "a body of meteoblue");
    if (!json.is_object()) throw core::Error(file, "", "expected an object of meteoblue");
    refuseError(json, file);
    Json const& metadata = objectAt(json, "metadata", file);
    Json const& units = objectAt(json, "units", file);
    Json const& data = objectAt(json, "data_1h", file);
    Site site;
    site.lat_deg = requiredNumber(metadata, "latitude", kLatitude, file, "metadata");
    site.lon_deg = requiredNumber(metadata, "longitude", kLongitude, file, "metadata");
    site.elevation_m = optionalNumber(metadata, "height", kElevation, file, "metadata");
    auto const named = metadata.find("name");
    site.name = named != metadata.end() && named->is_string() && !named->get<std::string>().empty() ? oneLine(named->get<std::string>(), 60)
                                                                                                 : coordinateName(*site.lat_deg, *site.lon_deg);
    double const offset = kHour * optionalNumber(metadata, "utc_timeoffset", {-24.0, 24.0}, file, "metadata").value_or(0.0);
    auto const time = data.find("time");
    if (time == data.end()) throw core::Error(file, "data_1h", "expected the key \"time\"");
    Hours hours{file, timesOf(*time, offset, file), {}};
    for (Variable const& variable : kVariables) {
        auto const values = data.find(variable.name);
        if (values == data.end()) continue;
        checkArray(*values, hours.times.size(), file, fmt::format("data_1h.{}", variable.name));
        if (knowsAnything(*values)) hours.columns[variable.name] = columnOf(*values, units, variable, file);
    }
    for (std::size_t i = 0; i < hours.times.size(); ++i) site.reports.push_back(reportOf(hours, i));
    keepWhatSpeaks(site.reports);
    if (site.reports.empty()) throw core::Error(file, "data_1h", "expected at least one hour with a value that is read here");
    return {file, fmt::format("meteoblue {}, {}", site.name, dayName(site.reports.front().time)), "meteoblue (model data)",
            "meteoblue, for the holder of the key; not to be passed on", sha256Hex(bytes), {site}, {}};
}
}  // namespace luftpost::weather
