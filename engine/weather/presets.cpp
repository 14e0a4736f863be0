#include "engine/weather/presets.h"

#include <fmt/format.h>

#include "engine/core/time.h"

namespace luftpost::weather {
namespace {
constexpr double kDefaultLat = 47.541, kDefaultLon = 7.584, kDefaultElevation = 316.0;  // Basel / Binningen
constexpr std::string_view kPresetTime = "2023-06-23T00:00Z";                            // drift and phase count from here

/// A layer by heights above ground.
struct PresetLayer {
    Genus genus;
    double cover, base, top;
};

struct Preset {
    PresetName name;
    double speed, gust, from_deg;
    double visibility;
    double warmth, spread;  // K above the standard atmosphere, K between temperature and dew point
    double pressure_hpa;
    Precipitation kind;
    double rate;
    bool thunder;
    double cape;
    std::vector<PresetLayer> layers;
    double snowDepth = 0.0;  // m
};

std::vector<Preset> const& presets() {
    using enum Genus;
    static std::vector<Preset> const all{
        {{"calm", "the standard atmosphere: no wind, no cloud, no thermals, no turbulence"},
         0.0, 0.0, 0.0, 60000.0, 0.0, 10.0, 1013.25, Precipitation::None, 0.0, false, 0.0, {}},
        {{"clear", "a clear day with a light breeze"},
         3.0, 4.5, 240.0, 50000.0, 6.0, 12.0, 1020.0, Precipitation::None, 0.0, false, 0.0, {}},
        {{"fair", "fair-weather cumulus under thin cirrus"},
         4.5, 7.0, 250.0, 40000.0, 7.0, 10.0, 1018.0, Precipitation::None, 0.0, false, 150.0,
         {{Cu, 0.35, 1250.0, 2150.0}, {Ci, 0.30, 8500.0, 9700.0}}},
        {{"broken", "six eighths of stratocumulus and cumulus, altocumulus above"},
         6.5, 11.0, 270.0, 25000.0, 3.0, 7.0, 1011.0, Precipitation::None, 0.0, false, 80.0,
         {{Cu, 0.30, 900.0, 2000.0}, {Sc, 0.64, 1200.0, 1750.0}, {Ac, 0.40, 3600.0, 4050.0}}},
        {{"overcast", "low stratus under nimbostratus, light rain"},
         5.0, 8.0, 290.0, 8000.0, -1.0, 1.5, 1004.0, Precipitation::Rain, 1.2, false, 0.0,
         {{St, 1.0, 450.0, 850.0}, {Ns, 1.0, 1300.0, 4500.0}}},
        {{"storm", "cumulonimbus with thunder, heavy rain and gusts"},
         10.0, 20.0, 260.0, 5000.0, 5.0, 4.0, 1003.0, Precipitation::Rain, 20.0, true, 1600.0,
         {{Cb, 0.85, 800.0, 10500.0}, {Sc, 0.50, 1500.0, 2100.0}, {As, 0.60, 5000.0, 6500.0}}},
        {{"showers", "sun and thundery showers: shafts of rain, rainbows, anvils"},
         7.0, 14.0, 270.0, 45000.0, 3.0, 9.0, 1006.0, Precipitation::Rain, 1.5, true, 1100.0,
         {{Cb, 0.38, 1150.0, 10500.0}, {Cu, 0.20, 1150.0, 2300.0}}},
        {{"veil", "a veil of cirrostratus before the sun: halo and sun dogs"},
         4.0, 6.0, 210.0, 40000.0, -8.0, 6.0, 1014.0, Precipitation::None, 0.0, false, 0.0,
         {{Cs, 0.95, 8000.0, 9300.0}}},
        {{"mist", "a calm morning with mist in the valleys"},
         0.8, 1.2, 90.0, 15000.0, -7.0, 0.4, 1024.0, Precipitation::None, 0.0, false, 0.0,
         {{Fog, 0.60, -150.0, 70.0}}},
        {{"snow", "snow showers over snow-covered land"},
         6.0, 11.0, 310.0, 30000.0, -18.0, 2.5, 1009.0, Precipitation::Snow, 0.5, false, 250.0,
         {{Cb, 0.40, 700.0, 5200.0}, {Sc, 0.30, 900.0, 1500.0}}, 0.25},
    };
    return all;
}

Report reportOf(Preset const& preset, double elevation) {
    Report report;
    report.time = *core::parseUtc(kPresetTime);
    report.speed_mps = preset.speed;
    report.gust_mps = preset.gust;
    if (preset.speed > 0.0) report.from_deg = preset.from_deg;
    report.visibility_m = preset.visibility;
    report.temperature_c = 15.0 - 0.0065 * elevation + preset.warmth;
    report.dew_point_c = *report.temperature_c - preset.spread;
    report.pressure_hpa = preset.pressure_hpa;
    report.precipitationKind = preset.kind;
    report.rate_mm_h = preset.rate;
    report.thunder = preset.thunder;
    report.cape_j_kg = preset.cape;
    report.snowDepth_m = preset.snowDepth;
    report.layers.emplace();
    for (PresetLayer const& layer : preset.layers)
        report.layers->push_back({layer.genus, layer.cover, elevation + layer.base, elevation + layer.top});
    return report;
}
}  // namespace

std::vector<PresetName> const& presetNames() {
    static std::vector<PresetName> const names = [] {
        std::vector<PresetName> list;
        for (Preset const& preset : presets()) list.push_back(preset.name);
        return list;
    }();
    return names;
}

std::optional<Recording> presetRecording(std::string_view name, std::optional<PlaceWish> const& place) {
    for (Preset const& preset : presets()) {
        if (preset.name.name != name) continue;
        Site site;
        site.name = place ? "the place asked for" : "Basel / Binningen";
        site.lat_deg = place ? place->lat_deg : kDefaultLat;
        site.lon_deg = place ? place->lon_deg : kDefaultLon;
        site.elevation_m = place ? place->altitude_m.value_or(kDefaultElevation) : kDefaultElevation;
        site.reports.push_back(reportOf(preset, *site.elevation_m));
        Recording recording;
        recording.file = fmt::format("preset:{}", name);
        recording.name = recording.file;
        recording.source = "Luftpost";
        recording.licence = "MIT";
        recording.sites.push_back(std::move(site));
        return recording;
    }
    return std::nullopt;
}
}  // namespace luftpost::weather
