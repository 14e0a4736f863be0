// Time at the program's border: ISO 8601, always UTC, the Z compulsory.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/environment.h"

namespace luftpost::core {
/// Reads "2023-06-23T18:40Z" or "2023-06-23T18:40:05Z" (a fraction ".25" of a second is allowed after the seconds).
/// Nothing when the text is not exactly that: no Z, another offset, a 30 February, an hour 24, a second 60.
std::optional<UtcSeconds> parseUtc(std::string_view text);

/// "2023-06-23T18:40:00Z", to the nearest second; years 0000 to 9999 (clamped).
std::string formatUtc(UtcSeconds time);
}  // namespace luftpost::core
