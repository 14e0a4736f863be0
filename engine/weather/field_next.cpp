// From one field to the next in mid-flight, without a jump.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/site_curves.h"
#include "engine/weather/whole_report.h"

namespace luftpost::weather {
namespace {
constexpr double kZeroCelsius = 273.15;
/// Heights above ground at which the wind is handed over: so close that a straight line between two of them is the wind between.
constexpr double kHandedHeights[] = {20.0,   40.0,   70.0,   110.0,  160.0,  220.0,  300.0,  400.0,  550.0,  750.0,   1000.0,  1300.0,
                                     1700.0, 2200.0, 2800.0, 3500.0, 4300.0, 5200.0, 6200.0, 7500.0, 9000.0, 10500.0, 12000.0, 14000.0};

ReportedLayer reportedLayer(Layer const& layer) {
    return {layer.genus, static_cast<double>(layer.cover), static_cast<double>(layer.base), static_cast<double>(layer.top)};
}

/// The wind of a field over a site as levels.
std::vector<ReportedLevel> handedLevels(FieldInstant const& field, glm::dvec2 at, double elevation) {
    std::vector<ReportedLevel> levels;
    for (double const height : kHandedHeights) {
        MeanAir const air = field.meanAir(at.x, at.y, elevation + height, elevation);
        levels.push_back({elevation + height, air.temperature - kZeroCelsius, {}, glm::length(air.wind), windFrom_deg(air.wind), {}});
    }
    return levels;
}

/// All that a field says over a site at a time, as a report that leaves nothing open.
Report wholeReport(Field const& field, Site const& site, glm::dvec2 at, core::UtcSeconds time, double interval) {
    double const elevation = site.elevation_m.value_or(0.0);
    FieldInstant const now = field.instant(time);
    Weather const w = now.at(at.x, at.y);
    MeanAir const air = now.meanAir(at.x, at.y, elevation, elevation);
    Report report;
    report.time = time;
    report.speed_mps = glm::length(w.windSurface);
    report.from_deg = windFrom_deg(w.windSurface);
    report.gust_mps = w.gust;
    report.visibility_m = w.visibility;
    report.temperature_c = air.temperature - kZeroCelsius;
    report.dew_point_c = w.dewPoint - kZeroCelsius;
    report.pressure_hpa = w.pressureSea / 100.0;
    report.precipitationKind = w.precipitation;
    report.rate_mm_h = w.precipitationRate;
    report.thunder = w.thunder;
    report.interval_s = interval;
    report.layers.emplace();
    for (int i = 0; i < w.layerCount; ++i) report.layers->push_back(reportedLayer(w.layers[static_cast<std::size_t>(i)]));
    report.cape_j_kg = w.cape;
    report.freezingLevel_m = w.freezingLevel;
    report.snowDepth_m = w.snowDepth;
    report.levels = handedLevels(now, at, elevation);
    return report;
}

/// From the one field to the other over a site: what was, what shall be, and the rain half-way: a rate goes over without a
/// jump only where the interval behind the change has the rate of the one before it.
std::vector<Report> handover(Field const& before, Field const& goal, Site const& site, glm::dvec2 at, core::UtcSeconds time, double seconds) {
    Report const was = wholeReport(before, site, at, time, seconds);
    Report half = wholeReport(goal, site, at, time + seconds, seconds);
    half.rate_mm_h = was.rate_mm_h;
    half.precipitationKind = was.precipitationKind;
    Report whole = wholeReport(goal, site, at, time + 2.0 * seconds, seconds);
    if (*whole.rate_mm_h <= 0.0) whole.precipitationKind = was.precipitationKind;
    return {was, half, whole};
}

Carry carryOf(Field const& before, core::UtcSeconds time) {
    FieldAccess::Data const& data = FieldAccess::data(before);
    Carry carry;
    carry.time = time;
    carry.start = data.start;
    carry.ordinals = data.ordinals;
    carry.boundaryDrift = before.boundaryDrift(time);
    for (FieldTrack const& track : data.tracks) {
        std::optional<double> base;
        auto const index = static_cast<std::size_t>(&track - data.tracks.data());
        for (SiteData const& site : data.sites)
            if (site.curves[index] && site.curves[index]->cover.at(time) > 0.0) base = site.curves[index]->base.at(time);
        if (base) carry.layers.push_back({track.genus, *base, track.pattern, track.wind.integralTo(time) - track.atStart});
    }
    return carry;
}
}  // namespace

Report wholeReport(Field const& field, Site const& site, core::UtcSeconds time, double interval) {
    return wholeReport(field, site, eastNorthOf(site, field.place()), time, interval);
}

Field nextField(Field const& before, Recording recording, Origin origin, core::UtcSeconds time, double seconds) {
    FieldAccess::Data const& data = FieldAccess::data(before);
    PlaceWish const here{data.place.lat_deg, data.place.lon_deg, data.place.altitude_m};
    Field const goal = fieldFrom(recording, origin, here);
    for (Site& site : recording.sites) {
        glm::dvec2 const at = eastNorthOf(site, data.place);
        std::vector<Report> reports = handover(before, goal, site, at, time, seconds);
        for (Report& report : site.reports) {
            if (report.time <= time + 2.2 * seconds) continue;
            double const interval = report.interval_s.value_or(report.time - reports.back().time);
            report.interval_s = std::min(interval, report.time - reports.back().time);
            if (report.levels.empty()) report.levels = handedLevels(goal.instant(report.time), at, site.elevation_m.value_or(0.0));
            reports.push_back(std::move(report));
        }
        site.reports = std::move(reports);
    }
    auto next = std::make_shared<FieldAccess::Data>();
    next->place = data.place;
    next->origin = std::move(origin);
    next->recording = std::move(recording);
    next->carry = carryOf(before, time);
    next->build();
    return FieldAccess::field(std::move(next));
}
}  // namespace luftpost::weather
