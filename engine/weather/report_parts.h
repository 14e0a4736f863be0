// What every source does with its figures on the way to a report.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/weather/ranges.h"
#include "engine/weather/recording.h"

namespace luftpost::weather {
inline constexpr std::size_t kMostSites = 100;      // of one source
inline constexpr std::size_t kMostReports = 20000;  // of one source, all sites together

/// True when the report holds any value besides its time.
bool saysSomething(Report const& report);
void keepWhatSpeaks(std::vector<Report>& reports);

/// Sorts by altitude and leaves out levels at or below `lowest` (m above sea level) and those within a metre of the one before.
void orderLevels(std::vector<ReportedLevel>& levels, double lowest);

/// From relative humidity (0..1, more counts as 1) by Magnus' formula over water (WMO-No. 8: 17.62, 243.12), the one that the
/// field turns back. Nothing where either is unknown or the air holds no water at all.
std::optional<double> dewPoint_c(std::optional<double> temperature_c, std::optional<double> humidity);

/// Reduced to sea level with 6.5 K/km below the station; without a temperature the standard atmosphere's.
double seaPressure_hpa(double station_hpa, double elevation_m, std::optional<double> temperature_c);

/// A station's own pressure, where none at sea level is given: reduced, as a filled value. Throws core::Error beyond 800..1100.
void fillSeaPressure(Report& report, double station_hpa, double elevation_m, std::string const& file, std::string const& place);

/// A calm has no direction.
void setWind(std::optional<double> speed_mps, std::optional<double> from_deg, std::optional<double>& speed, std::optional<double>& from);

/// "47.54 N 7.58 E"
std::string coordinateName(double lat_deg, double lon_deg);
/// "2023-06-22"
std::string dayName(core::UtcSeconds time);

/// Throws core::Error for more sites or reports than the bounds above.
void checkCounts(std::vector<Site> const& sites, std::string const& file);
}  // namespace luftpost::weather
