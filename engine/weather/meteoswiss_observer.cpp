#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/csv_table.h"
#include "engine/weather/meteoswiss.h"
#include "engine/weather/report_parts.h"

namespace luftpost::weather {
namespace {
constexpr Range kOkta{0.0, 9.0}, kGenusCode{0.0, 9.0}, kTwoDigits{0.0, 99.0}, kTenMinutesOfRain{0.0, 300.0};

/// WMO code table 0500.
constexpr std::array kGenusByCode{Genus::Ci, Genus::Cc, Genus::Cs, Genus::Ac, Genus::As, Genus::Ns, Genus::Sc, Genus::St, Genus::Cu, Genus::Cb};

struct Seen {
    double metres;
    bool minimum;
};
/// WMO code table 4377: hundreds of metres, kilometres from 56 on, fives of kilometres from 80 on; 90 to 99 is the coarse scale of ships.
std::optional<Seen> visibilityOf(int code) {
    constexpr std::array<double, 10> kCoarse{50.0, 50.0, 200.0, 500.0, 1000.0, 2000.0, 4000.0, 10000.0, 20000.0, 50000.0};
    if (code == 0) return Seen{100.0, false};
    if (code <= 50) return Seen{100.0 * code, false};
    if (code < 56) return std::nullopt;  // not used
    if (code <= 80) return Seen{1000.0 * (code - 50), false};
    if (code <= 89) return Seen{30000.0 + 5000.0 * (std::min(code, 88) - 80), code == 89};
    return Seen{kCoarse[static_cast<std::size_t>(code - 90)], code == 99};
}

/// WMO code table 4677, the weather at the time of the look (below 50: none falls at the station).
Precipitation kindOf(int ww) {
    if (ww < 50) return Precipitation::None;
    if (ww == 56 || ww == 57 || ww == 66 || ww == 67) return Precipitation::FreezingRain;
    if (ww <= 55) return Precipitation::Drizzle;
    if (ww == 68 || ww == 69 || ww == 83 || ww == 84) return Precipitation::Sleet;
    if (ww <= 65 || (ww >= 80 && ww <= 82)) return Precipitation::Rain;
    if ((ww >= 70 && ww <= 79) || ww == 85 || ww == 86) return Precipitation::Snow;
    if ((ww >= 87 && ww <= 90) || ww == 96 || ww == 99) return Precipitation::Hail;
    if (ww == 91 || ww == 92) return Precipitation::Rain;
    if (ww == 93 || ww == 94 || ww == 95 || ww == 97) return Precipitation::Unknown;  // rain or snow, snow or hail
    return Precipitation::None;  // 98: a storm of dust
}

/// Nothing, a sky without cloud, one layer, or a sky that could not be seen.
void addSky(CsvTable const& table, std::size_t row, Report& report) {
    auto const okta = table.number(row, "okta_nto", kOkta), genus = table.number(row, "genus_cc1_wmo0500", kGenusCode);
    if (!okta) return;
    if (*okta == 9.0) {
        report.coverTotal = 1.0;  // obscured: how far up one sees is not said
        return;
    }
    report.layers.emplace();
    if (*okta == 0.0) return;
    ReportedLayer layer;
    layer.cover = *okta / 8.0;
    if (genus) layer.genus = kGenusByCode[static_cast<std::size_t>(*genus)];
    report.layers->push_back(layer);
}

Report reportOf(CsvTable const& table, std::size_t row, core::UtcSeconds time) {
    Report report;
    report.time = time;
    addSky(table, row, report);
    if (auto const code = table.number(row, "vis_vho_wmo4377", kTwoDigits))
        if (auto const seen = visibilityOf(static_cast<int>(*code))) report.visibility_m = seen->metres, report.visibilityIsMinimum = seen->minimum;
    if (auto const code = table.number(row, "ww_wmo4677", kTwoDigits)) {
        int const ww = static_cast<int>(*code);
        report.weatherCode = ww;
        report.thunder = ww == 17 || ww >= 95;  // 91 to 94: thunder in the hour before, not now
        report.precipitationKind = kindOf(ww);
    }
    report.temperature_c = table.number(row, "t2m_c", kTemperature);
    report.dew_point_c = table.number(row, "td2m_c", kDewPoint);
    setWind(table.number(row, "wind_ms", kSpeed), table.number(row, "wind_dir", kDegrees), report.speed_mps, report.from_deg);
    report.gust_mps = table.number(row, "gust_ms", kSpeed);
    if (auto const water = table.number(row, "rain_mm_10min", kTenMinutesOfRain)) report.rate_mm_h = 6.0 * *water;
    report.radiation_w_m2 = table.number(row, "global_rad_wm2", kRadiation);
    report.longwave_w_m2 = table.number(row, "lw_down_wm2", kLongwave);
    if (report.gust_mps || report.rate_mm_h || report.radiation_w_m2 || report.longwave_w_m2) report.interval_s = 600.0;
    return report;
}
}  // namespace

Recording parseObserver(std::string_view bytes, std::string const& file) {
    CsvTable const table{bytes, ',', 0, file};
    Site site;
    site.name = "observer";  // the file names no station
    for (std::size_t row = 0; row < table.rows(); ++row) {
        auto const time = swissTime(table.text(row, "termin_utc"));
        if (!time) throw core::Error(file, table.place(row, "termin_utc"), "expected a time such as \"20230622174000\"");
        if (!site.reports.empty() && *time <= site.reports.back().time)
            throw core::Error(file, table.place(row, "termin_utc"), "expected a time after the row before");
        site.reports.push_back(reportOf(table, row, *time));
    }
    keepWhatSpeaks(site.reports);
    if (site.reports.empty()) throw core::Error(file, "", "expected at least one row with a value");
    std::vector<Site> sites{std::move(site)};
    checkCounts(sites, file);
    std::string const name = "Observer, from " + dayName(sites.front().reports.front().time);
    return {file, name, "MeteoSwiss (observer)", "Source: MeteoSwiss (open data)", sha256Hex(bytes), std::move(sites), {}};
}
}  // namespace luftpost::weather
