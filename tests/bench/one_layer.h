#pragma once
#include <optional>
#include <utility>

#include "engine/weather/field.h"

namespace luftpost::tests {
/// A sky of one layer, everywhere and for ever.
inline weather::Field fieldOfOneLayer(weather::Genus genus, float cover, double thickness) {
    using namespace weather;
    constexpr double kBase = 1000.0;  // m
    Report report;
    report.time = 0.0;
    report.speed_mps = 5.0;
    report.from_deg = 240.0;
    report.layers.emplace();
    report.layers->push_back({genus, cover, kBase, kBase + thickness});
    Site site;
    site.name = "one layer";
    site.lat_deg = 47.5;
    site.lon_deg = 7.6;
    site.elevation_m = 0.0;
    site.reports.push_back(report);
    Recording recording;
    recording.name = "one layer";
    recording.sites.push_back(site);
    return fieldFrom(std::move(recording), {SourceMode::Preset, "one layer", "", "", ""}, std::nullopt);
}
}  // namespace luftpost::tests
