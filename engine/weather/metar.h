// One aerodrome report (METAR or SPECI) -> what it says, group by group. Our own decoder of FM 15 and FM 16 with the American
// forms; what cannot be read is named with its place. Pure; any thread; never throws.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/weather/metar_groups.h"
#include "engine/weather/recording.h"

namespace luftpost::weather {
/// Text of the report that is no group of it, or not where it may stand.
struct MetarNote {
    std::size_t offset = 0;  // bytes from the report's beginning
    std::size_t length = 0;
    std::string what;        // "is no wind"
};

struct MetarTime {
    int day = 0, hour = 0, minute = 0;
};

/// A report as it was written: heights above the aerodrome, amounts as they stand.
struct Metar {
    std::string station;
    std::optional<MetarTime> time;  // none: not written, or not a time
    bool corrected = false, automatic = false;
    MetarWind wind;
    MetarVisibility visibility;
    std::vector<MetarWeather> weather;     // present weather, as listed
    bool weatherMissing = false;           // "//", or a text in its place that cannot be read
    std::optional<std::vector<MetarCloud>> clouds;  // none: nothing said; empty: none up to cloudsTo_m
    std::optional<double> cloudsTo_m;               // none: the whole sky
    bool obscured = false;                 // VV: the sky cannot be seen
    std::optional<double> verticalVisibility_m;
    MetarTemperature temperature;
    std::optional<double> pressure_hpa;    // Q or A: reduced to sea level by the standard atmosphere

    // Of the remarks:
    std::optional<int> automaticType;      // AO1, AO2
    bool thunderBlind = false, weatherBlind = false;  // TSNO, PWINO: the sensor is out of order
    MetarTemperature tenths;               // T01830094
    std::optional<int> seaLevel;           // SLP134: tenths of hPa without hundreds
    std::optional<double> fallen_mm;       // P0003: since the last hourly report
    std::vector<MetarGenus> genera;

    std::vector<MetarNote> notes;
};

/// Reads "METAR LSZB 010050Z ..." (the type word may be left out; one report, with or without its "="). Nothing when the text
/// does not begin as a report does: type word or not, then four letters or digits that begin with a letter, then a time (well
/// written or not), NIL, AUTO or a wind.
std::optional<Metar> decodeMetar(std::string_view text);

/// True when the text begins as a report does and the time or NIL follows: how one tells a METAR from other text.
bool looksLikeMetar(std::string_view line);

/// The report as ours: heights above sea level (`elevation_m`, else 0), own shares of the layers, genera and rates that follow
/// from other groups in `filled`. Its time is left at 0.
Report reportOf(Metar const& metar, std::optional<double> elevation_m);
}  // namespace luftpost::weather
