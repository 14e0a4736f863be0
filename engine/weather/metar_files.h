// Files of aerodrome reports. Each shape is told by its content (`looksLike...`: cheap, never throws); each reader throws
// core::Error where it finds no report at all, and notes what it cannot read.
#pragma once
#include <string>
#include <string_view>

#include "engine/weather/recording.h"
#include "engine/weather/source.h"

namespace luftpost::weather {
/// Raw text: a report a line (lines that begin with a blank go on), or reports that end in "="; NOAA's station and cycle files
/// with a date line ("2024/03/01 00:50") before the reports; bulletins with their headings. # begins a comment.
bool looksLikeMetarText(std::string_view bytes);
Recording parseMetarText(std::string_view bytes, std::string const& file, SourceContext const& context);

/// A table with a header line, tabs or commas between its cells, one column "metar" and perhaps one "valid"
/// ("2024-03-01 00:52"): the Iowa Environmental Mesonet's series.
bool looksLikeMetarTable(std::string_view bytes);
Recording parseMetarTable(std::string_view bytes, std::string const& file, SourceContext const& context);

/// The JSON of aviationweather.gov: of each entry "rawOb", "obsTime", and for stations that the table lacks "lat", "lon",
/// "elev"; its decoded fields are not read (they lose CB and TCU, and change).
bool looksLikeMetarJson(std::string_view bytes);
Recording parseMetarJson(std::string_view bytes, std::string const& file, SourceContext const& context);
}  // namespace luftpost::weather
