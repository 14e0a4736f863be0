// `luftpost sky --plan`: the vertical optical depth of the clouds over a square.
#pragma once
#include <filesystem>

#include "engine/weather/cloud_plan.h"

namespace luftpost::app {
/// Writes one float channel, first row north. Throws core::Error.
void writePlan(weather::Field const& field, weather::PlanRequest const& request, std::filesystem::path const& file);
}  // namespace luftpost::app
