#include "game/ui/hand_weather.h"

#include <algorithm>
#include <cmath>

#include "engine/weather/fill.h"
#include "engine/weather/genera.h"

namespace luftpost::ui {
namespace {
constexpr double kZeroCelsius = 273.15;  // K
constexpr double kCalm = 0.05;           // m/s: below, no direction

void hold(double& value, HandRange range) { value = std::isfinite(value) ? std::clamp(value, range.least, range.most) : range.least; }

void tidyLayer(HandLayer& layer) {
    hold(layer.eighths, {0.0, 8.0});
    hold(layer.base_m, {kHandHeight.least, kHandHeight.most - kHandThinnest_m});
    hold(layer.top_m, {layer.base_m + kHandThinnest_m, kHandHeight.most});
}
}  // namespace

HandWeather handFrom(weather::Weather const& weather) {
    HandWeather hand;
    hand.speed_mps = glm::length(weather.windSurface);
    if (hand.speed_mps > kCalm) hand.from_deg = weather::windFrom_deg(weather.windSurface);
    hand.gust_mps = weather.gust;
    hand.visibility_km = weather.visibility / 1000.0;
    hand.kind = weather.precipitation;
    hand.rate_mm_h = weather.precipitationRate;
    hand.thunder = weather.thunder;
    hand.temperature_c = weather.temperature - kZeroCelsius;
    hand.dewPoint_c = weather.dewPoint - kZeroCelsius;
    hand.pressure_hpa = weather.pressureSea / 100.0;
    hand.cape_j_kg = weather.cape;
    for (int i = 0; i < weather.layerCount; ++i) {
        weather::Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        hand.layers.push_back({layer.genus, 8.0 * static_cast<double>(layer.cover), static_cast<double>(layer.base), static_cast<double>(layer.top)});
    }
    tidy(hand);
    return hand;
}

void tidy(HandWeather& hand) {
    hold(hand.from_deg, {0.0, 360.0});
    hold(hand.speed_mps, kHandSpeed);
    hold(hand.gust_mps, {hand.speed_mps, kHandGust.most});
    hold(hand.visibility_km, kHandVisibility_km);
    hold(hand.rate_mm_h, kHandRate);
    hold(hand.temperature_c, kHandTemperature);
    hold(hand.dewPoint_c, {kHandTemperature.least - 30.0, hand.temperature_c});
    hold(hand.pressure_hpa, kHandPressure);
    hold(hand.cape_j_kg, kHandCape);
    if (hand.kind == weather::Precipitation::Unknown) hand.kind = weather::Precipitation::Rain;
    if (hand.kind == weather::Precipitation::None) hand.rate_mm_h = 0.0;
    if (hand.layers.size() > static_cast<std::size_t>(weather::kMaxLayers)) hand.layers.resize(weather::kMaxLayers);
    for (HandLayer& layer : hand.layers) tidyLayer(layer);
}

void useGenus(HandLayer& layer, weather::Genus genus, double elevation) {
    weather::GenusRow const& row = weather::genusRow(genus);
    layer.genus = genus;
    layer.base_m = elevation + row.base;
    layer.top_m = layer.base_m + row.thickness;
    tidyLayer(layer);
}

HandLayer anotherLayer(HandWeather const& hand, double elevation) {
    using weather::Genus;
    HandLayer layer;
    for (Genus genus : {Genus::Cu, Genus::Ci, Genus::Ac, Genus::Sc}) {
        useGenus(layer, genus, elevation);
        auto const same = [genus](HandLayer const& other) { return other.genus == genus; };
        if (std::none_of(hand.layers.begin(), hand.layers.end(), same)) break;
    }
    return layer;
}

weather::Recording handRecording(HandWeather const& hand, core::Place const& place, core::UtcSeconds time) {
    weather::Report report;
    report.time = time;
    report.speed_mps = hand.speed_mps;
    report.gust_mps = hand.gust_mps;
    if (hand.speed_mps > kCalm) report.from_deg = hand.from_deg;
    report.visibility_m = 1000.0 * hand.visibility_km;
    report.precipitationKind = hand.kind;
    report.rate_mm_h = hand.rate_mm_h;
    report.thunder = hand.thunder;
    report.temperature_c = hand.temperature_c;
    report.dew_point_c = hand.dewPoint_c;
    report.pressure_hpa = hand.pressure_hpa;
    report.cape_j_kg = hand.cape_j_kg;
    report.layers.emplace();
    for (HandLayer const& layer : hand.layers)
        report.layers->push_back({layer.genus, layer.eighths / 8.0, layer.base_m, layer.top_m});
    std::sort(report.layers->begin(), report.layers->end(), [](auto const& a, auto const& b) { return *a.base_m < *b.base_m; });
    weather::Recording recording;
    recording.name = "Weather by hand";
    recording.source = "Luftpost: set by the player";
    recording.licence = "MIT";
    recording.sites.push_back({"the player's place", place.lat_deg, place.lon_deg, place.altitude_m, {report}});
    return recording;
}
}  // namespace luftpost::ui
