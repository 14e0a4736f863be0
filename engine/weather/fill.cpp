#include "engine/weather/fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/diagnosis.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kZeroCelsius = 273.15;        // K
constexpr double kGustFactor = 1.567;          // gust over mean: three rms of Dryden's gusts at 10 m, near WMO-No. 8's open country
constexpr double kUnknownSpeed = 3.0;          // m/s
constexpr double kUnknownFrom = 270.0;         // deg, the westerlies
constexpr double kUsualInterval = 3600.0;      // s
constexpr double kDryLapse = 0.00976;          // K/m, dry adiabatic
constexpr double kLapseRate = 0.0065;          // K/m, standard atmosphere

/// A quantity over the reports: what was said, then the file's filling, then neighbours in time, then `otherwise`.
struct Series {
    std::vector<double> values;
    std::vector<bool> said;
};

using Said = std::function<std::optional<double>(Report const&)>;

std::optional<double> filledNumber(Filled const& filled, std::string const& place) {
    auto const found = filled.find(place);
    if (found == filled.end() || !std::holds_alternative<double>(found->second)) return std::nullopt;
    return std::get<double>(found->second);
}

std::optional<std::string> filledText(Filled const& filled, std::string const& place) {
    auto const found = filled.find(place);
    if (found == filled.end() || !std::holds_alternative<std::string>(found->second)) return std::nullopt;
    return std::get<std::string>(found->second);
}

/// Linear between the known ones, held beyond them.
double betweenKnown(std::vector<std::pair<double, double>> const& known, double time) {
    auto const after = std::lower_bound(known.begin(), known.end(), std::pair{time, -1e300});
    if (after == known.begin()) return known.front().second;
    if (after == known.end()) return known.back().second;
    auto const before = after - 1;
    return before->second + (after->second - before->second) * (time - before->first) / (after->first - before->first);
}

Series seriesOf(Site const& site, std::string const& place, Said const& said, double otherwise) {
    std::vector<std::pair<double, double>> known;
    for (Report const& report : site.reports) {
        auto value = said(report);
        if (!value) value = filledNumber(report.filled, place);
        if (value) known.emplace_back(report.time, *value);
    }
    if (known.empty()) known.emplace_back(0.0, otherwise);
    Series series;
    for (Report const& report : site.reports) {
        series.said.push_back(said(report).has_value());
        series.values.push_back(series.said.back() ? *said(report) : betweenKnown(known, report.time));
    }
    return series;
}

struct Fallen {
    Precipitation kind;
    double rate;
};

/// What a WMO weather code (Open-Meteo's subset) says of precipitation: kind and a usual rate.
std::optional<Fallen> fallenFromCode(std::optional<int> code) {
    if (!code) return std::nullopt;
    if (*code >= 51 && *code <= 55) return Fallen{Precipitation::Drizzle, 0.3};
    if (*code == 56 || *code == 57 || *code == 66 || *code == 67) return Fallen{Precipitation::FreezingRain, 1.0};
    if ((*code >= 61 && *code <= 65) || (*code >= 80 && *code <= 82)) return Fallen{Precipitation::Rain, *code % 10 * 1.5 + 0.5};
    if ((*code >= 71 && *code <= 77) || *code == 85 || *code == 86) return Fallen{Precipitation::Snow, 1.0};
    if (*code >= 95) return Fallen{Precipitation::Rain, 5.0};
    return Fallen{Precipitation::None, 0.0};
}

Precipitation kindByTemperature(double temperature) {
    if (temperature > kZeroCelsius + 2.0) return Precipitation::Rain;
    return temperature > kZeroCelsius ? Precipitation::Sleet : Precipitation::Snow;
}

void fillPrecipitation(Report const& said, FullReport& full) {
    auto const coded = fallenFromCode(said.weatherCode);
    // Nothing falls at the moment of the report, but something did in its interval: the kind of that is open too.
    bool const over = said.precipitationKind == Precipitation::None && said.rate_mm_h.value_or(0.0) > 0.0;
    bool const openKind = !said.precipitationKind || *said.precipitationKind == Precipitation::Unknown || over;
    bool const knownFalls = !openKind && *said.precipitationKind != Precipitation::None;
    if (said.rate_mm_h) {
        full.rate = *said.rate_mm_h;
    } else {
        double const usual = coded && coded->rate > 0.0 ? coded->rate : (knownFalls ? 1.0 : 0.0);
        full.rate = filledNumber(said.filled, "precipitation.rate_mm_h").value_or(usual);
        full.filled["precipitation.rate_mm_h"] = full.rate;
    }
    if (!openKind) {
        full.kind = *said.precipitationKind;
        return;
    }
    full.kind = full.rate <= 0.0 ? Precipitation::None : kindByTemperature(full.temperature);
    if (full.rate > 0.0 && coded && coded->kind != Precipitation::None) full.kind = coded->kind;
    if (auto const text = filledText(said.filled, "precipitation.kind")) full.kind = precipitationFromName(*text).value_or(full.kind);
    full.filled["precipitation.kind"] = std::string{precipitationName(full.kind)};
}

/// Where the figure is a minimum, or missing, humidity and rain say how far one sees.
void fillVisibility(Report const& said, FullReport& full) {
    if (said.visibility_m && !said.visibilityIsMinimum) {
        full.visibility = std::max(*said.visibility_m, 10.0);
        return;
    }
    double const dry = visibilityFromHumidity(relativeHumidity(full.temperature, full.dewPoint));
    // Rain of R mm/h holds 0.072 R^0.88 g/m3 and takes out 2.24 C^0.75 per km.
    double const rain = full.rate > 0.0 ? 2.24 * core::pow(0.072 * core::pow(full.rate, 0.88), 0.75) / 1000.0 : 0.0;
    double modelled = 1.0 / (1.0 / dry + rain / 3.0);
    if (said.verticalVisibility_m) modelled = std::min(modelled, std::max(2.0 * *said.verticalVisibility_m, 50.0));
    full.visibility = filledNumber(said.filled, "visibility_m").value_or(std::max(modelled, said.visibility_m.value_or(0.0)));
    full.visibility = std::max(full.visibility, 10.0);
    full.filled["visibility_m"] = full.visibility;
}

Signs signsOf(Site const& site, Report const& said, FullReport const& full) {
    Signs signs;
    signs.elevation = site.elevation_m.value_or(0.0);
    signs.spread = std::max(0.0, full.temperature - full.dewPoint);
    signs.windSpeed = glm::length(full.wind);
    signs.rate = full.rate;
    signs.thunder = full.thunder;
    signs.sunSine = sunHeight(site.lat_deg.value_or(0.0), site.lon_deg.value_or(0.0), full.time);
    signs.day = signs.sunSine > 0.087;  // 5 degrees
    signs.temperature = full.temperature;
    signs.dewPoint = full.dewPoint;
    signs.radiation = said.radiation_w_m2;
    signs.longwave = said.longwave_w_m2;
    signs.cape = said.cape_j_kg;
    signs.code = said.weatherCode;
    signs.bounds = said.coverBounds;
    signs.low = said.coverLow.value_or(0.0);
    signs.mid = said.coverMid.value_or(0.0);
    signs.high = said.coverHigh.value_or(0.0);
    return signs;
}

/// One reported layer with its gaps closed; they are listed under "layers[i].".
FullLayer fullLayer(Signs const& signs, ReportedLayer const& said, Filled const& fileFilled, std::size_t i, Filled& filled) {
    auto const place = [i](char const* part) { return fmt::format("layers[{}].{}", i, part); };
    FullLayer layer;
    layer.cover = said.cover.value_or(filledNumber(fileFilled, place("cover")).value_or(0.5));
    if (!said.cover) filled[place("cover")] = layer.cover;
    std::optional<Genus> genus = said.genus;
    if (!genus)
        if (auto const text = filledText(fileFilled, place("genus"))) genus = genusFromName(*text);
    auto const base = said.base_m ? said.base_m : filledNumber(fileFilled, place("base_m"));
    layer.genus = genus.value_or(diagnosedGenus(signs, layer.cover, base ? std::optional{*base - signs.elevation} : std::nullopt));
    if (!said.genus) filled[place("genus")] = std::string{genusName(layer.genus)};
    layer.base = base.value_or(typicalBase(signs, layer.genus));
    if (!said.base_m) filled[place("base_m")] = layer.base;
    layer.top = said.top_m.value_or(filledNumber(fileFilled, place("top_m")).value_or(typicalTop(signs, layer.genus, layer.cover, layer.base)));
    layer.top = std::max(layer.top, layer.base + 50.0);
    if (!said.top_m) filled[place("top_m")] = layer.top;
    return layer;
}

void addFilledLayer(FullLayer const& layer, FullReport& full) {
    std::size_t const i = full.layers.size();
    full.layers.push_back(layer);
    full.filled[fmt::format("layers[{}].genus", i)] = std::string{genusName(layer.genus)};
    full.filled[fmt::format("layers[{}].cover", i)] = layer.cover;
    full.filled[fmt::format("layers[{}].base_m", i)] = layer.base;
    full.filled[fmt::format("layers[{}].top_m", i)] = layer.top;
}

/// A sky of which no layer was reported: the file's own filling, else cover by level, else the total, else the obscured sky's fog,
/// else, at a place where nobody ever looks up, what comes down.
void fillUnsaidLayers(Report const& said, Signs const& signs, bool watched, FullReport& full) {
    if (said.filled.contains("layers[0].genus")) {
        for (std::size_t i = 0; said.filled.contains(fmt::format("layers[{}].genus", i)); ++i)
            full.layers.push_back(fullLayer(signs, {}, said.filled, i, full.filled));
        return;
    }
    bool const byLevel = said.coverLow || said.coverMid || said.coverHigh;
    std::optional<double> total = said.coverTotal;
    if (!total && !byLevel && !watched && !said.verticalVisibility_m) total = coverFromRadiation(signs);
    if (byLevel || total)
        for (FullLayer const& layer : byLevel ? diagnosedLayers(signs) : layersOfTotal(signs, *total)) addFilledLayer(layer, full);
    else if (said.verticalVisibility_m)
        addFilledLayer({Genus::Fog, 1.0, signs.elevation, signs.elevation + std::max(100.0, *said.verticalVisibility_m)}, full);
}

/// Whether any report says anything of clouds.
bool watched(Site const& site) {
    return std::any_of(site.reports.begin(), site.reports.end(), [](Report const& r) {
        return r.layers || r.coverLow || r.coverMid || r.coverHigh || r.coverTotal || r.verticalVisibility_m;
    });
}

/// Mist in the valleys that nobody reported: air near saturation that neither wind nor sun stirs cools in a clear night until it is fog,
/// where the land is low. Not where the report says that one sees far, nor where it says what clouds there are.
void fillValleyMist(Report const& said, Signs const& signs, FullReport& full) {
    constexpr double kMostSpread = 1.2, kMostWind = 2.5;     // K, m/s (radiation fog: George 1951)
    constexpr double kHighSun = 0.2, kClosed = 0.5;          // sine of the elevation; cover under which the ground does not cool
    constexpr double kBelow = 150.0, kDepth = 60.0;          // m, of it under and over the site
    if (said.layers || said.visibility_m.value_or(0.0) > 5000.0 || full.rate > 0.0 || signs.sunSine > kHighSun) return;
    double closed = 0.0;
    for (FullLayer const& layer : full.layers) {
        if (layer.genus == Genus::Fog || layer.base < signs.elevation + 200.0) return;
        closed = std::max(closed, layer.base < signs.elevation + 6000.0 ? layer.cover : 0.0);
    }
    double const near = 1.0 - signs.spread / kMostSpread, calm = 1.0 - signs.windSpeed / kMostWind, open = 1.0 - closed / kClosed;
    if (near <= 0.0 || calm <= 0.0 || open <= 0.0 || full.layers.size() >= static_cast<std::size_t>(kMaxLayers)) return;
    double const cover = 0.7 * std::sqrt(near * calm * open);
    if (cover >= 0.05) addFilledLayer({Genus::Fog, cover, signs.elevation - kBelow, signs.elevation + kDepth}, full);
}

void fillLayers(Site const& site, bool watched, Report const& said, FullReport& full) {
    Signs const signs = signsOf(site, said, full);
    if (!said.layers) {
        fillUnsaidLayers(said, signs, watched, full);
        if (!said.filled.contains("layers[0].genus")) fillValleyMist(said, signs, full);
        return;
    }
    for (std::size_t i = 0; i < said.layers->size(); ++i)
        full.layers.push_back(fullLayer(signs, (*said.layers)[i], said.filled, i, full.filled));
    // Layers reported only so far up (a METAR's 5,000 ft): a model's high cloud stands above them.
    if (said.layersTo_m && said.coverHigh && *said.coverHigh > 0.05)
        addFilledLayer({Genus::Ci, *said.coverHigh, typicalBase(signs, Genus::Ci),
                        typicalTop(signs, Genus::Ci, *said.coverHigh, typicalBase(signs, Genus::Ci))}, full);
}

struct WindSeries {
    std::vector<glm::dvec2> wind;
    Series speed, from;
};

std::optional<double> saidSpeed(Report const& r) { return r.speed_mps; }
std::optional<double> saidTemperature(Report const& r) { return r.temperature_c; }
std::optional<double> saidDewPoint(Report const& r) { return r.dew_point_c; }
std::optional<double> saidPressure(Report const& r) { return r.pressure_hpa; }

/// A missing direction is the vector between the neighbours that have one (through north, not through south).
WindSeries windSeries(Site const& site) {
    auto const part = [](int axis) {
        return [axis](Report const& r) -> std::optional<double> {
            if (!r.from_deg) return std::nullopt;
            return windVector(1.0, *r.from_deg)[axis];
        };
    };
    glm::dvec2 const unknown = windVector(1.0, kUnknownFrom);
    Series const east = seriesOf(site, "", part(0), unknown.x), north = seriesOf(site, "", part(1), unknown.y);
    WindSeries series;
    series.speed = seriesOf(site, "wind.speed_mps", saidSpeed, kUnknownSpeed);
    for (std::size_t i = 0; i < site.reports.size(); ++i) {
        Report const& report = site.reports[i];
        double from = windFrom_deg({east.values[i], north.values[i]});
        if (!report.from_deg) from = filledNumber(report.filled, "wind.from_deg").value_or(from);
        series.from.values.push_back(report.from_deg.value_or(from));
        series.from.said.push_back(report.from_deg.has_value());
        series.wind.push_back(windVector(series.speed.values[i], series.from.values[i]));
    }
    return series;
}

void fillWind(WindSeries const& series, std::size_t i, Report const& said, FullReport& full) {
    full.wind = series.wind[i];
    double const speed = series.speed.values[i];
    if (!series.speed.said[i]) full.filled["wind.speed_mps"] = speed;
    if (!series.from.said[i] && speed > 0.0) full.filled["wind.from_deg"] = series.from.values[i];
    full.gust = said.gust_mps.value_or(filledNumber(said.filled, "wind.gust_mps").value_or(kGustFactor * speed));
    if (!said.gust_mps) full.filled["wind.gust_mps"] = full.gust;
}

void fillMasses(Series const& temperature, Series const& dewPoint, Series const& pressure, std::size_t i, FullReport& full) {
    full.temperature = temperature.values[i] + kZeroCelsius;
    full.dewPoint = std::min(dewPoint.values[i], temperature.values[i]) + kZeroCelsius;
    full.pressureSea = pressure.values[i] * 100.0;
    if (!temperature.said[i]) full.filled["temperature_c"] = temperature.values[i];
    if (!dewPoint.said[i]) full.filled["dew_point_c"] = std::min(dewPoint.values[i], temperature.values[i]);
    if (!pressure.said[i]) full.filled["pressure_hpa"] = pressure.values[i];
}

void fillThunder(Report const& said, FullReport& full) {
    if (said.thunder) {
        full.thunder = *said.thunder;
        return;
    }
    auto const own = said.filled.find("thunder");
    bool const coded = said.weatherCode && *said.weatherCode >= 95;
    full.thunder = own != said.filled.end() && std::holds_alternative<bool>(own->second) ? std::get<bool>(own->second) : coded;
    full.filled["thunder"] = full.thunder;
}
}  // namespace

double sunHeight(double lat_deg, double lon_deg, core::UtcSeconds time) {
    double const day = time / 86400.0;
    double const declination = -core::radians(23.44) * core::cos(2.0 * core::kPi * (day + 10.0) / 365.25);
    double const hourAngle = 2.0 * core::kPi * (day - std::floor(day) - 0.5 + lon_deg / 360.0);
    double const lat = core::radians(lat_deg);
    return core::sin(lat) * core::sin(declination) + core::cos(lat) * core::cos(declination) * core::cos(hourAngle);
}

glm::dvec2 windVector(double speed, double from_deg) {
    double const angle = core::radians(from_deg);
    return glm::dvec2{-speed * core::sin(angle), -speed * core::cos(angle)};
}

double windFrom_deg(glm::dvec2 wind) {
    double const angle = core::degrees(core::atan2(-wind.x, -wind.y));
    return angle < 0.0 ? angle + 360.0 : angle;
}

double relativeHumidity(double temperature, double dewPoint) {
    auto const magnus = [](double celsius) { return 17.62 * celsius / (243.12 + celsius); };
    return std::clamp(core::exp(magnus(dewPoint - kZeroCelsius) - magnus(temperature - kZeroCelsius)), 0.0, 1.0);
}

double condensationHeight(double temperature, double dewPoint) {
    double const dew = std::min(dewPoint, temperature);
    if (dew < 60.0) return 12000.0;
    double const there = 1.0 / (1.0 / (dew - 56.0) + core::log(temperature / dew) / 800.0) + 56.0;
    return std::clamp((temperature - there) / kDryLapse, 0.0, 12000.0);
}

double visibilityFromHumidity(double humidity) { return 60000.0 * core::exp(-2.5 * (std::max(humidity, 0.15) * 100.0 - 15.0) / 80.0); }

std::vector<FullReport> fullReports(Site const& site) {
    double const elevation = site.elevation_m.value_or(0.0);
    Series const temperature = seriesOf(site, "temperature_c", saidTemperature, 15.0 - kLapseRate * elevation);
    Series const dewPoint = seriesOf(site, "dew_point_c", saidDewPoint, 7.0 - kLapseRate * elevation);
    Series const pressure = seriesOf(site, "pressure_hpa", saidPressure, 1013.25);
    WindSeries const wind = windSeries(site);
    bool const looksUp = watched(site);
    std::vector<FullReport> reports;
    for (std::size_t i = 0; i < site.reports.size(); ++i) {
        Report const& said = site.reports[i];
        FullReport full;
        full.time = said.time;
        if (auto const own = said.filled.find("time"); own != said.filled.end()) full.filled.insert(*own);
        if (!site.elevation_m) full.filled["elevation_m"] = elevation;
        full.interval = said.interval_s.value_or(i > 0 ? said.time - site.reports[i - 1].time : kUsualInterval);
        fillWind(wind, i, said, full);
        fillMasses(temperature, dewPoint, pressure, i, full);
        fillThunder(said, full);
        fillPrecipitation(said, full);
        fillVisibility(said, full);
        full.cape = said.cape_j_kg.value_or(0.0);
        full.freezingLevel = said.freezingLevel_m.value_or(elevation + (full.temperature - kZeroCelsius) / kLapseRate);
        full.snowDepth = said.snowDepth_m.value_or(0.0);
        full.levels = said.levels;
        fillLayers(site, looksUp, said, full);
        reports.push_back(std::move(full));
    }
    return reports;
}
}  // namespace luftpost::weather
