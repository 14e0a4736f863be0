#include "engine/weather/stirring.h"

#include "engine/core/math.h"
#include "engine/weather/fill.h"
#include "engine/weather/genera.h"
#include "engine/weather/ramp.h"

namespace luftpost::weather {
namespace {
constexpr double kLag = 5400.0;                // s: the ground warms after the sun
constexpr double kStandard = 288.15, kLapse = 0.0065;  // K at sea level, K/m (ISO 2533)
constexpr double kHeatFlux = 0.2;              // K m/s under a high sun over dry grass (Stull 1988)
constexpr double kBuoyancy = 9.80665 / 300.0;  // m/(s2 K)
constexpr double kThin = 0.33;                 // of the sun that a high layer's cover takes away

/// K: how much warmer it is than in the standard atmosphere at the height of the reports.
double warmth(Weather const& weather) {
    double const elevation = weather.condensationLevel - condensationHeight(weather.temperature, weather.dewPoint);
    return weather.temperature - (kStandard - kLapse * elevation);
}

/// Share of the sun that is left under a cover: Kasten and Czeplak (1980).
double sunLeft(double cover) { return 1.0 - 0.75 * core::pow(cover, 3.4); }
}  // namespace

double sunHeating(core::Place const& place, core::UtcSeconds time) {
    double const mean = 0.5 * (sunHeight(place.lat_deg, place.lon_deg, time) + sunHeight(place.lat_deg, place.lon_deg, time - kLag));
    return smooth(0.05, 0.65, mean);
}

double shadingCover(Weather const& weather) {
    double open = 1.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(weather.layerCount); ++i) {
        Layer const& layer = weather.layers[i];
        open *= 1.0 - static_cast<double>(layer.cover) * (levelOf(layer.genus) == Level::High ? kThin : 1.0);
    }
    return std::clamp(1.0 - open, 0.0, 1.0);
}

double convectiveSpeed(double heating, double depth) {
    double const cube = kBuoyancy * kHeatFlux * heating * depth;
    return cube > 0.0 ? core::pow(cube, 1.0 / 3.0) : 0.0;
}

Stirring stirringOf(Weather const& weather, double sun) {
    double const cover = shadingCover(weather), wind = glm::length(weather.windSurface);
    double const rain = weather.precipitation == Precipitation::None ? 0.0 : weather.precipitationRate;
    Stirring s;
    s.heating = sun * sunLeft(cover) * (1.0 - smooth(0.1, 1.0, rain)) * (1.0 - 0.8 * smooth(0.0, 0.03, weather.snowDepth));
    s.stable = (1.0 - smooth(0.0, 0.05, sun)) * (1.0 - 0.8 * cover) / (1.0 + wind * wind / 25.0);
    double cumulus = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(weather.layerCount); ++i)
        if (weather.layers[i].genus == Genus::Cu || weather.layers[i].genus == Genus::Cb) cumulus += static_cast<double>(weather.layers[i].cover);
    s.dry = smooth(0.5, 6.0, warmth(weather)) * (1.0 - smooth(0.02, 0.12, cumulus));
    s.depth = std::clamp(115.0 * (weather.temperature - weather.dewPoint), 250.0, 2500.0) * (0.4 + 0.6 * s.heating);
    return s;
}
}  // namespace luftpost::weather
