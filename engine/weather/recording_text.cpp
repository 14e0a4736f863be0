#include "engine/weather/recording_text.h"

#include <nlohmann/json.hpp>

#include "engine/core/time.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
using Json = nlohmann::ordered_json;

template <class T>
void put(Json& json, char const* key, std::optional<T> const& value) {
    if (value) json[key] = *value;
}

Json layerJson(ReportedLayer const& layer) {
    Json json = Json::object();
    if (layer.genus) json["genus"] = genusName(*layer.genus);
    put(json, "cover", layer.cover);
    put(json, "base_m", layer.base_m);
    put(json, "top_m", layer.top_m);
    return json;
}

Json levelJson(ReportedLevel const& level) {
    Json json{{"altitude_m", level.altitude_m}};
    put(json, "temperature_c", level.temperature_c);
    put(json, "dew_point_c", level.dew_point_c);
    put(json, "speed_mps", level.speed_mps);
    put(json, "from_deg", level.from_deg);
    put(json, "cover", level.cover);
    return json;
}

/// Wind, precipitation and the sky.
void putGroups(Json& json, Report const& report) {
    Json wind = Json::object(), precipitation = Json::object();
    put(wind, "speed_mps", report.speed_mps);
    put(wind, "gust_mps", report.gust_mps);
    put(wind, "from_deg", report.from_deg);
    if (!wind.empty()) json["wind"] = wind;
    if (report.precipitationKind) precipitation["kind"] = precipitationName(*report.precipitationKind);
    put(precipitation, "rate_mm_h", report.rate_mm_h);
    if (!precipitation.empty()) json["precipitation"] = precipitation;
    if (report.layers) {
        json["layers"] = Json::array();
        for (ReportedLayer const& layer : *report.layers) json["layers"].push_back(layerJson(layer));
    }
    for (ReportedLevel const& level : report.levels) json["levels"].push_back(levelJson(level));
    if (report.coverLow || report.coverMid || report.coverHigh)
        json["cover_bounds_m"] = {report.coverBounds.low_m, report.coverBounds.mid_m};
}

Json reportJson(Report const& report) {
    Json json{{"time", core::formatUtc(report.time)}};
    putGroups(json, report);
    put(json, "visibility_m", report.visibility_m);
    if (report.visibilityIsMinimum) json["visibility_is_minimum"] = true;
    put(json, "vertical_visibility_m", report.verticalVisibility_m);
    put(json, "temperature_c", report.temperature_c);
    put(json, "dew_point_c", report.dew_point_c);
    put(json, "pressure_hpa", report.pressure_hpa);
    put(json, "thunder", report.thunder);
    put(json, "layers_to_m", report.layersTo_m);
    put(json, "interval_s", report.interval_s);
    put(json, "cover_low", report.coverLow);
    put(json, "cover_mid", report.coverMid);
    put(json, "cover_high", report.coverHigh);
    put(json, "cover_total", report.coverTotal);
    put(json, "cape_j_kg", report.cape_j_kg);
    put(json, "freezing_level_m", report.freezingLevel_m);
    put(json, "snow_depth_m", report.snowDepth_m);
    put(json, "weather_code", report.weatherCode);
    for (auto const& [place, value] : report.filled)
        json["filled"][place] = std::visit([](auto const& v) { return Json(v); }, value);
    return json;
}
}  // namespace

std::string recordingText(Recording const& recording) {
    Json json{{"format", "luftpost-weather-1"},
              {"name", recording.name},
              {"source", recording.source},
              {"licence", recording.licence},
              {"sites", Json::array()}};
    for (Site const& site : recording.sites) {
        Json entry{{"name", site.name}};
        put(entry, "lat", site.lat_deg);
        put(entry, "lon", site.lon_deg);
        put(entry, "elevation_m", site.elevation_m);
        entry["reports"] = Json::array();
        for (Report const& report : site.reports) entry["reports"].push_back(reportJson(report));
        json["sites"].push_back(entry);
    }
    return json.dump(1) + "\n";
}
}  // namespace luftpost::weather
