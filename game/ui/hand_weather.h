// Weather by the player's hand: what the panel's controls hold, made from the present weather and made into a recording.
// Pure functions over plain data.
#pragma once
#include <vector>

#include "engine/core/frames.h"
#include "engine/weather/recording.h"
#include "engine/weather/weather.h"

namespace luftpost::ui {
/// One layer as the hand sets it. Heights in m above sea level.
struct HandLayer {
    weather::Genus genus = weather::Genus::Cu;
    double eighths = 3.0;  // 0..8
    double base_m = 1500.0, top_m = 2300.0;
    bool operator==(HandLayer const&) const = default;
};

/// All controls of the play mode, in the units on the screen.
struct HandWeather {
    double from_deg = 270.0;  // true, where the wind comes from
    double speed_mps = 3.0, gust_mps = 5.0;  // 10 m above ground
    double visibility_km = 40.0;
    weather::Precipitation kind = weather::Precipitation::None;
    double rate_mm_h = 0.0;
    bool thunder = false;
    double temperature_c = 15.0, dewPoint_c = 8.0;  // 2 m above ground
    double pressure_hpa = 1013.25;                  // at sea level
    double cape_j_kg = 0.0;                         // what cumulus and thermals live on
    std::vector<HandLayer> layers;                  // at most weather::kMaxLayers
    bool operator==(HandWeather const&) const = default;
};

struct HandRange {
    double least, most;
};
inline constexpr HandRange kHandSpeed{0.0, 40.0}, kHandGust{0.0, 60.0}, kHandVisibility_km{0.05, 80.0}, kHandRate{0.0, 60.0},
    kHandTemperature{-30.0, 40.0}, kHandPressure{960.0, 1050.0}, kHandCape{0.0, 3000.0}, kHandHeight{0.0, 14000.0};
inline constexpr double kHandThinnest_m = 50.0;  // of a layer

/// The controls at the present weather: what "Start from here" takes.
HandWeather handFrom(weather::Weather const& weather);

/// What no hand may set is put right: the top stays above the base, the gust is no less than the wind, the dew point no more than the
/// temperature, rain without a kind has none, everything within its range.
void tidy(HandWeather& hand);

/// A layer to add: cumulus first, then higher genera, whatever level is free, over ground of this elevation.
HandLayer anotherLayer(HandWeather const& hand, double elevation);
/// The genus is another: base and top go to what the genus table has for it over this elevation.
void useGenus(HandLayer& layer, weather::Genus genus, double elevation);

/// A recording of one report at `time` over `place`: what the field is made from.
weather::Recording handRecording(HandWeather const& hand, core::Place const& place, core::UtcSeconds time);
}  // namespace luftpost::ui
