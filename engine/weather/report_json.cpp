#include "engine/weather/report_json.h"

#include <cmath>

#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
using Json = nlohmann::ordered_json;

Json layersJson(std::optional<std::vector<ReportedLayer>> const& layers) {
    if (!layers) return nullptr;
    Json list = Json::array();
    for (ReportedLayer const& layer : *layers)
        list.push_back({{"genus", layer.genus ? Json(genusName(*layer.genus)) : Json()},
                        {"cover", numberJson(layer.cover)},
                        {"base_m", numberJson(layer.base_m)},
                        {"top_m", numberJson(layer.top_m)}});
    return list;
}

Json filledJson(Filled const& filled) {
    Json object = Json::object();
    for (auto const& [place, value] : filled) {
        if (auto const* number = std::get_if<double>(&value)) object[place] = numberJson(*number);
        else if (auto const* text = std::get_if<std::string>(&value)) object[place] = *text;
        else object[place] = std::get<bool>(value);
    }
    return object;
}

/// JSON of a text that may be no UTF-8.
std::string dumped(Json const& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json levelsJson(std::vector<ReportedLevel> const& levels) {
    Json list = Json::array();
    for (ReportedLevel const& level : levels)
        list.push_back({{"altitude_m", numberJson(level.altitude_m)},
                        {"temperature_c", numberJson(level.temperature_c)},
                        {"dew_point_c", numberJson(level.dew_point_c)},
                        {"speed_mps", numberJson(level.speed_mps)},
                        {"from_deg", numberJson(level.from_deg)},
                        {"cover", numberJson(level.cover)}});
    return list;
}

/// The optional fields of a recording, those that are there.
void addExtras(Json& json, Report const& report) {
    auto const add = [&json](char const* key, std::optional<double> value) {
        if (value) json[key] = numberJson(value);
    };
    add("interval_s", report.interval_s);
    add("cover_low", report.coverLow);
    add("cover_mid", report.coverMid);
    add("cover_high", report.coverHigh);
    add("cover_total", report.coverTotal);
    json["cover_bounds_m"] = {report.coverBounds.low_m, report.coverBounds.mid_m};
    add("cape_j_kg", report.cape_j_kg);
    add("freezing_level_m", report.freezingLevel_m);
    add("snow_depth_m", report.snowDepth_m);
    add("radiation_w_m2", report.radiation_w_m2);
    add("longwave_w_m2", report.longwave_w_m2);
    if (report.weatherCode) json["weather_code"] = *report.weatherCode;
    if (!report.levels.empty()) json["levels"] = levelsJson(report.levels);
}
}  // namespace

Json numberJson(std::optional<double> value) {
    if (!value) return nullptr;
    return std::round(*value * 1e6) / 1e6;
}

Json reportJson(Site const& site, Report const& said, Filled const& filled) {
    Json json;
    json["name"] = site.name;
    json["lat"] = numberJson(site.lat_deg);
    json["lon"] = numberJson(site.lon_deg);
    json["elevation_m"] = numberJson(site.elevation_m);
    json["time"] = filled.contains("time") ? Json() : Json(core::formatUtc(said.time));  // not said: a time that cannot be read
    json["wind"] = {{"speed_mps", numberJson(said.speed_mps)}, {"gust_mps", numberJson(said.gust_mps)}, {"from_deg", numberJson(said.from_deg)}};
    json["visibility_m"] = numberJson(said.visibility_m);
    json["visibility_is_minimum"] = said.visibilityIsMinimum;
    json["vertical_visibility_m"] = numberJson(said.verticalVisibility_m);
    json["temperature_c"] = numberJson(said.temperature_c);
    json["dew_point_c"] = numberJson(said.dew_point_c);
    json["pressure_hpa"] = numberJson(said.pressure_hpa);
    json["precipitation"] = {{"kind", said.precipitationKind ? Json(precipitationName(*said.precipitationKind)) : Json()},
                             {"rate_mm_h", numberJson(said.rate_mm_h)}};
    json["thunder"] = said.thunder ? Json(*said.thunder) : Json();
    json["layers"] = layersJson(said.layers);
    json["layers_to_m"] = numberJson(said.layersTo_m);
    json["filled"] = filledJson(filled);
    return json;
}

std::string recordingText(Recording const& recording) {
    std::string text = "{\"format\": \"luftpost-weather-1\", \"name\": " + dumped(recording.name) +
                       ", \"source\": " + dumped(recording.source) + ", \"licence\": " + dumped(recording.licence) + ", \"sites\": [";
    for (std::size_t i = 0; i < recording.sites.size(); ++i) {
        Site const& site = recording.sites[i];
        Json const head{{"name", site.name}, {"lat", numberJson(site.lat_deg)}, {"lon", numberJson(site.lon_deg)},
                        {"elevation_m", numberJson(site.elevation_m)}};
        std::string const opened = dumped(head);
        text += (i > 0 ? ",\n" : "\n") + opened.substr(0, opened.size() - 1) + ",\"reports\":[";
        for (std::size_t k = 0; k < site.reports.size(); ++k) {
            Json report = reportJson(site, site.reports[k], site.reports[k].filled);
            for (char const* key : {"name", "lat", "lon", "elevation_m"}) report.erase(key);
            report["time"] = core::formatUtc(site.reports[k].time);
            addExtras(report, site.reports[k]);
            text += (k > 0 ? ",\n" : "\n") + dumped(report);
        }
        text += "\n]}";
    }
    return text + "\n]}\n";
}

void writeRecording(Recording const& recording, std::string const& file) { core::writeFileAtomically(file, recordingText(recording)); }
}  // namespace luftpost::weather
