// Temperature, dew point and pressure by height over a site.
#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/field_data.h"

namespace luftpost::weather {
namespace {
constexpr double kGasConstant = 287.05287;   // J/(kg K), dry air (ISO 2533)
constexpr double kLapse = 0.0065;            // K/m
constexpr double kTropopause = 11000.0;      // m
constexpr double kColdest = 150.0;           // K
constexpr double kDewLapseMixed = 0.0018;    // K/m: a mixed layer keeps its vapour
constexpr double kDewLapseFree = 0.008;      // K/m
constexpr double kEven = 1e-6;               // K/m: a smaller lapse is none

double temperatureBetween(double low, double high, double a, double b, double altitude) { return a + (b - a) * ((altitude - low) / (high - low)); }

/// Hydrostatic: from a pressure at one temperature to another, `rise` m above, temperature linear between (ISO 2533).
double pressureAbove(double pressure, double from, double to, double rise) {
    double const lapse = rise != 0.0 ? (from - to) / rise : 0.0;
    if (std::abs(lapse) < kEven) return pressure * core::exp(-core::kGravity * rise / (kGasConstant * from));
    return pressure * core::pow(to / from, core::kGravity / (kGasConstant * lapse));
}

/// The standard atmosphere's lapse from a level, down or up; isothermal above 11 km and above a higher level.
MassAt beyond(double altitude0, double temperature0, double pressure0, double altitude) {
    double const ceiling = std::max(kTropopause, altitude0), bent = std::min(altitude, ceiling);
    double const temperature = std::max(temperature0 - kLapse * (bent - altitude0), kColdest);
    double pressure = pressureAbove(pressure0, temperature0, temperature, bent - altitude0);
    if (altitude > bent) pressure *= core::exp(-core::kGravity * (altitude - bent) / (kGasConstant * temperature));
    return {temperature, 0.0, pressure};
}

/// Of the boundary layer over the site.
double dewPointFromGround(Masses const& m, double altitude) {
    double const height = altitude - m.altitude[0], mixed = std::clamp(height, 0.0, condensationHeight(m.temperature[0], m.dewPoint[0]));
    return m.dewPoint[0] - kDewLapseMixed * mixed - kDewLapseFree * std::max(height - mixed, 0.0);
}
}  // namespace

void Masses::add(double at, double kelvin, std::optional<double> dew) {
    auto const i = static_cast<std::size_t>(levels++);
    altitude[i] = at;
    temperature[i] = kelvin;
    if (i == 0) {
        double const sea = kelvin + kLapse * at;
        pressure[0] = pressureAbove(pressureSea, sea, kelvin, at);
        dewPoint[0] = dew.value_or(kelvin);
        return;
    }
    pressure[i] = pressureAbove(pressure[i - 1], temperature[i - 1], kelvin, at - altitude[i - 1]);
    dewPoint[i] = std::min(dew ? *dew : dewPointFromGround(*this, at), kelvin);
}

MassAt massAt(Masses const& m, double altitude) {
    auto const top = static_cast<std::size_t>(m.levels - 1);
    if (altitude <= m.altitude[0] || top == 0) {
        double const sea = m.temperature[0] + kLapse * m.altitude[0];
        MassAt mass = beyond(0.0, sea, m.pressureSea, altitude);
        mass.dewPoint = std::min(dewPointFromGround(m, altitude), mass.temperature);
        return mass;
    }
    if (altitude >= m.altitude[top]) {
        MassAt mass = beyond(m.altitude[top], m.temperature[top], m.pressure[top], altitude);
        mass.dewPoint = std::min(m.dewPoint[top] - kDewLapseFree * (altitude - m.altitude[top]), mass.temperature);
        return mass;
    }
    std::size_t i = 0;
    while (m.altitude[i + 1] < altitude) ++i;
    double const low = m.altitude[i], high = m.altitude[i + 1];
    double const temperature = temperatureBetween(low, high, m.temperature[i], m.temperature[i + 1], altitude);
    return {temperature, temperatureBetween(low, high, m.dewPoint[i], m.dewPoint[i + 1], altitude),
            pressureAbove(m.pressure[i], m.temperature[i], temperature, altitude - low)};
}
}  // namespace luftpost::weather
