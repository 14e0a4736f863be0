#include "engine/weather/units.h"

#include <array>

namespace luftpost::weather {
namespace {
constexpr double kKnot = 1852.0 / 3600.0, kMile = 0.44704, kFoot = 0.3048, kInch = 25.4;

struct Row {
    Quantity quantity;
    std::string_view name;
    Unit unit;
};
constexpr std::array kRows{
    Row{Quantity::Temperature, "°C", {}},
    Row{Quantity::Temperature, "C", {}},
    Row{Quantity::Temperature, "°F", {5.0 / 9.0, -160.0 / 9.0}},
    Row{Quantity::Temperature, "F", {5.0 / 9.0, -160.0 / 9.0}},
    Row{Quantity::Temperature, "K", {1.0, -273.15}},
    Row{Quantity::Speed, "m/s", {}},
    Row{Quantity::Speed, "ms-1", {}},
    Row{Quantity::Speed, "km/h", {1.0 / 3.6}},
    Row{Quantity::Speed, "kmh", {1.0 / 3.6}},
    Row{Quantity::Speed, "mp/h", {kMile}},
    Row{Quantity::Speed, "mph", {kMile}},
    Row{Quantity::Speed, "kn", {kKnot}},
    Row{Quantity::Speed, "kt", {kKnot}},
    Row{Quantity::Direction, "°", {}},
    Row{Quantity::Direction, "degree", {}},
    Row{Quantity::Share, "%", {0.01}},
    Row{Quantity::Share, "percent", {0.01}},
    Row{Quantity::Length, "m", {}},
    Row{Quantity::Length, "ft", {kFoot}},
    Row{Quantity::Length, "km", {1000.0}},
    Row{Quantity::Length, "cm", {0.01}},
    Row{Quantity::Length, "inch", {kInch / 1000.0}},
    Row{Quantity::Water, "mm", {}},
    Row{Quantity::Water, "inch", {kInch}},
    Row{Quantity::Pressure, "hPa", {}},
    Row{Quantity::Pressure, "mbar", {}},
    Row{Quantity::Pressure, "Pa", {0.01}},
    Row{Quantity::Energy, "J/kg", {}},
    Row{Quantity::Flux, "W/m²", {}},
    Row{Quantity::Flux, "Wm-2", {}},
    Row{Quantity::Code, "wmo code", {}},
    Row{Quantity::Code, "", {}},
};
}  // namespace

std::optional<Unit> unitNamed(Quantity quantity, std::string_view name) {
    for (Row const& row : kRows)
        if (row.quantity == quantity && row.name == name) return row.unit;
    return std::nullopt;
}

std::string_view unitNames(Quantity quantity) {
    switch (quantity) {
        case Quantity::Temperature: return "°C, °F";
        case Quantity::Speed: return "m/s, km/h, mp/h, kn";
        case Quantity::Direction: return "°";
        case Quantity::Share: return "%";
        case Quantity::Length: return "m, ft, cm, inch";
        case Quantity::Water: return "mm, inch";
        case Quantity::Pressure: return "hPa";
        case Quantity::Energy: return "J/kg";
        case Quantity::Flux: return "W/m²";
        case Quantity::Code: return "wmo code";
    }
    return "";
}
}  // namespace luftpost::weather
