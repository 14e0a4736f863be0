// A recording: reports over time, of one site or several, in one file ("luftpost-weather-1"), with origin and checksum.
// A report holds what was said and nothing else: an absent value is an empty optional, never a zero.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/environment.h"
#include "engine/weather/weather.h"

namespace luftpost::weather {
/// A value that somebody else than the observer put in: a number, a word or a yes.
using FilledValue = std::variant<double, std::string, bool>;
/// By the place in the report, as in "layers[0].top_m".
using Filled = std::map<std::string, FilledValue>;

struct ReportedLayer {
    std::optional<Genus> genus;
    std::optional<double> cover;   // 0..1
    std::optional<double> base_m;  // above sea level
    std::optional<double> top_m;   // above sea level
};

/// One height of a sounding or of a model. Altitudes are above sea level.
struct ReportedLevel {
    double altitude_m = 0.0;
    std::optional<double> temperature_c, dew_point_c, speed_mps, from_deg, cover;
};

struct CoverBounds {
    double low_m = 3000.0;  // low cloud ends here
    double mid_m = 8000.0;  // mid cloud ends here
};

/// One report, in the units of the file (they cross the border of the program).
struct Report {
    core::UtcSeconds time = 0.0;
    std::optional<double> speed_mps, gust_mps, from_deg;  // 10 m above ground; from_deg true, none when calm or variable
    std::optional<double> visibility_m;
    bool visibilityIsMinimum = false;
    std::optional<double> verticalVisibility_m;
    std::optional<double> temperature_c, dew_point_c;
    std::optional<double> pressure_hpa;  // at sea level
    std::optional<Precipitation> precipitationKind;
    std::optional<double> rate_mm_h;
    std::optional<bool> thunder;
    std::optional<std::vector<ReportedLayer>> layers;  // none: nothing said; empty: no cloud up to layersTo_m
    std::optional<double> layersTo_m;                  // above sea level; none: the whole sky
    std::optional<double> interval_s;                  // of the rate's mean and the gust's maximum
    std::vector<ReportedLevel> levels;                 // ascending
    std::optional<double> coverLow, coverMid, coverHigh, coverTotal;
    CoverBounds coverBounds;
    std::optional<double> cape_j_kg, freezingLevel_m, snowDepth_m;
    std::optional<double> radiation_w_m2, longwave_w_m2;  // coming down: of the sun, of the sky; means of the interval
    std::optional<int> weatherCode;  // WMO 4677 / Open-Meteo
    Filled filled;                   // what the file itself says was filled in
};

struct Site {
    std::string name;
    std::optional<double> lat_deg, lon_deg, elevation_m;
    std::vector<Report> reports;     // ascending in time, at least one
    std::vector<Report> superseded = {};  // of the same time as one of `reports`, which holds in its place (a correction)
};

/// One report as the file lists them: which of the site's `reports`, or of its `superseded`.
struct ListedReport {
    std::size_t site = 0, report = 0;
    bool superseded = false;
};

struct Recording {
    std::string file;      // as it was named
    std::string name;
    std::string source;    // the provider
    std::string licence;
    std::string sha256;    // of the file's bytes, lower-case hex
    std::vector<Site> sites;               // at least one
    std::vector<std::string> unknownKeys;  // ignored, as places: "sites[0].reports[3].mood"; each kind of place once
    std::vector<std::string> notes = {};   // what of the file could not be read, as "line 7, column 12: ..."; the rest holds
    std::vector<ListedReport> order = {};  // the reports as the file lists them; empty: site by site
};

/// Reads the bytes of a file in our format. Throws core::Error that names `file`, the place in it ("sites[0].reports[3].wind
/// .speed_mps", or line and column where it is not JSON) and what was expected.
Recording parseRecording(std::string_view bytes, std::string const& file);

/// The same from a file. Throws core::Error, also when it cannot be read.
Recording readRecording(std::string const& file);

/// The recording in our format, one report a line; read again it is the same (numbers to 6 decimals).
std::string recordingText(Recording const& recording);

/// Writes it to a new file and renames that. Throws core::Error.
void writeRecording(Recording const& recording, std::string const& file);

/// Lower-case hex of the SHA-256 of the bytes.
std::string sha256Hex(std::string_view bytes);
}  // namespace luftpost::weather
