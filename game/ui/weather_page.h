// The weather's page of the config menu: real hours, the player's own hand, and the photograph. Draws from plain data and answers
// with what the player asked for. Main thread, between ScreenFrame::begin and end.
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "game/ui/hand_weather.h"
#include "game/ui/photo_view.h"
#include "game/ui/weather_strip.h"

namespace luftpost::ui {
/// How fast the weather's clock may run beside the flight's.
inline constexpr std::array<double, 5> kTimeRates{0.0, 1.0, 10.0, 60.0, 600.0};

/// Weather and time of day as the menu offers them.
struct MenuWeather {
    struct Source {
        std::string source;  // "recorded:FILE" or "preset:NAME": what --weather takes
        std::string label;   // "Basel, 21-23 June 2023"
        std::string detail;  // when, and why it is interesting; may be empty
        bool preset = false;
    };
    /// A real hour or a view: choosing it begins a flight there and then.
    struct Hour {
        std::string name;    // "Gust front over Basel"
        std::string when;    // "22 June 2023, 17:10 UTC, Basel"
        std::string why;     // one line
    };
    std::vector<Source> sources;
    std::vector<Hour> hours;
    std::string current;         // the source in use
    double utc = 0.0;            // now
    double start = 0.0;          // of the recording; equal to end for a preset, which offers its whole day
    double end = 0.0;
    double rate = 1.0;           // of the weather's clock
    WeatherStrip const* strip = nullptr;  // of the recording; none for a preset and for weather by hand
    bool byHand = false;         // the hand's weather is the one in force
    HandWeather hand;            // what the controls show
    std::vector<std::string> live;  // lines about the live source: how it stands, whose it is, its limits
    double elevation = 0.0;      // m, of the place: heights of new layers count from it
    PhotoState photo;
};

struct WeatherAnswer {
    std::optional<std::string> source;  // take this weather
    std::optional<std::size_t> hour;    // fly there and then: of MenuWeather::hours
    std::optional<double> utc;          // set the clock
    std::optional<double> rate;         // let the weather's clock run so fast
    std::optional<HandWeather> hand;    // the controls were moved
    bool startFromHere = false;         // copy the present weather into the controls
    std::optional<PhotoView> photo;     // how the photograph is shown
    bool comparePhoto = false;          // compare its colours with the picture's
};

/// One tab of the config menu's tab bar, with pages of its own, `drawLivePage` among them; `open` brings it to the front.
void drawWeatherPage(MenuWeather const& weather, bool open, WeatherAnswer& answer, std::function<void()> const& drawLivePage);

/// The strip of hours, its labels included, in the given width; a press or drag on it sets the time.
std::optional<double> drawWeatherStrip(WeatherStrip const& strip, double utc, float width);
}  // namespace luftpost::ui
