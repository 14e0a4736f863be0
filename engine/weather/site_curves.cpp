#include "engine/weather/site_curves.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"

namespace luftpost::weather {
namespace {
constexpr double kMeanHours = 1.5;       // h to either side: the wind that the free air above goes by
constexpr double kZeroCelsius = 273.15;  // K

std::vector<double> column(std::vector<FullReport> const& reports, double FullReport::*member) {
    std::vector<double> values;
    for (FullReport const& report : reports) values.push_back(report.*member);
    return values;
}
}  // namespace

std::vector<Window> windowsOf(SiteData const& data) {
    std::vector<Window> windows;
    for (auto const& [front, window] : data.fronts) windows.push_back(window);
    return windows;
}

/// A curve through the values; where a front passes, what was before holds up to its window and what is behind it holds after.
Curve steppedCurve(std::vector<double> const& times, std::vector<double> const& values, std::vector<Window> const& windows) {
    std::vector<double> knots, heights;
    for (std::size_t k = 0; k < times.size(); ++k) {
        knots.push_back(times[k]);
        heights.push_back(values[k]);
        if (k + 1 == times.size()) break;
        Window const span = windowWithin(windows, times[k], times[k + 1]);
        if (span.from > times[k] + 1.0) {
            knots.push_back(span.from);
            heights.push_back(values[k]);
        }
        if (span.to < times[k + 1] - 1.0) {
            knots.push_back(span.to);
            heights.push_back(values[k + 1]);
        }
    }
    return {knots, heights};
}

namespace {
VectorCurve steppedCurve(std::vector<double> const& times, std::vector<glm::dvec2> const& values, std::vector<Window> const& windows) {
    std::vector<double> east, north;
    for (glm::dvec2 const value : values) {
        east.push_back(value.x);
        north.push_back(value.y);
    }
    VectorCurve curve;
    curve.east = steppedCurve(times, east, windows);
    curve.north = steppedCurve(times, north, windows);
    return curve;
}

/// Intervals and their mean rates.
struct Rates {
    std::vector<double> edges, rates;
    void add(double to, double rate) {
        edges.push_back(to);
        rates.push_back(rate);
    }
};

/// One interval; a front within it brings what falls in it, before there is no more than in the interval before. The sum stays.
void addInterval(Rates& sums, double to, double rate, std::vector<Window> const& windows) {
    double const from = sums.edges.back();
    Window const span = windowWithin(windows, from, to);
    if (span.from <= from + 1.0 || to - span.from < 1.0) return sums.add(to, rate);
    double const before = std::min(rate, sums.rates.empty() ? rate : sums.rates.back());
    double const behind = (rate * (to - from) - before * (span.from - from)) / (to - span.from);
    sums.add(span.from, before);
    sums.add(to, behind);
}

/// Sums over the reports' intervals. A hole between two of them goes over evenly from one rate to the other; an interval that
/// reaches back over the report before counts from there on.
SumCurve rateCurve(std::vector<FullReport> const& reports, std::vector<Window> const& windows) {
    Rates sums{{reports.front().time - reports.front().interval}, {}};
    sums.add(reports.front().time, reports.front().rate);
    for (std::size_t k = 1; k < reports.size(); ++k) {
        double const gap = reports[k].time - reports[k - 1].time - reports[k].interval;
        if (gap > 1.0) sums.add(reports[k - 1].time + gap, 0.5 * (reports[k - 1].rate + reports[k].rate));
        addInterval(sums, reports[k].time, reports[k].rate, windows);
    }
    return {sums.edges, sums.rates};
}

/// Maxima of the intervals; the gusts of a front begin with it.
MaximumCurve gustCurve(std::vector<FullReport> const& reports, std::vector<Window> const& windows) {
    std::vector<double> ends, maxima;
    for (std::size_t k = 0; k < reports.size(); ++k) {
        if (k > 0) {
            Window const span = windowWithin(windows, reports[k - 1].time, reports[k].time);
            if (span.from > reports[k - 1].time + 1.0 && reports[k].time - span.from > 1.0) {
                ends.push_back(span.from);
                maxima.push_back(reports[k - 1].gust);
            }
        }
        ends.push_back(reports[k].time);
        maxima.push_back(reports[k].gust);
    }
    return {ends, maxima};
}

/// The mean of a vector curve over `kMeanHours` to either side of each of its knots, by its exact integral.
VectorCurve runningMean(VectorCurve const& wind, std::vector<double> const& times) {
    std::vector<glm::dvec2> means;
    double const half = kMeanHours * 3600.0;
    for (double const time : times) means.push_back((wind.integralTo(time + half) - wind.integralTo(time - half)) / (2.0 * half));
    return {times, means};
}

/// A report's level winds at an altitude: linear between its levels, nothing beyond them.
std::optional<glm::dvec2> levelWind(FullReport const& report, double altitude) {
    std::optional<std::pair<double, glm::dvec2>> below;
    for (ReportedLevel const& level : report.levels) {
        if (!level.speed_mps || !level.from_deg) continue;
        glm::dvec2 const wind = windVector(*level.speed_mps, *level.from_deg);
        if (level.altitude_m == altitude) return wind;
        if (level.altitude_m > altitude) {
            if (!below) return std::nullopt;
            return below->second + (wind - below->second) * ((altitude - below->first) / (level.altitude_m - below->first));
        }
        below = {level.altitude_m, wind};
    }
    return std::nullopt;
}

/// In order, each once, and no more than a profile can hold.
std::vector<double> thinnedAltitudes(std::vector<double> altitudes) {
    std::sort(altitudes.begin(), altitudes.end());
    altitudes.erase(std::unique(altitudes.begin(), altitudes.end(), [](double a, double b) { return b - a < 1.0; }), altitudes.end());
    std::size_t const most = Profile::kMaxLevels;
    if (altitudes.size() <= most) return altitudes;
    std::vector<double> thinned;
    for (std::size_t i = 0; i < most; ++i) thinned.push_back(altitudes[i * (altitudes.size() - 1) / (most - 1)]);
    return thinned;
}

/// Altitudes at which any report has a wind.
std::vector<double> levelAltitudes(std::vector<FullReport> const& reports, double lowest) {
    std::vector<double> altitudes;
    for (FullReport const& report : reports)
        for (ReportedLevel const& level : report.levels)
            if (level.speed_mps && level.from_deg && level.altitude_m > lowest) altitudes.push_back(level.altitude_m);
    return thinnedAltitudes(std::move(altitudes));
}

std::vector<LevelCurve> levelCurves(SiteData const& data, std::vector<Window> const& windows) {
    std::vector<LevelCurve> curves;
    for (double const altitude : levelAltitudes(data.reports, data.elevation + 15.0)) {
        std::vector<double> times;
        std::vector<glm::dvec2> winds;
        for (FullReport const& report : data.reports)
            if (auto const wind = levelWind(report, altitude)) {
                times.push_back(report.time);
                winds.push_back(*wind);
            }
        if (!times.empty()) curves.push_back({altitude, steppedCurve(times, winds, windows)});
    }
    return curves;
}

/// A report's temperature or dew point at an altitude: linear between the levels that have it, nothing beyond them.
std::optional<double> levelValue(FullReport const& report, double altitude, std::optional<double> ReportedLevel::*member) {
    std::optional<std::pair<double, double>> below;
    for (ReportedLevel const& level : report.levels) {
        if (!(level.*member)) continue;
        double const value = *(level.*member) + kZeroCelsius;
        if (level.altitude_m == altitude) return value;
        if (level.altitude_m > altitude) {
            if (!below) return std::nullopt;
            return below->second + (value - below->second) * ((altitude - below->first) / (level.altitude_m - below->first));
        }
        below = {level.altitude_m, value};
    }
    return std::nullopt;
}

std::vector<double> massAltitudes(SiteData const& data) {
    std::vector<double> altitudes;
    for (FullReport const& report : data.reports)
        for (ReportedLevel const& level : report.levels)
            if (level.temperature_c && level.altitude_m > data.elevation + 15.0) altitudes.push_back(level.altitude_m);
    return thinnedAltitudes(std::move(altitudes));
}

std::vector<MassCurve> massCurves(SiteData const& data, std::vector<Window> const& windows) {
    std::vector<MassCurve> curves;
    for (double const altitude : massAltitudes(data)) {
        std::vector<double> times, dewTimes, temperatures, dewPoints;
        for (FullReport const& report : data.reports) {
            if (auto const temperature = levelValue(report, altitude, &ReportedLevel::temperature_c)) {
                times.push_back(report.time);
                temperatures.push_back(*temperature);
            }
            if (auto const dewPoint = levelValue(report, altitude, &ReportedLevel::dew_point_c)) {
                dewTimes.push_back(report.time);
                dewPoints.push_back(*dewPoint);
            }
        }
        if (times.empty()) continue;
        curves.push_back({altitude, steppedCurve(times, temperatures, windows), {}});
        if (!dewTimes.empty()) curves.back().dewPoint = steppedCurve(dewTimes, dewPoints, windows);
    }
    return curves;
}

/// What of the blended quantities any of a site's reports says itself.
std::array<bool, kQuantities> knownBy(Site const& site) {
    std::array<bool, kQuantities> knows{};
    auto const note = [&](Quantity quantity, bool said) { knows[static_cast<std::size_t>(quantity)] |= said; };
    for (Report const& r : site.reports) {
        auto const fills = [&](char const* place) { return r.filled.contains(place); };
        note(Quantity::Wind, r.speed_mps || fills("wind.speed_mps"));
        note(Quantity::Gust, r.gust_mps || r.speed_mps || fills("wind.gust_mps"));
        note(Quantity::Temperature, r.temperature_c || fills("temperature_c"));
        note(Quantity::DewPoint, r.dew_point_c || fills("dew_point_c"));
        note(Quantity::Pressure, r.pressure_hpa || fills("pressure_hpa"));
        note(Quantity::Visibility, r.visibility_m || r.verticalVisibility_m || fills("visibility_m") || r.dew_point_c);
        note(Quantity::Precipitation, r.rate_mm_h || r.precipitationKind || r.weatherCode || fills("precipitation.rate_mm_h"));
        note(Quantity::Cape, r.cape_j_kg.has_value());
        note(Quantity::FreezingLevel, r.freezingLevel_m || r.temperature_c);
        note(Quantity::Snow, r.snowDepth_m.has_value());
        note(Quantity::Clouds, r.layers || r.coverLow || r.coverMid || r.coverHigh || r.coverTotal || r.verticalVisibility_m || r.radiation_w_m2 || r.longwave_w_m2);
    }
    return knows;
}
}  // namespace

double turn(double degrees) { return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0); }

glm::dvec2 eastNorthOf(Site const& site, core::Place const& place) {
    double const degree = core::radians(1.0) * core::kEarthRadius;
    return {turn(site.lon_deg.value_or(place.lon_deg) - place.lon_deg) * degree * core::cos(core::radians(place.lat_deg)),
            (site.lat_deg.value_or(place.lat_deg) - place.lat_deg) * degree};
}

SiteData siteData(Site const& site, core::Place const& place) {
    SiteData data;
    glm::dvec2 const at = eastNorthOf(site, place);
    data.elevation = site.elevation_m.value_or(0.0);
    data.east = at.x;
    data.north = at.y;
    data.southern = site.lat_deg.value_or(place.lat_deg) < 0.0;
    data.reports = fullReports(site);
    data.times = column(data.reports, &FullReport::time);
    data.tracks = siteTracks(data.reports);
    data.knows = knownBy(site);
    return data;
}

/// All that changes over a site with time.
void drawCurves(SiteData& data) {
    std::vector<Window> const windows = windowsOf(data);
    auto const curve = [&](double FullReport::*member) { return steppedCurve(data.times, column(data.reports, member), windows); };
    data.temperature = curve(&FullReport::temperature);
    data.dewPoint = curve(&FullReport::dewPoint);
    data.pressureSea = curve(&FullReport::pressureSea);
    data.cape = curve(&FullReport::cape);
    data.freezingLevel = curve(&FullReport::freezingLevel);
    data.snowDepth = curve(&FullReport::snowDepth);
    std::vector<double> visibility = column(data.reports, &FullReport::visibility);
    for (double& value : visibility) value = core::log(value);
    data.logVisibility = steppedCurve(data.times, visibility, windows);
    std::vector<glm::dvec2> winds;
    for (FullReport const& report : data.reports) winds.push_back(report.wind);
    data.wind = steppedCurve(data.times, winds, windows);
    data.windMean = runningMean(data.wind, data.times);
    data.gust = gustCurve(data.reports, windows);
    data.rate = rateCurve(data.reports, windows);
    data.levels = levelCurves(data, windows);
    data.masses = massCurves(data, windows);
}
}  // namespace luftpost::weather
