#include "engine/weather/field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/field_data.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kNearest = 1.0;       // m: a site's weight grows no further within
constexpr double kFrontNear = 7200.0;  // s: what passes later is not near

/// A site's weight, before they are made to sum to 1.
double nearness(double east, double north) { return 1.0 / (east * east + north * north + kNearest * kNearest); }
}  // namespace

void Field::Data::weights(double east, double north, std::vector<double>& weights) const {
    weights.clear();
    double sum = 0.0;
    for (SiteData const& site : sites) {
        weights.push_back(nearness(east - site.east, north - site.north));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
}

std::vector<double> Field::Data::weights(double east, double north) const {
    std::vector<double> result;
    weights(east, north, result);
    return result;
}

/// All of a site's weather but visibility and layers.
Weather Field::Data::siteWeather(std::size_t index, double time) const {
    SiteData const& site = sites[index];
    FullReport const& report = site.reports[reportIndex(index, time)];
    Weather weather;
    weather.windSurface = site.wind.at(time);
    weather.gust = site.gust.at(time);
    weather.temperature = site.temperature.at(time);
    weather.dewPoint = site.dewPoint.at(time);
    weather.pressureSea = site.pressureSea.at(time);
    weather.precipitation = report.kind;
    weather.precipitationRate = site.rate.rateAt(time);
    weather.thunder = report.thunder;
    weather.cape = site.cape.at(time);
    weather.freezingLevel = site.freezingLevel.at(time);
    weather.snowDepth = site.snowDepth.at(time);
    return weather;
}

Profile Field::Data::profile(std::size_t index, double time) const {
    SiteData const& site = sites[index];
    Profile profile;
    for (LevelCurve const& level : site.levels) {
        auto const i = static_cast<std::size_t>(profile.levels++);
        profile.altitude[i] = level.altitude;
        profile.wind[i] = level.wind.at(time);
    }
    profile.windSurface = site.wind.at(time);
    profile.windMean = site.windMean.at(time);
    profile.gust = site.gust.at(time);
    profile.temperature = site.temperature.at(time);
    profile.pressureSea = site.pressureSea.at(time);
    profile.logVisibility = site.logVisibility.at(time);
    profile.elevation = site.elevation;
    profile.southern = site.southern;
    return profile;
}

Masses Field::Data::masses(std::size_t index, double time) const {
    SiteData const& site = sites[index];
    Masses masses;
    masses.pressureSea = site.pressureSea.at(time);
    masses.add(site.elevation, site.temperature.at(time), site.dewPoint.at(time));
    for (MassCurve const& level : site.masses)
        masses.add(level.altitude, level.temperature.at(time), level.dewPoint ? std::optional{level.dewPoint->at(time)} : std::nullopt);
    return masses;
}

/// The report in whose interval the time lies; before a front's window the one before it.
std::size_t Field::Data::reportIndex(std::size_t index, double time) const {
    SiteData const& site = sites[index];
    auto const at = std::lower_bound(site.times.begin(), site.times.end(), time);
    auto const report = static_cast<std::size_t>(std::min(at - site.times.begin(), static_cast<std::ptrdiff_t>(site.times.size()) - 1));
    for (auto const& [front, window] : site.fronts)
        if (report > 0 && window.from > site.times[report - 1] && window.from < site.times[report] && time < window.from) return report - 1;
    return report;
}

std::vector<Extent> Field::Data::extents(std::size_t index, double time) const {
    SiteData const& site = sites[index];
    bool const clouds = site.knows[static_cast<std::size_t>(Quantity::Clouds)];
    Report const& said = recording.sites[index].reports[reportIndex(index, time)];
    std::vector<Extent> extents;
    for (std::size_t t = 0; t < tracks.size(); ++t) {
        Extent extent;
        if (auto const& curves = site.curves[t]) {
            extent = {true, true, curves->cover.at(time), 0.0, 0.0};
            extent.base = curves->base.at(time);
            extent.top = curves->top.at(time);
        } else {
            extent.knows = clouds && (!said.layersTo_m || said.coverHigh || tracks[t].meanBase < *said.layersTo_m);
        }
        extents.push_back(extent);
    }
    return extents;
}

double Field::Data::readingTimeAt(std::size_t index, double east, double north, double time) const {
    std::vector<PassedBy> passed;
    for (auto const& [front, window] : sites[index].fronts) {
        Front const& line = fronts[front];
        auto const pass = std::find_if(line.passes.begin(), line.passes.end(), [&](FrontPass const& p) { return p.site == index; });
        if (std::abs(time - pass->seen.time) > kFrontReach) continue;
        passed.push_back({pass->seen.time, line.passageAt(east, north) - pass->seen.time});
    }
    return passed.empty() ? time : readingTime(time, passed);
}

Field::Field(std::shared_ptr<Data const> data) : data_{std::move(data)} {}
Field::~Field() = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

FieldInstant Field::instant(core::UtcSeconds time) const {
    Data const& d = *data_;
    auto now = std::make_shared<FieldInstant::Now>();
    now->time = time;
    now->data = data_;
    for (std::size_t i = 0; i < d.sites.size(); ++i) now->sites.push_back(d.siteNow(i, time));
    for (FieldTrack const& track : d.tracks) {
        Layer layer;
        layer.genus = track.genus;
        layer.water = static_cast<float>(genusRow(track.genus).water);
        layer.wind = track.wind.at(time);
        layer.drift = track.wind.integralTo(time) - track.atStart;
        layer.phase = (time - d.start) / 3600.0;
        layer.pattern = track.pattern;
        now->tracks.push_back(layer);
    }
    now->frontal = std::any_of(d.passages.begin(), d.passages.end(), [&](Passage const& p) { return std::abs(time - p.time) < kFrontReach; });
    FieldInstant instant;
    instant.now_ = std::move(now);
    return instant;
}

Weather Field::at(double east, double north, core::UtcSeconds time) const { return instant(time).at(east, north); }

core::UtcSeconds Field::start() const { return data_->start; }
core::UtcSeconds Field::end() const { return data_->end; }
bool Field::covers(core::UtcSeconds time) const {
    return data_->origin.mode == SourceMode::Preset || (time >= data_->start && time <= data_->end);
}
core::Place Field::place() const { return data_->place; }
Origin const& Field::origin() const { return data_->origin; }
Recording const& Field::recording() const { return data_->recording; }
std::vector<std::vector<FieldReport>> const& Field::reports() const { return data_->reports; }
std::size_t Field::sites() const { return data_->sites.size(); }
std::vector<Passage> const& Field::passages() const { return data_->passages; }

std::optional<FrontNear> Field::front(double east, double north, core::UtcSeconds time) const {
    std::optional<FrontNear> nearest;
    double soonest = kFrontNear;
    for (Front const& front : data_->fronts) {
        double const due = front.passageAt(east, north) - time;
        if (std::abs(due) > soonest) continue;
        soonest = std::abs(due);
        nearest = {front.slowness * front.speed(), front.speed(), due * front.speed(), front.width()};
    }
    return nearest;
}

std::vector<unsigned> Field::patterns() const {
    std::vector<unsigned> patterns;
    for (FieldTrack const& track : data_->tracks) patterns.push_back(track.pattern);
    return patterns;
}
glm::dvec2 Field::boundaryDrift(core::UtcSeconds time) const { return data_->boundary.integralTo(time) - data_->boundaryAtStart; }

glm::dvec2 Field::windAt(double east, double north, double altitude, double ground, core::UtcSeconds time) const {
    return instant(time).meanAir(east, north, altitude, ground).wind;
}

double Field::age(core::UtcSeconds time) const {
    if (data_->origin.mode == SourceMode::Preset) return 0.0;
    double newest = data_->start;
    for (SiteData const& site : data_->sites) {
        auto const after = std::upper_bound(site.times.begin(), site.times.end(), time);
        if (after != site.times.begin()) newest = std::max(newest, *(after - 1));
    }
    return std::max(0.0, time - newest);
}

std::string Field::strip(core::UtcSeconds time) const {
    if (data_->origin.mode == SourceMode::Preset) return data_->origin.name;
    if (time < data_->start) return fmt::format("{} · recorded · begins {}", data_->origin.name, core::formatUtc(data_->start));
    SourceMode const from = data_->origin.mode;
    char const* const mode = from == SourceMode::Live ? "live" : from == SourceMode::Stale ? "stale" : "recorded";
    double const minutes = std::floor(age(time) / 60.0);
    std::string const old = minutes < 120.0 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.0f} h", std::floor(minutes / 60.0));
    return fmt::format("{} · {} · report {} old", data_->origin.name, mode, old);
}
}  // namespace luftpost::weather
