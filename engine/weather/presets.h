// Weather by name: one report, made here, that holds for ever.
#pragma once
#include <optional>
#include <string_view>

#include "engine/weather/field.h"

namespace luftpost::weather {
/// calm, clear, fair, broken, overcast, storm, in this order, each with a line that says what it is.
struct PresetName {
    std::string_view name, description;
};
std::vector<PresetName> const& presetNames();

/// The recording of a preset at a place (default: the default recording's), nothing for an unknown name.
std::optional<Recording> presetRecording(std::string_view name, std::optional<PlaceWish> const& place);
}  // namespace luftpost::weather
