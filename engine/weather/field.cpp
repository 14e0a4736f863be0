#include "engine/weather/field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/core/time.h"
#include "engine/weather/field_data.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kNearest = 1000.0;    // m: a site's weight grows no further within
constexpr double kLeastCover = 0.004;  // less is no layer

/// No more layers than a Weather holds: the least ones go, and what is hardly more fades toward them, so that none flashes.
void fitLayers(std::vector<Layer>& layers) {
    if (layers.size() <= kMaxLayers) return;
    std::vector<float> covers;
    for (Layer const& layer : layers) covers.push_back(layer.cover);
    std::sort(covers.rbegin(), covers.rend());
    float const least = covers[kMaxLayers];
    for (Layer& layer : layers) layer.cover *= std::clamp((layer.cover - least) / least, 0.0f, 1.0f);
    std::erase_if(layers, [](Layer const& layer) { return layer.cover <= 0.0f; });
}
}  // namespace

double Field::Data::weight(std::size_t site, double east, double north) const {
    if (sites.size() == 1) return 1.0;
    double sum = 0.0, own = 0.0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        double const de = east - sites[i].east, dn = north - sites[i].north;
        double const weight = 1.0 / (de * de + dn * dn + kNearest * kNearest);
        sum += weight;
        if (i == site) own = weight;
    }
    return own / sum;
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
    profile.visibility = core::exp(site.logVisibility.at(time));
    profile.elevation = site.elevation;
    profile.southern = site.southern;
    return profile;
}

/// The report in whose interval the time lies.
std::size_t Field::Data::reportIndex(std::size_t index, double time) const {
    SiteData const& site = sites[index];
    auto const at = std::lower_bound(site.times.begin(), site.times.end(), time);
    return static_cast<std::size_t>(std::min(at - site.times.begin(), static_cast<std::ptrdiff_t>(site.times.size()) - 1));
}

std::optional<Layer> Field::Data::layer(std::size_t track, std::vector<double> const& weights, double time) const {
    double cover = 0.0, base = 0.0, top = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (sites[i].curves[track]) cover += weights[i] * sites[i].curves[track]->cover.at(time);
    if (cover <= kLeastCover) return std::nullopt;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        if (!sites[i].curves[track]) continue;
        base += weights[i] * sites[i].curves[track]->base.at(time);
        top += weights[i] * sites[i].curves[track]->top.at(time);
        sum += weights[i];
    }
    FieldTrack const& own = tracks[track];
    Layer layer;
    layer.genus = own.genus;
    // Fades in from nothing: the least cover is taken off and grows back over as much again.
    layer.cover = static_cast<float>(std::min({1.0, cover, 2.0 * (cover - kLeastCover)}));
    layer.base = static_cast<float>(base / sum);
    layer.top = static_cast<float>(top / sum);
    layer.water = static_cast<float>(genusRow(own.genus).water);
    layer.wind = own.wind.at(time);
    layer.drift = own.wind.integralTo(time) - own.atStart;
    layer.phase = (time - start) / 3600.0;
    layer.pattern = own.pattern;
    return layer;
}

std::vector<Layer> Field::Data::layers(std::vector<double> const& weights, double time) const {
    std::vector<Layer> found;
    for (std::size_t t = 0; t < tracks.size(); ++t)
        if (auto const one = layer(t, weights, time)) found.push_back(*one);
    fitLayers(found);
    std::stable_sort(found.begin(), found.end(), [](Layer const& a, Layer const& b) { return a.base < b.base; });
    return found;
}

Field::Field(std::unique_ptr<Data const> data) : data_{std::move(data)} {}
Field::~Field() = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

Weather Field::at(double east, double north, core::UtcSeconds time) const {
    Data const& d = *data_;
    std::vector<double> weights;
    for (std::size_t i = 0; i < d.sites.size(); ++i) weights.push_back(d.weight(i, east, north));
    Weather weather;
    weather.gust = weather.temperature = weather.dewPoint = weather.pressureSea = weather.freezingLevel = 0.0;
    double logVisibility = 0.0, wettest = 0.0, nearest = 0.0;
    for (std::size_t i = 0; i < d.sites.size(); ++i) {
        SiteData const& site = d.sites[i];
        double const w = weights[i], rate = site.rate.rateAt(time);
        weather.windSurface += w * site.wind.at(time);
        weather.gust += w * site.gust.at(time);
        weather.temperature += w * site.temperature.at(time);
        weather.dewPoint += w * site.dewPoint.at(time);
        weather.pressureSea += w * site.pressureSea.at(time);
        weather.cape += w * site.cape.at(time);
        weather.freezingLevel += w * site.freezingLevel.at(time);
        weather.snowDepth += w * site.snowDepth.at(time);
        weather.precipitationRate += w * rate;
        logVisibility += w * site.logVisibility.at(time);
        FullReport const& report = site.reports[d.reportIndex(i, time)];
        if (w * rate > wettest) weather.precipitation = report.kind;
        if (w > nearest) weather.thunder = report.thunder;
        wettest = std::max(wettest, w * rate);
        nearest = std::max(nearest, w);
    }
    weather.visibility = core::exp(logVisibility);
    for (Layer const& layer : d.layers(weights, time)) weather.layers[static_cast<std::size_t>(weather.layerCount++)] = layer;
    return weather;
}

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
Profile Field::profile(std::size_t site, core::UtcSeconds time) const { return data_->profile(site, time); }
double Field::siteWeight(std::size_t site, double east, double north) const { return data_->weight(site, east, north); }
glm::dvec2 Field::boundaryDrift(core::UtcSeconds time) const { return data_->boundary.integralTo(time) - data_->boundaryAtStart; }

glm::dvec2 Field::windAt(double east, double north, double altitude, double ground, core::UtcSeconds time) const {
    glm::dvec2 wind{0.0};
    for (std::size_t i = 0; i < sites(); ++i) wind += siteWeight(i, east, north) * weather::windAt(profile(i, time), altitude, ground);
    return wind;
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
    double const minutes = std::floor(age(time) / 60.0);
    std::string const old = minutes < 120.0 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.0f} h", std::floor(minutes / 60.0));
    return fmt::format("{} · recorded · report {} old", data_->origin.name, old);
}
}  // namespace luftpost::weather
