// The words of the weather: genus, layer, the weather at one point and time. Plain data, SI.
#pragma once
#include <array>

#include <glm/glm.hpp>

namespace luftpost::weather {
/// The ten WMO genera; fog is the eleventh row of the same table.
enum class Genus : int { Ci, Cc, Cs, Ac, As, Ns, Sc, St, Cu, Cb, Fog };
inline constexpr int kGenera = 11;
inline constexpr int kMaxLayers = 4;

enum class Precipitation : int { None, Drizzle, Rain, Snow, Sleet, Hail, FreezingRain, Unknown };

/// One cloud layer as the field uses it: every value known (reported or filled).
struct Layer {
    Genus genus = Genus::Cu;
    float cover = 0.0f;          // 0..1, share of the ground seen from straight above
    float base = 1000.0f;        // m above sea level
    float top = 2000.0f;         // m above sea level
    float water = 0.0003f;       // kg/m3, condensed water in the core
    glm::dvec2 wind{0.0};        // m/s, east and north, at the middle of the layer
    glm::dvec2 drift{0.0};       // m, east and north: the layer's wind integrated from the recording's start
    double phase = 0.0;          // h since the recording's start: the pattern changes slowly with it
    unsigned pattern = 0;        // seed of this layer's pattern: stays the same as long as the layer lives
};

/// The weather over one point at one time.
struct Weather {
    int layerCount = 0;
    std::array<Layer, kMaxLayers> layers{};  // sorted by base
    glm::dvec2 windSurface{0.0};             // m/s, east and north, 10 m above the ground, where the air goes to
    double gust = 0.0;                       // m/s, the largest of the interval
    double visibility = 6.0e4;               // m, 5 % contrast
    double temperature = 288.15;             // K, 2 m above the ground
    double dewPoint = 281.15;                // K
    double pressureSea = 101325.0;           // Pa
    Precipitation precipitation = Precipitation::None;
    double precipitationRate = 0.0;          // mm/h
    bool thunder = false;
    double cape = 0.0;                       // J/kg
    double freezingLevel = 3000.0;           // m above sea level
    double condensationLevel = 1500.0;       // m above sea level: where air lifted from the ground forms cloud
    double snowDepth = 0.0;                  // m
};
}  // namespace luftpost::weather
