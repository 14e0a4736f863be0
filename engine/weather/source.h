// Sources: bytes of any known shape -> a recording. Recognised by content, never by name.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "engine/weather/field.h"
#include "engine/weather/recording.h"

namespace luftpost::weather {
/// What a source cannot say of itself.
struct SourceContext {
    core::UtcSeconds latest = 0.0;  // a METAR names day and hour alone: its month is the latest such day at or before this
    std::optional<PlaceWish> place = {};  // --place: a model's grid has no place of its own
    std::string stationTable = {};        // assets/weather/stations.txt; empty: no station's place is known
};

/// recorded, preset, live, stale: by the mode's value.
inline constexpr std::array<std::string_view, 4> kSourceModeWords{"recorded", "preset", "live", "stale"};
constexpr std::string_view modeWord(SourceMode mode) { return kSourceModeWords[static_cast<std::size_t>(mode)]; }

/// Now, by the wall clock: what `latest` is without --time.
SourceContext contextOfNow();

/// Reads the bytes in whatever format they are. Throws core::Error that names `file`, the place in it and what was expected;
/// bytes of no known format: one line that lists the formats.
Recording parseSource(std::string_view bytes, std::string const& file, SourceContext const& context);

/// SOURCE of the command line: FILE, recorded:FILE or preset:NAME (calm, clear, fair, broken, overcast, storm). Throws
/// core::Error in one line: unknown preset, unreadable or broken file, `live` (it needs a feed: game/app).
Recording readWeather(std::string const& source, std::optional<PlaceWish> const& place, SourceContext const& context);

/// The same as a field.
Field loadWeather(std::string const& source, std::optional<PlaceWish> const& place = {}, SourceContext const& context = contextOfNow());
}  // namespace luftpost::weather
