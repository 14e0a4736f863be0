#include "engine/weather/showers.h"

#include "engine/core/math.h"

namespace luftpost::weather {
namespace {
constexpr double kHeaviest = 150.0;                    // mm/h, in the middle of the narrowest shaft
constexpr double kMeltFrom = 273.15, kMeltTo = 275.15;  // K, falling snow melts between
constexpr double kReported = 100.0, kAloft = 500.0;    // m above ground: from the report's kind to that of the temperature
constexpr double kHailMelts = 1500.0, kHailGone = 3500.0;  // m below the freezing level

bool isStorm(Genus genus) { return genus == Genus::Cb; }

double liquidByTemperature(double temperature) { return smooth(kMeltFrom, kMeltTo, temperature); }

/// Liquid share near the ground: the report knows.
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

/// Share of hail in a fall, at most 0.4.
double hailShare(Weather const& weather, double core, double altitude) {
    double const melted = smooth(kHailMelts, kHailGone, weather.freezingLevel - altitude);
    double const strong = smooth(800.0, 2500.0, weather.cape) * smooth(0.6, 1.0, core) * (1.0 - melted);
    double const reported = weather.precipitation == Precipitation::Hail ? smooth(0.3, 0.8, core) : 0.0;
    return 0.4 * std::max(strong, reported);
}
}  // namespace

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

Inside showerInside(Genus genus, double rank, double cover) {
    // A storm's rain grows to its middle; of the others only the rim is weaker, and of a closed layer nothing.
    double const edge = isStorm(genus) ? cover : std::min(0.25, cover), closed = isStorm(genus) ? 0.0 : 0.25 * smooth(0.8, 1.0, cover);
    return insideOf(rank, cover + closed, std::max(edge, 0.01));
}

double showerRate(Weather const& weather) {
    if (weather.precipitation == Precipitation::None) return 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(weather.layerCount); ++i) {
        Layer const& layer = weather.layers[i];
        sum += showerShare(layer.genus) * showerInside(layer.genus, 1.0, static_cast<double>(layer.cover)).mean;
    }
    if (sum <= 0.0) return 0.0;
    // The heaviest point has all its layers in full.
    return std::min(weather.precipitationRate / sum, kHeaviest);
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
