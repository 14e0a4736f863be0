// Reports as JSON: one shape for recordings (`--save-weather`) and for `weather --json`. Private to .cpp files.
#pragma once
#include <nlohmann/json.hpp>

#include "engine/weather/field.h"

namespace luftpost::weather {
/// The contract's fields of one report, in its order: what was said, else null; `filled` last. Numbers to 6 decimals.
nlohmann::ordered_json reportJson(Site const& site, Report const& said, Filled const& filled);

/// A number to 6 decimals, null where there is none.
nlohmann::ordered_json numberJson(std::optional<double> value);
}  // namespace luftpost::weather
