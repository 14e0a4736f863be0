// Units of the providers -> units of a report.
#pragma once
#include <optional>
#include <string_view>

namespace luftpost::weather {
/// What a unit is of; behind it what a report has it in.
enum class Quantity {
    Temperature,   // degrees Celsius
    Speed,         // m/s
    Direction,     // degrees
    Share,         // 0..1
    Length,        // m
    Water,         // mm, or kg/m2 of water
    Pressure,      // hPa
    Energy,        // J/kg
    Flux,          // W/m2
    Code           // a number without a unit
};

/// report = given * factor + offset
struct Unit {
    double factor = 1.0;
    double offset = 0.0;
};

/// The unit of that name for that quantity, in any of the spellings of Open-Meteo and meteoblue; nothing when there is none.
std::optional<Unit> unitNamed(Quantity quantity, std::string_view name);

/// The names that unitNamed takes, for messages: "m/s, km/h, kn".
std::string_view unitNames(Quantity quantity);
}  // namespace luftpost::weather
