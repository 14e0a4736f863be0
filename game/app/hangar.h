// The airframes of the product: one of them flies.
#pragma once
#include <array>
#include <string_view>

#include "engine/flight/airframe.h"

namespace luftpost::app {
/// In the order of their words, which are the names of their files in assets/airframes.
enum class AirframeChoice { mailPlane, freightPlane };
inline constexpr std::array<std::string_view, 2> kAirframeWords{"mail_plane", "freight_plane"};

/// Their models: names of files in assets/models.
inline constexpr std::array<char const*, kAirframeWords.size()> kAirframeModels{"plane", "freight_plane"};

using Hangar = std::array<flight::Airframe, kAirframeWords.size()>;
/// Throws core::Error where a file is missing or broken.
Hangar loadHangar();
inline flight::Airframe const& chosen(Hangar const& hangar, AirframeChoice choice) {
    return hangar[static_cast<std::size_t>(choice)];
}
}  // namespace luftpost::app
