// The names of Open-Meteo's variables: what they are of, and the model or height that stands behind them.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "engine/weather/ranges.h"
#include "engine/weather/units.h"

namespace luftpost::weather {
struct OpenMeteoVariable {
    std::string_view name;
    Quantity quantity;
    Range range;  // in our unit
};

/// A key taken apart: the variable in its spelling of today, its height included ("temperature_850hPa"), and the model whose name
/// stands behind it (empty where only one was asked).
struct OpenMeteoKey {
    std::string variable;
    OpenMeteoVariable row;
    std::string model;
};

/// Nothing for a key that no report has a place for.
std::optional<OpenMeteoKey> openMeteoKey(std::string_view key);
}  // namespace luftpost::weather
