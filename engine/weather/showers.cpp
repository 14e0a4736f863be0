#include "engine/weather/showers.h"

#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/fill.h"

namespace luftpost::weather {
namespace {
constexpr double kHeaviest = 150.0;                    // mm/h, in the middle of the narrowest shaft
constexpr double kMeltFrom = 273.15, kMeltTo = 275.15;  // K, falling snow melts between
constexpr double kReported = 100.0, kAloft = 500.0;    // m above ground: from the report's kind to that of the temperature
constexpr double kHailMelts = 1500.0, kHailGone = 3500.0;  // m below the freezing level

bool isStorm(Genus genus) { return genus == Genus::Cb; }

double liquidByTemperature(double temperature) { return smooth(kMeltFrom, kMeltTo, temperature); }

/// Share of hail in a fall, at most 0.4.
double hailShare(Weather const& weather, double core, double altitude) {
    double const melted = smooth(kHailMelts, kHailGone, weather.freezingLevel - altitude);
    double const strong = smooth(800.0, 2500.0, weather.cape) * smooth(0.6, 1.0, core) * (1.0 - melted);
    double const reported = weather.precipitation == Precipitation::Hail ? smooth(0.3, 0.8, core) : 0.0;
    return 0.4 * std::max(strong, reported);
}
}  // namespace

double liquidAtGround(Precipitation kind, double temperature) {
    switch (kind) {
        case Precipitation::Drizzle:
        case Precipitation::Rain:
        case Precipitation::FreezingRain:
        case Precipitation::Hail: return 1.0;
        case Precipitation::Snow: return 0.0;
        case Precipitation::Sleet: return 0.5;
        default: return liquidByTemperature(temperature);
    }
}

double showerShare(Genus genus) {
    switch (genus) {
        case Genus::Ns:
        case Genus::Cb: return 1.0;
        case Genus::Cu: return 0.4;
        case Genus::As: return 0.1;
        case Genus::Sc:
        case Genus::St: return 0.05;
        default: return 0.0;
    }
}

namespace {
/// The rank under which something falls from a layer, and over how much of it it grows to its most.
struct Outline { double threshold, edge; };
Outline showerOutline(Genus genus, double cover) {
    // A storm's rain falls from its towers and grows to their middle; of the others only the rim is weaker, and of a closed layer nothing.
    double const threshold = isStorm(genus) ? cover * (0.5 + 0.35 * cover) : cover + 0.25 * smooth(0.8, 1.0, cover);
    return {threshold, std::max(isStorm(genus) ? threshold : std::min(0.25, cover), 0.01)};
}
}  // namespace

Inside showerInside(Genus genus, double rank, double cover) {
    if (!(cover > 0.0)) return {};
    Outline const outline = showerOutline(genus, cover);
    return insideOf(rank, outline.threshold, outline.edge);
}

double Shower::rate(double inside, double altitude) const {
    if (!(inside > 0.0)) return 0.0;
    double const dry = std::max(from - altitude, 0.0), left = root * std::sqrt(inside) - drying * dry * dry;
    return left > 0.0 ? left * left : 0.0;
}

glm::dvec2 Shower::source(double base, double altitude) const {
    double const below = std::max(base - altitude, 0.0);
    return lag * (below * below);
}

namespace {
/// g/m3 of vapour that saturates air of a temperature (Tetens 1930; Magnus' coefficients of Alduchov and Eskridge 1996).
double saturation(double temperature) {
    double const celsius = temperature - 273.15;
    return 610.94 * core::exp(17.625 * celsius / (celsius + 243.04)) / (461.5 * temperature) * 1e3;
}

/// What the root of a rate loses per m2 of squared depth: 2e-4 per g/m2 of deficit (shaders/lib/falling.glsl), which grows with the spread
/// of a stirred layer, 8 K/km, at 6 % of saturation per K.
double dryingOf(double temperature) { return 2e-4 * 0.5 * 0.06 * 8e-3 * saturation(temperature); }

/// The mean over the plane of what reaches the ground, mm/h, and its slope by the root.
struct Mean { double rate = 0.0, slope = 0.0; };
Mean meanAtGround(Genus genus, double cover, double root, double loss) {
    // Midpoints of the rank over what precipitates.
    constexpr int kStrips = 16;
    Outline const outline = showerOutline(genus, cover);
    double const strip = std::min(outline.threshold, 1.0) / kStrips;
    Mean mean;
    for (int i = 0; i < kStrips; ++i) {
        double const side = std::sqrt(insideOf((i + 0.5) * strip, outline.threshold, outline.edge).here), left = root * side - loss;
        if (left <= 0.0) continue;
        mean.rate += left * left * strip;
        mean.slope += 2.0 * side * left * strip;
    }
    return mean;
}

/// The root under the base that brings `rate` to the ground in the mean over the plane.
double rootFor(Genus genus, double cover, double rate, double loss) {
    double const inside = showerInside(genus, 1.0, cover).mean, most = std::sqrt(kHeaviest) + loss;
    double root = std::sqrt(rate / std::max(inside, 1e-6)) + loss;
    for (int i = 0; i < 8; ++i) {
        Mean const mean = meanAtGround(genus, cover, root, loss);
        if (!(mean.slope > 0.0)) return most;
        root += (rate - mean.rate) / mean.slope;
        if (std::abs(rate - mean.rate) < 1e-4 * rate) break;
    }
    return std::clamp(root, loss, most);
}

constexpr double kEnough = 0.004;  // cover of rain clouds from which on the others do not rain
constexpr double kMostLost = 1.5;  // of the root that reaches the ground
constexpr double kRainSpeed = 6.0, kSnowSpeed = 1.5;  // m/s

glm::dvec2 lagOf(Weather const& weather, Layer const& layer, double ground) {
    double const depth = std::max(static_cast<double>(layer.base) - ground, 100.0);
    double const speed = weather.precipitation == Precipitation::Snow ? kSnowSpeed : kRainSpeed;
    // The wind falls from the layer's to the ground's, evenly with height.
    return (layer.wind - weather.windSurface) / (2.0 * depth * speed);
}
}  // namespace

std::array<Shower, kMaxLayers> showersOf(Weather const& weather, std::array<double, kMaxLayers> const& visible) {
    std::array<Shower, kMaxLayers> showers{};
    if (weather.precipitation == Precipitation::None || !(weather.precipitationRate > 0.0)) return showers;
    auto const count = static_cast<std::size_t>(weather.layerCount);
    // Where there is a cloud that rains it is that one, not the cumulus beside it.
    double willing = 0.0;
    for (std::size_t i = 0; i < count; ++i) willing += showerShare(weather.layers[i].genus) >= 1.0 ? visible[i] : 0.0;
    double const others = 1.0 - smooth(0.0, kEnough, willing);
    auto const weight = [&](std::size_t i) {
        double const share = showerShare(weather.layers[i].genus);
        return share * (share < 1.0 ? others : 1.0) * showerInside(weather.layers[i].genus, 1.0, visible[i]).mean;
    };
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += weight(i);
    double const ground = weather.condensationLevel - condensationHeight(weather.temperature, weather.dewPoint);
    for (std::size_t i = 0; i < count; ++i) {
        Layer const& layer = weather.layers[i];
        if (!(weight(i) > 0.0)) continue;
        Shower& shower = showers[i];
        shower.storm = isStorm(layer.genus);
        shower.from = std::min(weather.condensationLevel, static_cast<double>(layer.base));
        double const rate = weather.precipitationRate * weight(i) / sum, dry = std::max(shower.from - ground, 1.0);
        // Air through which next to nothing falls and yet reaches the ground is not that dry.
        double const most = kMostLost * std::sqrt(rate / showerInside(layer.genus, 1.0, visible[i]).mean);
        shower.drying = std::min(dryingOf(weather.temperature), most / (dry * dry));
        shower.root = rootFor(layer.genus, visible[i], rate, shower.drying * dry * dry);
        shower.lag = lagOf(weather, layer, ground);
    }
    return showers;
}

double gathered(double altitude, double base, double top) { return 1.0 - smooth(base, std::max(top, base + 20.0), altitude); }

Falling fallingOf(Weather const& weather, double rate, double core, double height, double altitude, double temperature) {
    double const aloft = smooth(kReported, weather.precipitation == Precipitation::FreezingRain ? 3.0 * kAloft : kAloft, height);
    double const byReport = liquidAtGround(weather.precipitation, temperature);
    double const liquid = byReport + (liquidByTemperature(temperature) - byReport) * aloft;
    Falling fall;
    fall.hail = rate * hailShare(weather, core, altitude);
    fall.rain = (rate - fall.hail) * liquid;
    fall.snow = rate - fall.hail - fall.rain;
    return fall;
}

double rainWater(double rate) { return rate > 0.0 ? 7.2e-5 * core::pow(rate, 0.88) : 0.0; }

double fallExtinction(double rain, double snow) {
    double sum = 0.0;
    if (rain > 0.0) sum += 2.24e-3 * core::pow(1e3 * rainWater(rain), 0.75);
    if (snow > 0.0) sum += 10.36e-3 * core::pow(snow / 3.6, 0.78);
    return sum;
}
}  // namespace luftpost::weather
