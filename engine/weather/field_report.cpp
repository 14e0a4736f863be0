// The field over a site, put as a report: what both neighbours said stays said, the rest is listed as filled.
#include <fmt/format.h>

#include <algorithm>

#include "engine/core/math.h"
#include "engine/weather/field_data.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kZeroCelsius = 273.15;

/// The reports on either side of a time; the same twice on a report and outside the recording.
struct Neighbours {
    std::size_t before, after;
};

Neighbours neighboursOf(std::vector<double> const& times, double time) {
    auto const at = std::lower_bound(times.begin(), times.end(), time);
    if (at == times.end()) return {times.size() - 1, times.size() - 1};
    auto const after = static_cast<std::size_t>(at - times.begin());
    return *at == time || after == 0 ? Neighbours{after, after} : Neighbours{after - 1, after};
}

/// The value where it was said on both sides; else empty, and listed.
std::optional<double> told(bool said, double value, std::string const& place, Filled& filled) {
    if (said) return value;
    filled[place] = value;
    return std::nullopt;
}

/// Which parts of a layer were reported.
struct LayerSaid {
    bool genus = false, cover = false, base = false, top = false;
};

/// What a report said of the layer that a track stands for: an absent layer counts as said, if layers were.
LayerSaid saidOf(Report const& report, SiteTrack const& track, std::size_t k) {
    if (!report.layers) return {};
    if (track.layer[k] < 0) return {true, true, true, true};
    auto const l = static_cast<std::size_t>(track.layer[k]);
    if (l >= report.layers->size()) return {};
    ReportedLayer const& layer = (*report.layers)[l];
    return {layer.genus.has_value(), layer.cover.has_value(), layer.base_m.has_value(), layer.top_m.has_value()};
}

LayerSaid both(LayerSaid a, LayerSaid b) { return {a.genus && b.genus, a.cover && b.cover, a.base && b.base, a.top && b.top}; }

/// The layer as a report has it, what nobody said listed under "layers[i].".
ReportedLayer reportedLayer(Layer const& layer, LayerSaid said, std::size_t i, Filled& filled) {
    auto const place = [i](char const* part) { return fmt::format("layers[{}].{}", i, part); };
    ReportedLayer reported;
    if (said.genus) reported.genus = layer.genus;
    else filled[place("genus")] = std::string{genusName(layer.genus)};
    reported.cover = told(said.cover, static_cast<double>(layer.cover), place("cover"), filled);
    reported.base_m = told(said.base, static_cast<double>(layer.base), place("base_m"), filled);
    reported.top_m = told(said.top, static_cast<double>(layer.top), place("top_m"), filled);
    return reported;
}
/// All but the layers.
void reportSurface(Report const& left, Report const& right, Weather const& weather, FieldReport& answer) {
    Report& r = answer.said;
    Filled& filled = answer.filled;
    double const speed = glm::length(weather.windSurface);
    r.speed_mps = told(left.speed_mps && right.speed_mps, speed, "wind.speed_mps", filled);
    r.gust_mps = told(right.gust_mps.has_value(), weather.gust, "wind.gust_mps", filled);
    if (speed > 0.0) r.from_deg = told(left.from_deg && right.from_deg, windFrom_deg(weather.windSurface), "wind.from_deg", filled);
    bool const seen = left.visibility_m && right.visibility_m && !left.visibilityIsMinimum && !right.visibilityIsMinimum;
    r.visibility_m = told(seen, weather.visibility, "visibility_m", filled);
    if (!seen && left.visibility_m && right.visibility_m) {
        r.visibility_m = std::min(*left.visibility_m, *right.visibility_m);
        r.visibilityIsMinimum = true;
    }
    r.temperature_c = told(left.temperature_c && right.temperature_c, weather.temperature - kZeroCelsius, "temperature_c", filled);
    r.dew_point_c = told(left.dew_point_c && right.dew_point_c, weather.dewPoint - kZeroCelsius, "dew_point_c", filled);
    r.pressure_hpa = told(left.pressure_hpa && right.pressure_hpa, weather.pressureSea / 100.0, "pressure_hpa", filled);
    r.rate_mm_h = told(right.rate_mm_h.has_value(), weather.precipitationRate, "precipitation.rate_mm_h", filled);
    r.precipitationKind = right.precipitationKind;
    if (!r.precipitationKind || *r.precipitationKind == Precipitation::Unknown)
        filled["precipitation.kind"] = std::string{precipitationName(weather.precipitation)};
    r.thunder = right.thunder;
    if (!r.thunder) filled["thunder"] = weather.thunder;
}
}  // namespace

std::vector<SiteReport> Field::listedReports() const {
    Data const& d = *data_;
    std::vector<SiteReport> listed;
    for (ListedReport const& entry : d.recording.order) {
        if (!entry.superseded) {
            listed.push_back({entry.site, d.reports[entry.site][entry.report]});
            continue;
        }
        Site const& site = d.recording.sites[entry.site];
        Site const alone{site.name, site.lat_deg, site.lon_deg, site.elevation_m, {site.superseded[entry.report]}, {}};
        listed.push_back({entry.site, {alone.reports[0], fullReports(alone)[0].filled}});
    }
    if (d.recording.order.empty())
        for (std::size_t i = 0; i < d.reports.size(); ++i)
            for (FieldReport const& report : d.reports[i]) listed.push_back({i, report});
    return listed;
}

FieldReport Field::reportAt(std::size_t site, FieldInstant const& now) const {
    Data const& d = *data_;
    SiteData const& own = d.sites[site];
    auto const [a, b] = neighboursOf(own.times, now.time());
    std::vector<Report> const& reports = d.recording.sites[site].reports;
    Report const &left = reports[a], &right = reports[b];
    Weather const weather = now.at(own.east, own.north);
    FieldReport answer;
    Report& r = answer.said;
    r.time = now.time();
    reportSurface(left, right, weather, answer);
    if (!d.recording.sites[site].elevation_m) answer.filled["elevation_m"] = own.elevation;
    if (a == b) r.verticalVisibility_m = left.verticalVisibility_m;
    r.layersTo_m = right.layersTo_m;
    if (left.layers || right.layers) r.layers.emplace();
    for (std::size_t i = 0; i < static_cast<std::size_t>(weather.layerCount); ++i) {
        Layer const& layer = weather.layers[i];
        auto const track = std::find_if(d.tracks.begin(), d.tracks.end(), [&](FieldTrack const& t) { return t.pattern == layer.pattern; });
        auto const ownTrack = own.trackOf[static_cast<std::size_t>(track - d.tracks.begin())];
        LayerSaid const said = ownTrack ? both(saidOf(left, own.tracks[*ownTrack], a), saidOf(right, own.tracks[*ownTrack], b)) : LayerSaid{};
        ReportedLayer const reported = reportedLayer(layer, said, i, answer.filled);
        if (r.layers) r.layers->push_back(reported);
    }
    return answer;
}
}  // namespace luftpost::weather
