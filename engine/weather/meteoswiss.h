// MeteoSwiss' open data: ten-minute values of the automatic stations, an observer's looks at the sky, a sounding -> a recording.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "engine/weather/recording.h"

namespace luftpost::weather {
/// True for the heading of any of the three. Cheap, never throws.
bool looksLikeMeteoSwiss(std::string_view bytes);

/// Throws core::Error that names line and column.
/// - Ten minutes ("nat_abbr" or "station_abbr" and parameters such as tre200s0; times are the ends of the intervals, UTC), one station or
///   several mixed: one site each. Gust: of 3 s, else of 1 s. Pressure: QFF; where a station has none QNH; else its own, reduced.
/// - Observer (termin_utc, okta_nto, genus_cc1_wmo0500, vis_vho_wmo4377, ww_wmo4677): one layer of the main genus, of no known base.
/// - Sounding (zzzztttt, reppps0 ...): one report a launch, all heights as levels.
Recording parseMeteoSwiss(std::string_view bytes, std::string const& file);

/// The parts of parseMeteoSwiss.
Recording parseTenMinutes(std::string_view bytes, std::string const& file);
Recording parseObserver(std::string_view bytes, std::string const& file);
Recording parseSounding(std::string_view bytes, std::string const& file);

/// What the files do not say of a station.
struct SwissStation {
    std::string_view abbreviation, wmo, name;
    double lat_deg, lon_deg, elevation_m;
};
/// By its abbreviation ("BAS") or its WMO number ("06601"); nothing for one we do not know.
std::optional<SwissStation> swissStation(std::string_view key);

/// "202306190000", "20230621001000" or "21.06.2023 00:10", UTC.
std::optional<core::UtcSeconds> swissTime(std::string_view text);
}  // namespace luftpost::weather
