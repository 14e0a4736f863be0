#include "engine/sky/sky_state.h"

#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>

namespace luftpost::sky {
namespace {
constexpr double kUnixEpochJd = 2440587.5;   // 1970-01-01T00:00
constexpr double kSunRadius = 6.957e8;       // m, IAU 2015 nominal
constexpr double kMoonRadius = 1.7374e6;     // m, IAU mean
constexpr int kWgs84 = 1;                    // ERFA's number of the ellipsoid

/// A Julian date in two parts, as ERFA takes it.
struct JulianDate {
    double day = 0.0;
    double fraction = 0.0;
};

JulianDate utcDate(core::UtcSeconds time) {
    double const days = std::floor(time / 86400.0);
    return {kUnixEpochJd + days, time / 86400.0 - days};
}

JulianDate terrestrialDate(JulianDate const& utc) {
    JulianDate tai = utc;
    if (eraUtctai(utc.day, utc.fraction, &tai.day, &tai.fraction) < 0) tai = utc;
    JulianDate tt = tai;
    eraTaitt(tai.day, tai.fraction, &tt.day, &tt.fraction);
    return tt;
}

/// GLM keeps columns, ERFA rows.
glm::dmat3 matrixFromRows(double const (&rows)[3][3]) {
    glm::dmat3 matrix{1.0};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) matrix[column][row] = rows[row][column];
    return matrix;
}

/// The Earth-fixed frame from GCRS. Polar motion (under 0.5 arc seconds) is left out.
glm::dmat3 earthFromCelestial(JulianDate const& ut, JulianDate const& tt) {
    double trueFromCelestial[3][3];
    eraPnm06a(tt.day, tt.fraction, trueFromCelestial);
    double const sidereal = eraGst06(ut.day, ut.fraction, tt.day, tt.fraction, trueFromCelestial);
    eraRz(sidereal, trueFromCelestial);
    return matrixFromRows(trueFromCelestial);
}

/// The world frame (x east, y up, z south) at the place from the Earth-fixed frame.
glm::dmat3 worldFromEarth(core::Place const& place) {
    double const lat = core::radians(place.lat_deg);
    double const lon = core::radians(place.lon_deg);
    glm::dvec3 const east{-std::sin(lon), std::cos(lon), 0.0};
    glm::dvec3 const up{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
    return glm::transpose(glm::dmat3{east, up, glm::cross(east, up)});
}

glm::dvec3 placeInEarthFrame(core::Place const& place) {
    double xyz[3] = {0.0, 0.0, 0.0};
    eraGd2gc(kWgs84, core::radians(place.lon_deg), core::radians(place.lat_deg), place.altitude_m, xyz);
    return glm::dvec3{xyz[0], xyz[1], xyz[2]};
}

/// Metres, GCRS. The Earth is taken where it was when the light left the sun: that is light time and aberration both.
glm::dvec3 sunCelestial(JulianDate const& tt) {
    double constexpr kLightDays = ERFA_AULT / ERFA_DAYSEC;
    double heliocentric[2][3], barycentric[2][3];
    eraEpv00(tt.day, tt.fraction, heliocentric, barycentric);
    double const distance = glm::length(glm::dvec3{heliocentric[0][0], heliocentric[0][1], heliocentric[0][2]});
    eraEpv00(tt.day, tt.fraction - distance * kLightDays, heliocentric, barycentric);
    return -ERFA_DAU * glm::dvec3{heliocentric[0][0], heliocentric[0][1], heliocentric[0][2]};
}

/// Metres, GCRS.
glm::dvec3 moonCelestial(JulianDate const& tt) {
    double moon[2][3];
    eraMoon98(tt.day, tt.fraction, moon);
    return ERFA_DAU * glm::dvec3{moon[0][0], moon[0][1], moon[0][2]};
}

/// The unit vector, lifted by the refraction of the standard atmosphere at `altitude`.
glm::dvec3 refracted(glm::dvec3 const& direction, double altitude) {
    double const height = std::clamp(altitude, -400.0, 20000.0);
    double const temperature = std::max(288.15 - 0.0065 * height, 216.65);
    double const pressure = 101325.0 * std::exp(-height / 8434.0);
    double const airless = elevation(direction);
    return directionWorld(azimuth(direction), airless + refraction(airless, pressure, temperature));
}
}  // namespace

glm::dvec3 directionWorld(double azimuth, double elevation) {
    return glm::dvec3{std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                      -std::cos(azimuth) * std::cos(elevation)};
}

double elevation(glm::dvec3 const& directionWorld) {
    return std::atan2(directionWorld.y, std::hypot(directionWorld.x, directionWorld.z));
}

double azimuth(glm::dvec3 const& directionWorld) {
    double const angle = std::atan2(directionWorld.x, -directionWorld.z);
    return angle < 0.0 ? angle + 2.0 * core::kPi : angle;
}

double refraction(double airlessElevation, double pressure, double temperature) {
    double const degrees = std::clamp(core::degrees(airlessElevation), -1.0, 89.9);
    double const arcMinutes = 1.02 / std::tan(core::radians(degrees + 10.3 / (degrees + 5.11)));
    double const fade = glm::smoothstep(-4.0, -1.0, core::degrees(airlessElevation));
    return fade * core::radians(std::max(arcMinutes, 0.0) / 60.0) * (pressure / 101000.0) * (283.0 / temperature);
}

SkyState skyState(core::Place const& place, core::UtcSeconds time) {
    JulianDate const ut = utcDate(time);
    JulianDate const tt = terrestrialDate(ut);
    glm::dmat3 const worldFromCelestial = worldFromEarth(place) * earthFromCelestial(ut, tt);
    glm::dvec3 const observer = worldFromEarth(place) * placeInEarthFrame(place);
    glm::dvec3 const sun = worldFromCelestial * sunCelestial(tt) - observer;
    glm::dvec3 const moon = worldFromCelestial * moonCelestial(tt) - observer;

    SkyState state;
    state.sunDirectionWorld = refracted(glm::normalize(sun), place.altitude_m);
    state.moonDirectionWorld = refracted(glm::normalize(moon), place.altitude_m);
    state.sunDistance_au = glm::length(sun) / ERFA_DAU;
    state.sunAngularRadius = std::asin(kSunRadius / glm::length(sun));
    state.moonAngularRadius = std::asin(kMoonRadius / glm::length(moon));
    double const cosPhase = glm::dot(glm::normalize(moon - sun), glm::normalize(moon));
    state.moonPhaseAngle = std::acos(std::clamp(cosPhase, -1.0, 1.0));
    state.moonIlluminated = 0.5 * (1.0 + cosPhase);
    state.celestialFromWorld = glm::transpose(worldFromCelestial);
    return state;
}
}  // namespace luftpost::sky
