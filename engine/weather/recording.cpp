#include "engine/weather/recording.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/genera.h"
#include "engine/weather/json_body.h"
#include "engine/weather/ranges.h"

namespace luftpost::weather {
namespace {
using Json = nlohmann::json;

/// One JSON value, where it stands, and the file it came from: says no in one line.
class Node {
public:
    Node(Json const& json, std::string const& file, std::string place, std::vector<std::string>& unknown, std::set<std::string>& kinds)
        : json_{json}, file_{file}, place_{std::move(place)}, unknown_{unknown}, kinds_{kinds} {}

    [[noreturn]] void fail(std::string const& expected) const {
        throw core::Error(file_, place_.empty() ? "top level" : place_, expected);
    }
    [[noreturn]] void failHere(std::string const& expected) const { fail(fmt::format("expected {}, found {}", expected, found())); }

    /// A member, or nothing when it is absent or null.
    std::optional<Node> member(std::string_view key) const {
        auto const found = json_.find(key);
        if (found == json_.end() || found->is_null()) return std::nullopt;
        return child(*found, place_.empty() ? std::string{key} : fmt::format("{}.{}", place_, key));
    }
    Node required(std::string_view key) const {
        auto node = member(key);
        if (!node) fail(fmt::format("expected the key \"{}\"", key));
        return *node;
    }
    Node element(std::size_t i) const { return child(json_[i], fmt::format("{}[{}]", place_, i)); }
    std::size_t size() const { return json_.size(); }
    Json const& json() const { return json_; }

    /// Sees to it that this is an object, and takes down the keys that nobody will read.
    void object(std::initializer_list<std::string_view> known) const {
        if (!json_.is_object()) failHere("an object");
        for (auto const& [key, value] : json_.items())
            if (std::find(known.begin(), known.end(), key) == known.end()) noteUnknown(key);
    }
    void array() const {
        if (!json_.is_array()) failHere("an array");
    }
    void noteUnknown(std::string const& key) const {
        std::string const place = place_.empty() ? key : fmt::format("{}.{}", place_, key);
        std::string kind;
        bool inside = false;
        for (char const c : place) {
            inside = c == '[' || (inside && c != ']');
            if (!inside || c == '[') kind += c;
        }
        if (kinds_.insert(kind).second) unknown_.push_back(place);
    }

    double number(Range range) const {
        if (!json_.is_number()) failHere("a number");
        double const value = json_.get<double>();
        if (!std::isfinite(value) || value < range.low || value > range.high)
            failHere(fmt::format("a number from {} to {}", range.low, range.high));
        return value;
    }
    std::string text() const {
        if (!json_.is_string()) failHere("a string");
        return json_.get<std::string>();
    }
    bool yes() const {
        if (!json_.is_boolean()) failHere("true or false");
        return json_.get<bool>();
    }
    std::optional<double> number(std::string_view key, Range range) const {
        auto const node = member(key);
        return node ? std::optional{node->number(range)} : std::nullopt;
    }
    std::optional<bool> yes(std::string_view key) const {
        auto const node = member(key);
        return node ? std::optional{node->yes()} : std::nullopt;
    }

private:
    Node child(Json const& json, std::string place) const { return {json, file_, std::move(place), unknown_, kinds_}; }
    std::string found() const {
        if (json_.is_structured()) return json_.is_object() ? "an object" : "an array";
        std::string text = json_.dump(-1, ' ', true, Json::error_handler_t::replace);
        if (text.size() > 40) text = text.substr(0, 37) + "...";
        return text;
    }

    Json const& json_;
    std::string const& file_;
    std::string place_;
    std::vector<std::string>& unknown_;
    std::set<std::string>& kinds_;
};

Genus readGenus(Node const& node) {
    auto const genus = genusFromName(node.text());
    if (!genus) node.failHere("a genus (Ci Cc Cs Ac As Ns Sc St Cu Cb fog)");
    return *genus;
}

Precipitation readKind(Node const& node) {
    auto const kind = precipitationFromName(node.text());
    if (!kind) node.failHere("a kind (none drizzle rain snow sleet hail freezing_rain unknown)");
    return *kind;
}

ReportedLayer readLayer(Node const& node) {
    node.object({"genus", "cover", "base_m", "top_m"});
    ReportedLayer layer;
    if (auto const genus = node.member("genus")) layer.genus = readGenus(*genus);
    layer.cover = node.number("cover", kCover);
    layer.base_m = node.number("base_m", kCloudHeight);
    layer.top_m = node.number("top_m", kCloudHeight);
    if (layer.base_m && layer.top_m && *layer.top_m <= *layer.base_m)
        node.fail(fmt::format("expected top_m above base_m {}, found {}", *layer.base_m, *layer.top_m));
    return layer;
}

std::vector<ReportedLayer> readLayers(Node const& node) {
    node.array();
    if (node.size() > 16) node.fail(fmt::format("expected at most 16 layers, found {}", node.size()));
    std::vector<ReportedLayer> layers;
    for (std::size_t i = 0; i < node.size(); ++i) layers.push_back(readLayer(node.element(i)));
    return layers;
}

std::vector<ReportedLevel> readLevels(Node const& node) {
    node.array();
    std::vector<ReportedLevel> levels;
    for (std::size_t i = 0; i < node.size(); ++i) {
        Node const entry = node.element(i);
        entry.object({"altitude_m", "temperature_c", "dew_point_c", "speed_mps", "from_deg", "cover"});
        ReportedLevel level;
        level.altitude_m = entry.required("altitude_m").number(kAltitude);
        level.temperature_c = entry.number("temperature_c", kTemperature);
        level.dew_point_c = entry.number("dew_point_c", kDewPoint);
        level.speed_mps = entry.number("speed_mps", kSpeed);
        level.from_deg = entry.number("from_deg", kDegrees);
        level.cover = entry.number("cover", kCover);
        if (!levels.empty() && level.altitude_m <= levels.back().altitude_m)
            entry.fail(fmt::format("expected altitude_m above {}, found {}", levels.back().altitude_m, level.altitude_m));
        levels.push_back(level);
    }
    return levels;
}

CoverBounds readBounds(Node const& node) {
    node.array();
    if (node.size() != 2) node.failHere("two heights, low to mid and mid to high");
    CoverBounds const bounds{node.element(0).number(kCloudHeight), node.element(1).number(kCloudHeight)};
    if (bounds.mid_m <= bounds.low_m) node.fail("expected the second height above the first");
    return bounds;
}

/// The part behind "layers[7]." of "layers[7].base_m", nothing for another place.
std::optional<std::string_view> layerPart(std::string_view place) {
    if (!place.starts_with("layers[")) return std::nullopt;
    place.remove_prefix(7);
    std::size_t digits = 0;
    while (digits < place.size() && place[digits] >= '0' && place[digits] <= '9') ++digits;
    if (digits == 0 || digits > 2 || !place.substr(digits).starts_with("].")) return std::nullopt;
    return place.substr(digits + 2);
}

core::UtcSeconds readTime(Node const& node) {
    auto const time = core::parseUtc(node.text());
    if (!time) node.failHere("a time such as \"2023-06-23T18:40Z\"");
    return *time;
}

/// What a place of `filled` must hold.
std::optional<FilledValue> readFilledValue(std::string_view place, Node const& node) {
    static constexpr std::pair<std::string_view, Range> kNumbers[] = {
        {"wind.speed_mps", kSpeed}, {"wind.gust_mps", kSpeed}, {"wind.from_deg", kDegrees}, {"visibility_m", kVisibility},
        {"temperature_c", kTemperature}, {"dew_point_c", kDewPoint}, {"pressure_hpa", kPressure}, {"precipitation.rate_mm_h", kRate},
        {"elevation_m", {-500.0, 9000.0}}};
    if (auto const part = layerPart(place)) {
        if (*part == "genus") return std::string{genusName(readGenus(node))};
        if (*part == "cover") return node.number(kCover);
        if (*part == "base_m" || *part == "top_m") return node.number(kCloudHeight);
    }
    if (place == "precipitation.kind") return std::string{precipitationName(readKind(node))};
    if (place == "thunder") return node.yes();
    if (place == "time") return core::formatUtc(readTime(node));
    for (auto const& [name, range] : kNumbers)
        if (place == name) return node.number(range);
    return std::nullopt;
}

Filled readFilled(Node const& node) {
    if (!node.json().is_object()) node.failHere("an object");
    Filled filled;
    for (auto const& [place, value] : node.json().items()) {
        auto const entry = node.member(place);
        if (!entry) continue;
        if (auto const known = readFilledValue(place, *entry)) filled[place] = *known;
        else node.noteUnknown(place);
    }
    return filled;
}

void readWindAndRain(Node const& node, Report& report) {
    if (auto const wind = node.member("wind")) {
        wind->object({"speed_mps", "gust_mps", "from_deg"});
        report.speed_mps = wind->number("speed_mps", kSpeed);
        report.gust_mps = wind->number("gust_mps", kSpeed);
        report.from_deg = wind->number("from_deg", kDegrees);
    }
    if (auto const precipitation = node.member("precipitation")) {
        precipitation->object({"kind", "rate_mm_h"});
        if (auto const kind = precipitation->member("kind")) report.precipitationKind = readKind(*kind);
        report.rate_mm_h = precipitation->number("rate_mm_h", kRate);
    }
    report.thunder = node.yes("thunder");
    report.interval_s = node.number("interval_s", kInterval);
}

void readSky(Node const& node, Report& report) {
    if (auto const layers = node.member("layers")) report.layers = readLayers(*layers);
    report.layersTo_m = node.number("layers_to_m", kAltitude);
    if (auto const levels = node.member("levels")) report.levels = readLevels(*levels);
    report.coverLow = node.number("cover_low", kCover);
    report.coverMid = node.number("cover_mid", kCover);
    report.coverHigh = node.number("cover_high", kCover);
    report.coverTotal = node.number("cover_total", kCover);
    if (auto const bounds = node.member("cover_bounds_m")) report.coverBounds = readBounds(*bounds);
    if (auto const filled = node.member("filled")) report.filled = readFilled(*filled);
}

Report readReport(Node const& node) {
    node.object({"name", "lat", "lon", "elevation_m", "time", "wind", "visibility_m", "visibility_is_minimum",
                 "vertical_visibility_m", "temperature_c", "dew_point_c", "pressure_hpa", "precipitation", "thunder", "layers",
                 "layers_to_m", "filled", "interval_s", "levels", "cover_low", "cover_mid", "cover_high", "cover_total",
                 "cover_bounds_m", "cape_j_kg", "freezing_level_m", "snow_depth_m", "radiation_w_m2", "longwave_w_m2", "weather_code"});
    Report report;
    report.time = readTime(node.required("time"));
    readWindAndRain(node, report);
    report.visibility_m = node.number("visibility_m", kVisibility);
    report.visibilityIsMinimum = node.yes("visibility_is_minimum").value_or(false);
    report.verticalVisibility_m = node.number("vertical_visibility_m", kVerticalVisibility);
    report.temperature_c = node.number("temperature_c", kTemperature);
    report.dew_point_c = node.number("dew_point_c", kDewPoint);
    report.pressure_hpa = node.number("pressure_hpa", kPressure);
    readSky(node, report);
    report.cape_j_kg = node.number("cape_j_kg", kCape);
    report.freezingLevel_m = node.number("freezing_level_m", kFreezingLevel);
    report.snowDepth_m = node.number("snow_depth_m", kSnowDepth);
    report.radiation_w_m2 = node.number("radiation_w_m2", kRadiation);
    report.longwave_w_m2 = node.number("longwave_w_m2", kLongwave);
    if (auto const code = node.number("weather_code", kWeatherCode)) {
        if (*code != std::floor(*code)) node.required("weather_code").failHere("a whole number from 0 to 99");
        report.weatherCode = static_cast<int>(*code);
    }
    return report;
}

Site readSite(Node const& node) {
    node.object({"name", "lat", "lon", "elevation_m", "reports"});
    Site site;
    site.name = node.required("name").text();
    site.lat_deg = node.number("lat", kLatitude);
    site.lon_deg = node.number("lon", kLongitude);
    site.elevation_m = node.number("elevation_m", kElevation);
    if (site.lat_deg.has_value() != site.lon_deg.has_value()) node.fail("expected both lat and lon, or neither");
    Node const reports = node.required("reports");
    reports.array();
    if (reports.size() == 0) reports.fail("expected at least one report");
    for (std::size_t i = 0; i < reports.size(); ++i) {
        site.reports.push_back(readReport(reports.element(i)));
        if (i > 0 && site.reports[i].time <= site.reports[i - 1].time)
            reports.element(i).required("time").fail(fmt::format("expected a time after {}, found {}", core::formatUtc(site.reports[i - 1].time),
                                                                 core::formatUtc(site.reports[i].time)));
    }
    return site;
}

}  // namespace

std::string sha256Hex(std::string_view bytes) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    CHECK(EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha256(), nullptr) == 1, "SHA-256 of {} bytes", bytes.size());
    return fmt::format("{:02x}", fmt::join(digest, digest + size, ""));
}

Recording parseRecording(std::string_view bytes, std::string const& file) {
    Json const json = parseJson(bytes, file, "a recording (luftpost-weather-1)");
    Recording recording;
    std::set<std::string> kinds;
    Node const top{json, file, "", recording.unknownKeys, kinds};
    if (!json.is_object()) top.failHere("an object with \"format\": \"luftpost-weather-1\"");
    auto const format = top.member("format");
    if (!format || !format->json().is_string() || format->text() != "luftpost-weather-1")
        throw core::Error(file, "format", "expected \"luftpost-weather-1\"");
    top.object({"format", "name", "source", "licence", "sites"});
    recording.file = file;
    recording.name = top.required("name").text();
    recording.source = top.required("source").text();
    recording.licence = top.required("licence").text();
    Node const sites = top.required("sites");
    sites.array();
    if (sites.size() == 0) sites.fail("expected at least one site");
    for (std::size_t i = 0; i < sites.size(); ++i) recording.sites.push_back(readSite(sites.element(i)));
    recording.sha256 = sha256Hex(bytes);
    return recording;
}

Recording readRecording(std::string const& file) { return parseRecording(core::readFile(file), file); }
}  // namespace luftpost::weather
