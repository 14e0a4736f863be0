// What changes the flight from outside: inputs, each stamped with the tick from which it acts.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "engine/core/environment.h"
#include "engine/core/settings.h"
#include "game/ui/input.h"

namespace luftpost::app {
struct SettingInput {
    std::string key;
    core::SettingValue value;
    bool operator==(SettingInput const&) const = default;
};
/// The source must be loaded in the world before the input acts.
struct WeatherInput {
    std::string source;
    bool operator==(WeatherInput const&) const = default;
};
struct ClockInput {
    core::UtcSeconds utc = 0.0;  // the time at the beginning of the tick
    bool operator==(ClockInput const&) const = default;
};
using FlightInput = std::variant<ui::InputSample, SettingInput, WeatherInput, ClockInput>;

struct StampedInput {
    long long tick = 0;
    FlightInput what;
    bool operator==(StampedInput const&) const = default;
};
}  // namespace luftpost::app
