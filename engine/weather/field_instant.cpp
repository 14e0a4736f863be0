// The field at one moment: the sites blended, each quantity among those that know it.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/field_data.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kLeastCover = 0.004;  // less is no layer
constexpr double kLapse = 0.0065;      // K/m: what sites at different heights are compared by

/// How much each site counts for a quantity at a point: its weight among the sites that know the quantity, among all where
/// none does.
class Shares {
public:
    Shares(FieldAccess::Data const& data, double east, double north) : sites_{data.sites} {
        data.weights(east, north, weights_);
        for (std::size_t q = 0; q < kQuantities; ++q)
            for (std::size_t i = 0; i < sites_.size(); ++i) sums_[q] += sites_[i].knows[q] ? weights_[i] : 0.0;
    }
    double of(Quantity quantity, std::size_t site) const {
        auto const q = static_cast<std::size_t>(quantity);
        if (sums_[q] <= 0.0) return weights_[site];
        return sites_[site].knows[q] ? weights_[site] / sums_[q] : 0.0;
    }
    double whole(std::size_t site) const { return weights_[site]; }

private:
    std::vector<SiteData> const& sites_;
    static thread_local std::vector<double> weights_;  // they sum to 1; one Shares at a time in a thread: nothing is allocated for a sample of air
    std::array<double, kQuantities> sums_{};
};

thread_local std::vector<double> Shares::weights_;

/// A track over a point, as the sites that know of it have it.
struct Blend {
    double cover = 0.0, known = 0.0, base = 0.0, top = 0.0, present = 0.0;
    void add(Extent const& extent, double weight) {
        if (extent.knows) {
            cover += weight * extent.cover;
            known += weight;
        }
        if (!extent.present) return;
        base += weight * extent.base;
        top += weight * extent.top;
        present += weight;
    }
};

std::optional<Layer> layerOf(Layer layer, Blend const& blend) {
    double const cover = blend.known > 0.0 ? blend.cover / blend.known : 0.0;
    if (cover <= kLeastCover) return std::nullopt;
    // Fades in from nothing: the least cover is taken off and grows back over as much again.
    layer.cover = static_cast<float>(std::min({1.0, cover, 2.0 * (cover - kLeastCover)}));
    layer.base = static_cast<float>(blend.base / blend.present);
    layer.top = static_cast<float>(blend.top / blend.present);
    return layer;
}

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

void takeLayers(std::vector<Layer> const& tracks, std::vector<Blend> const& blends, Weather& weather) {
    std::vector<Layer> layers;
    for (std::size_t t = 0; t < tracks.size(); ++t)
        if (auto const one = layerOf(tracks[t], blends[t])) layers.push_back(*one);
    fitLayers(layers);
    std::stable_sort(layers.begin(), layers.end(), [](Layer const& a, Layer const& b) { return a.base < b.base; });
    for (Layer const& one : layers) weather.layers[static_cast<std::size_t>(weather.layerCount++)] = one;
}
}  // namespace

bool FieldInstant::uniform() const { return now_->sites.size() == 1 && !now_->frontal; }
core::UtcSeconds FieldInstant::time() const { return now_->time; }

SiteNow const& FieldInstant::Now::site(std::size_t index, double east, double north, std::optional<SiteNow>& own) const {
    if (!frontal) return sites[index];
    double const then = data->readingTimeAt(index, east, north, time);
    if (std::abs(then - time) < 1e-3) return sites[index];
    return own.emplace(data->siteNow(index, then));
}

Weather FieldInstant::at(double east, double north) const {
    Field::Data const& data = *now_->data;
    Shares const shares{data, east, north};
    Weather weather;
    weather.gust = weather.temperature = weather.dewPoint = weather.pressureSea = weather.freezingLevel = 0.0;
    double logVisibility = 0.0, wettest = 0.0, nearest = 0.0, elevation = 0.0;
    std::vector<Blend> blends(now_->tracks.size());
    std::optional<SiteNow> moved;
    for (std::size_t i = 0; i < now_->sites.size(); ++i) {
        SiteNow const& site = now_->site(i, east, north, moved);
        Weather const& own = site.weather;
        double const rain = shares.of(Quantity::Precipitation, i) * own.precipitationRate, w = shares.of(Quantity::Clouds, i);
        weather.windSurface += shares.of(Quantity::Wind, i) * own.windSurface;
        weather.gust += shares.of(Quantity::Gust, i) * own.gust;
        weather.temperature += shares.of(Quantity::Temperature, i) * (own.temperature + kLapse * data.sites[i].elevation);
        weather.dewPoint += shares.of(Quantity::DewPoint, i) * own.dewPoint;
        weather.pressureSea += shares.of(Quantity::Pressure, i) * own.pressureSea;
        weather.cape += shares.of(Quantity::Cape, i) * own.cape;
        weather.freezingLevel += shares.of(Quantity::FreezingLevel, i) * own.freezingLevel;
        weather.snowDepth += shares.of(Quantity::Snow, i) * own.snowDepth;
        weather.precipitationRate += rain;
        logVisibility += shares.of(Quantity::Visibility, i) * site.profile.logVisibility;
        elevation += shares.whole(i) * data.sites[i].elevation;
        if (rain > wettest) weather.precipitation = own.precipitation;
        if (shares.of(Quantity::Precipitation, i) > nearest) weather.thunder = own.thunder;
        wettest = std::max(wettest, rain);
        nearest = std::max(nearest, shares.of(Quantity::Precipitation, i));
        for (std::size_t t = 0; t < blends.size(); ++t) blends[t].add(site.extents[t], w);
    }
    weather.temperature -= kLapse * elevation;
    weather.dewPoint = std::min(weather.dewPoint, weather.temperature);
    weather.visibility = core::exp(logVisibility);
    weather.condensationLevel = elevation + condensationHeight(weather.temperature, weather.dewPoint);
    takeLayers(now_->tracks, blends, weather);
    return weather;
}

MeanAir FieldInstant::meanAir(double east, double north, double altitude, double ground) const {
    Field::Data const& data = *now_->data;
    Shares const shares{data, east, north};
    MeanAir mean;
    mean.gust = mean.logVisibility = mean.temperature = mean.dewPoint = mean.pressure = 0.0;
    std::optional<SiteNow> moved;
    for (std::size_t i = 0; i < now_->sites.size(); ++i) {
        SiteNow const& site = now_->site(i, east, north, moved);
        double const wind = shares.of(Quantity::Wind, i);
        MassAt const mass = massAt(site.masses, altitude);
        mean.wind += wind * windAt(site.profile, altitude, ground);
        mean.windSurface += wind * site.profile.windSurface;
        mean.gust += shares.of(Quantity::Gust, i) * site.profile.gust;
        mean.logVisibility += shares.of(Quantity::Visibility, i) * site.profile.logVisibility;
        mean.temperature += shares.of(Quantity::Temperature, i) * mass.temperature;
        mean.dewPoint += shares.of(Quantity::DewPoint, i) * mass.dewPoint;
        mean.pressure += shares.of(Quantity::Pressure, i) * mass.pressure;
    }
    return mean;
}
}  // namespace luftpost::weather
