#include "engine/weather/report_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/math.h"
#include "engine/core/time.h"

namespace luftpost::weather {
namespace {
constexpr double kMagnusA = 17.62, kMagnusB = 243.12;  // over water, WMO-No. 8
constexpr double kZeroCelsius = 273.15, kLapseRate = 0.0065, kExponent = 5.2559;  // the standard atmosphere's
}  // namespace

bool saysSomething(Report const& r) {
    auto const any = [](auto const&... value) { return (value.has_value() || ...); };
    return !r.levels.empty() || !r.filled.empty() ||
           any(r.speed_mps, r.gust_mps, r.from_deg, r.visibility_m, r.verticalVisibility_m, r.temperature_c, r.dew_point_c, r.pressure_hpa,
               r.precipitationKind, r.rate_mm_h, r.thunder, r.layers, r.coverLow, r.coverMid, r.coverHigh, r.coverTotal, r.cape_j_kg,
               r.freezingLevel_m, r.snowDepth_m, r.radiation_w_m2, r.longwave_w_m2, r.weatherCode);
}

void orderLevels(std::vector<ReportedLevel>& levels, double lowest) {
    std::stable_sort(levels.begin(), levels.end(),
                     [](ReportedLevel const& a, ReportedLevel const& b) { return a.altitude_m < b.altitude_m; });
    std::vector<ReportedLevel> kept;
    for (ReportedLevel const& level : levels)
        if (level.altitude_m > lowest && (kept.empty() || level.altitude_m >= kept.back().altitude_m + 1.0)) kept.push_back(level);
    levels = std::move(kept);
}

std::optional<double> dewPoint_c(std::optional<double> temperature_c, std::optional<double> humidity) {
    if (!temperature_c || !humidity || *humidity <= 0.0) return std::nullopt;
    double const x = core::log(std::min(*humidity, 1.0)) + kMagnusA * *temperature_c / (kMagnusB + *temperature_c);
    return std::max(kMagnusB * x / (kMagnusA - x), kDewPoint.low);
}

double seaPressure_hpa(double station_hpa, double elevation_m, std::optional<double> temperature_c) {
    double const drop = kLapseRate * elevation_m;
    double const station = temperature_c ? *temperature_c + kZeroCelsius : kZeroCelsius + 15.0 - drop;
    return station_hpa * core::pow(station / (station + drop), -kExponent);
}

void fillSeaPressure(Report& report, double station_hpa, double elevation_m, std::string const& file, std::string const& place) {
    double const sea = seaPressure_hpa(station_hpa, elevation_m, report.temperature_c);
    if (!(sea >= kPressure.low && sea <= kPressure.high))
        throw core::Error(file, place, fmt::format("expected a pressure that is {} to {} hPa at sea level, found {} at {} m", kPressure.low,
                                                   kPressure.high, station_hpa, elevation_m));
    report.filled["pressure_hpa"] = sea;
}

void setWind(std::optional<double> speed_mps, std::optional<double> from_deg, std::optional<double>& speed, std::optional<double>& from) {
    speed = speed_mps;
    from = speed_mps && *speed_mps == 0.0 ? std::nullopt : from_deg;
}

std::string coordinateName(double lat_deg, double lon_deg) {
    return fmt::format("{:.2f} {} {:.2f} {}", std::abs(lat_deg), lat_deg < 0.0 ? 'S' : 'N', std::abs(lon_deg), lon_deg < 0.0 ? 'W' : 'E');
}

std::string dayName(core::UtcSeconds time) { return core::formatUtc(time).substr(0, 10); }

void keepWhatSpeaks(std::vector<Report>& reports) {
    std::erase_if(reports, [](Report const& report) { return !saysSomething(report); });
}

void checkCounts(std::vector<Site> const& sites, std::string const& file) {
    std::size_t reports = 0;
    for (Site const& site : sites) reports += site.reports.size();
    if (sites.size() > kMostSites) throw core::Error(file, "", fmt::format("expected at most {} places, found {}", kMostSites, sites.size()));
    if (reports > kMostReports) throw core::Error(file, "", fmt::format("expected at most {} reports, found {}", kMostReports, reports));
}
}  // namespace luftpost::weather
