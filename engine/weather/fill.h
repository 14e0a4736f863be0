// From what reports say to what the field uses: every gap filled by a rule, and every filling listed.
#pragma once
#include <vector>

#include "engine/weather/recording.h"

namespace luftpost::weather {
/// A cloud layer with nothing left open. Heights in m above sea level.
struct FullLayer {
    Genus genus = Genus::Cu;
    double cover = 0.0, base = 0.0, top = 0.0;
};

/// One report with nothing left open; SI.
struct FullReport {
    core::UtcSeconds time = 0.0;
    glm::dvec2 wind{0.0};       // m/s, east and north, where the air goes to
    double gust = 0.0;          // m/s
    double visibility = 0.0;    // m
    double temperature = 0.0;   // K
    double dewPoint = 0.0;      // K
    double pressureSea = 0.0;   // Pa
    Precipitation kind = Precipitation::None;
    double rate = 0.0;          // mm/h
    double interval = 0.0;      // s
    bool thunder = false;
    double cape = 0.0;          // J/kg
    double freezingLevel = 0.0; // m above sea level
    double snowDepth = 0.0;     // m
    std::vector<FullLayer> layers;
    std::vector<ReportedLevel> levels;
    Filled filled;              // what of the report's own fields was not said, and what stands for it
};

/// The site's reports, filled. Order of preference: the report; the file's own `filled`; neighbours in time; the rule
/// (humidity for visibility, the genus table for tops, 125 m/K of dew-point spread for bases of convective cloud, the first
/// rule for genera, the standard atmosphere). Longitude and latitude only tell day from night.
std::vector<FullReport> fullReports(Site const& site);

/// Wind vector (where the air goes to) from speed and the direction it comes from, and back (0..360).
glm::dvec2 windVector(double speed, double from_deg);
double windFrom_deg(glm::dvec2 wind);

/// Sine of the sun's height, good to a degree: tells day from night and how much the ground heats.
double sunHeight(double lat_deg, double lon_deg, core::UtcSeconds time);

/// Relative humidity 0..1 by Magnus' formula (coefficients of Sonntag 1990). K.
double relativeHumidity(double temperature, double dewPoint);

/// Height in m at which air lifted from the ground forms cloud: Bolton (1980), equation 15, dry adiabatic up to there. K.
double condensationHeight(double temperature, double dewPoint);

/// Visibility in m (5 % contrast) that goes with a humidity: 60 km exp(-2.5 (RH - 15 %)/80 %) (Smirnova et al. 2000).
double visibilityFromHumidity(double humidity);
}  // namespace luftpost::weather
