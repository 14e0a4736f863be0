// What changes the flight from outside: inputs, each stamped with the tick from which it acts.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "engine/core/environment.h"
#include "engine/core/settings.h"
#include "engine/weather/field.h"
#include "game/ui/input.h"

namespace luftpost::app {
struct SettingInput {
    std::string key;
    core::SettingValue value;
    bool operator==(SettingInput const&) const = default;
};
/// Another weather from now on: one that has a name and was loaded in the world before (`source` alone), or one that came on the
/// way, from a feed or from the player's hand, and carries its reports itself.
struct WeatherInput {
    std::string source;     // what --weather takes; with a recording, what the menu marks: kLiveSource, kHandSource
    std::string recording{};  // text in our format (weather::recordingText); empty: the loaded source
    weather::SourceMode mode = weather::SourceMode::Recorded;  // with a recording: what it is shown as
    core::UtcSeconds fetched = 0.0;                            // of a live one: when the source gave it
    core::UtcSeconds from = 0.0;                               // with a recording: from this time on it goes over ...
    double seconds = 0.0;                                      // ... within so long; 0: at once
    bool operator==(WeatherInput const&) const = default;
};
inline constexpr char const* kLiveSource = "live";
inline constexpr char const* kHandSource = "hand";
inline constexpr double kFeedSeconds = 300.0;  // a feed's arrival: clouds and wind follow slowly
inline constexpr double kHandSeconds = 2.0;    // the player's hand: one sees what one does
struct ClockInput {
    core::UtcSeconds utc = 0.0;  // the time at the beginning of the tick
    bool operator==(ClockInput const&) const = default;
};
/// The weather's clock runs so many times as fast as the flight's from now on: sun, clouds and wind go with it.
struct ClockRateInput {
    double rate = 1.0;  // 0..kFastestClock
    bool operator==(ClockRateInput const&) const = default;
};
inline constexpr double kFastestClock = 600.0;
using FlightInput = std::variant<ui::InputSample, SettingInput, WeatherInput, ClockInput, ClockRateInput>;

struct StampedInput {
    long long tick = 0;
    FlightInput what;
    bool operator==(StampedInput const&) const = default;
};
}  // namespace luftpost::app
