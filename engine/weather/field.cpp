#include "engine/weather/field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/core/time.h"
#include "engine/weather/field_data.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kNearest = 1000.0;    // m: a site's weight grows no further within
constexpr double kLeastCover = 0.004;  // less is no layer

constexpr double kGasConstant = 287.05287;  // J/(kg K), dry air (ISO 2533)
constexpr double kLapse = 0.0065;           // K/m
constexpr double kTropopause = 11000.0;     // m

struct Thermo {
    double temperature, pressure;
};

/// The standard atmosphere's lapse from the temperature and pressure reduced to sea level; isothermal above 11 km (ISO 2533).
Thermo thermoAt(double temperatureSea, double pressureSea, double altitude) {
    static double const exponent = core::kGravity / (kGasConstant * kLapse);
    double const below = std::min(altitude, kTropopause);
    double const temperature = temperatureSea - kLapse * below;
    double pressure = pressureSea * core::pow(std::max(temperature, 100.0) / temperatureSea, exponent);
    if (altitude > kTropopause) pressure *= core::exp(-core::kGravity * (altitude - kTropopause) / (kGasConstant * temperature));
    return {temperature, pressure};
}

/// A site's weight, before they are made to sum to 1.
double nearness(double east, double north) { return 1.0 / (east * east + north * north + kNearest * kNearest); }

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
        double const weight = nearness(east - sites[i].east, north - sites[i].north);
        sum += weight;
        if (i == site) own = weight;
    }
    return own / sum;
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

/// The report in whose interval the time lies.
std::size_t Field::Data::reportIndex(std::size_t index, double time) const {
    SiteData const& site = sites[index];
    auto const at = std::lower_bound(site.times.begin(), site.times.end(), time);
    return static_cast<std::size_t>(std::min(at - site.times.begin(), static_cast<std::ptrdiff_t>(site.times.size()) - 1));
}

namespace {
/// The track's layer over a point, by the sites' weights there.
std::optional<Layer> layerOf(TrackNow const& track, std::vector<double> const& weights) {
    double cover = 0.0, base = 0.0, top = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        Extent const& extent = track.sites[i];
        if (!extent.present) continue;
        cover += weights[i] * extent.cover;
        base += weights[i] * extent.base;
        top += weights[i] * extent.top;
        sum += weights[i];
    }
    if (cover <= kLeastCover) return std::nullopt;
    Layer layer = track.layer;
    // Fades in from nothing: the least cover is taken off and grows back over as much again.
    layer.cover = static_cast<float>(std::min({1.0, cover, 2.0 * (cover - kLeastCover)}));
    layer.base = static_cast<float>(base / sum);
    layer.top = static_cast<float>(top / sum);
    return layer;
}
}  // namespace

bool FieldInstant::uniform() const { return now_->sites.size() == 1; }
core::UtcSeconds FieldInstant::time() const { return now_->time; }

Weather FieldInstant::at(double east, double north) const {
    std::vector<SiteNow> const& sites = now_->sites;
    std::vector<double> weights;
    for (SiteNow const& site : sites) weights.push_back(nearness(east - site.east, north - site.north));
    double const sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    Weather weather;
    weather.gust = weather.temperature = weather.dewPoint = weather.pressureSea = weather.freezingLevel = 0.0;
    double logVisibility = 0.0, wettest = 0.0, nearest = 0.0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        Weather const& own = sites[i].weather;
        double const w = weights[i] /= sum, rain = w * own.precipitationRate;
        weather.windSurface += w * own.windSurface;
        weather.gust += w * own.gust;
        weather.temperature += w * own.temperature;
        weather.dewPoint += w * own.dewPoint;
        weather.pressureSea += w * own.pressureSea;
        weather.cape += w * own.cape;
        weather.freezingLevel += w * own.freezingLevel;
        weather.snowDepth += w * own.snowDepth;
        weather.precipitationRate += rain;
        logVisibility += w * sites[i].profile.logVisibility;
        if (rain > wettest) weather.precipitation = own.precipitation;
        if (w > nearest) weather.thunder = own.thunder;
        wettest = std::max(wettest, rain);
        nearest = std::max(nearest, w);
    }
    weather.visibility = core::exp(logVisibility);
    std::vector<Layer> layers;
    for (TrackNow const& track : now_->tracks)
        if (auto const one = layerOf(track, weights)) layers.push_back(*one);
    fitLayers(layers);
    std::stable_sort(layers.begin(), layers.end(), [](Layer const& a, Layer const& b) { return a.base < b.base; });
    for (Layer const& one : layers) weather.layers[static_cast<std::size_t>(weather.layerCount++)] = one;
    return weather;
}

MeanAir FieldInstant::meanAir(double east, double north, double altitude, double ground) const {
    double sum = 0.0;
    for (SiteNow const& site : now_->sites) sum += nearness(east - site.east, north - site.north);
    MeanAir mean;
    mean.gust = mean.logVisibility = 0.0;
    double temperatureSea = 0.0, pressureSea = 0.0;
    for (SiteNow const& site : now_->sites) {
        Profile const& profile = site.profile;
        double const w = uniform() ? 1.0 : nearness(east - site.east, north - site.north) / sum;
        mean.wind += w * windAt(profile, altitude, ground);
        mean.windSurface += w * profile.windSurface;
        mean.gust += w * profile.gust;
        mean.logVisibility += w * profile.logVisibility;
        temperatureSea += w * (profile.temperature + kLapse * profile.elevation);
        pressureSea += w * profile.pressureSea;
    }
    auto const [temperature, pressure] = thermoAt(temperatureSea, pressureSea, altitude);
    mean.temperature = temperature;
    mean.pressure = pressure;
    return mean;
}

Field::Field(std::shared_ptr<Data const> data) : data_{std::move(data)} {}
Field::~Field() = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

FieldInstant Field::instant(core::UtcSeconds time) const {
    Data const& d = *data_;
    auto now = std::make_shared<FieldInstant::Now>();
    now->time = time;
    for (std::size_t i = 0; i < d.sites.size(); ++i) 
        now->sites.push_back({d.sites[i].east, d.sites[i].north, d.siteWeather(i, time), d.profile(i, time)});
    for (std::size_t t = 0; t < d.tracks.size(); ++t) {
        TrackNow track;
        bool any = false;
        for (SiteData const& site : d.sites) {
            Extent extent;
            if (auto const& curves = site.curves[t]) {
                double const cover = curves->cover.at(time);
                extent = {true, cover, curves->base.at(time), curves->top.at(time)};
                any = any || cover > 0.0;
            }
            track.sites.push_back(extent);
        }
        if (!any) continue;
        FieldTrack const& own = d.tracks[t];
        track.layer.genus = own.genus;
        track.layer.water = static_cast<float>(genusRow(own.genus).water);
        track.layer.wind = own.wind.at(time);
        track.layer.drift = own.wind.integralTo(time) - own.atStart;
        track.layer.phase = (time - d.start) / 3600.0;
        track.layer.pattern = own.pattern;
        now->tracks.push_back(std::move(track));
    }
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
    double const minutes = std::floor(age(time) / 60.0);
    std::string const old = minutes < 120.0 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.0f} h", std::floor(minutes / 60.0));
    return fmt::format("{} · recorded · report {} old", data_->origin.name, old);
}
}  // namespace luftpost::weather
