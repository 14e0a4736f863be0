// What a METAR's groups mean for the field.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/weather/genera.h"
#include "engine/weather/metar.h"

namespace luftpost::weather {
namespace {
constexpr double kSignificantHeight = 1524.0;   // m: 5,000 ft; higher cloud need not be reported
constexpr double kCeilometerHeight = 3657.6;    // m: 12,000 ft, as far as American automatic stations look
constexpr double kToweringThickness = 4000.0;   // m: cumulus congestus, 2 to 5 km (WMO Cloud Atlas)
constexpr double kHour = 3600.0;                // s
constexpr int kRoutineMinute = 53;              // American hourly reports are made then
constexpr double kFarOff = 30.0;                // hPa: more between Q or A and SLP is an error of writing
constexpr double kSameHeight = 160.0;           // m: the remark's layer is the body's

bool american(Metar const& metar) { return metar.station.starts_with('K') || metar.station.starts_with('P'); }

/// Own shares of layers of which each amount includes those below (FMH-1): (S_k - S_(k-1)) / (1 - S_(k-1)).
void toOwnShares(std::vector<ReportedLayer>& layers) {
    double below = 0.0;
    for (ReportedLayer& layer : layers) {
        if (!layer.cover) continue;
        double const sum = *layer.cover;
        if (below < 1.0) layer.cover = std::max(0.0, (sum - below) / (1.0 - below));
        else layer.cover.reset();  // above a closed layer: not seen
        below = std::max(below, sum);
    }
}

/// The genus that the remarks give a layer: by height, else one for one in the same order.
std::optional<Genus> remarkedGenus(Metar const& metar, std::size_t i) {
    if (metar.genera.empty()) return std::nullopt;
    MetarCloud const& cloud = (*metar.clouds)[i];
    if (metar.genera.front().height_m) {
        for (MetarGenus const& genus : metar.genera)
            if (genus.height_m && cloud.height_m && std::abs(*genus.height_m - *cloud.height_m) < kSameHeight) return genus.genus;
        return std::nullopt;
    }
    if (metar.genera.size() != metar.clouds->size()) return std::nullopt;
    return metar.genera[i].genus;
}

void setLayers(Metar const& metar, double elevation, Report& report) {
    if (!metar.clouds) return;
    report.layers.emplace();
    double highest = kSignificantHeight;
    for (std::size_t i = 0; i < metar.clouds->size(); ++i) {
        MetarCloud const& cloud = (*metar.clouds)[i];
        ReportedLayer layer{cloud.genus, cloud.amount, std::nullopt, std::nullopt};
        if (cloud.height_m) layer.base_m = elevation + *cloud.height_m;
        if (cloud.genus == Genus::Cu && layer.base_m) report.filled[fmt::format("layers[{}].top_m", i)] = *layer.base_m + kToweringThickness;
        if (auto const genus = cloud.genus ? std::nullopt : remarkedGenus(metar, i))
            report.filled[fmt::format("layers[{}].genus", i)] = std::string{genusName(*genus)};
        highest = std::max(highest, cloud.height_m.value_or(0.0));
        report.layers->push_back(layer);
    }
    if (american(metar)) toOwnShares(*report.layers);
    // With layers listed: an American observer sees the whole sky, an automatic station as far as it looks, others need
    // say nothing above 5,000 ft.
    if (metar.clouds->empty()) {
        if (metar.cloudsTo_m) report.layersTo_m = elevation + *metar.cloudsTo_m;
    } else if (!american(metar)) {
        report.layersTo_m = elevation + highest;
    } else if (metar.automatic) {
        report.layersTo_m = elevation + std::max(kCeilometerHeight, highest);
    }
}

/// The sky that VV hides: fog from the ground up, or cloud above what falls.
void setObscured(Metar const& metar, double elevation, Report& report) {
    if (!metar.obscured) return;
    report.verticalVisibility_m = metar.verticalVisibility_m;
    double const seen = metar.verticalVisibility_m.value_or(30.0);  // VV///: less than can be measured
    bool const falls = report.precipitationKind.value_or(Precipitation::None) != Precipitation::None;
    bool const fog = std::any_of(metar.weather.begin(), metar.weather.end(), [](MetarWeather const& w) { return w.obscures && !w.vicinity; });
    bool const fromGround = fog || !falls;
    report.filled["layers[0].genus"] = std::string{genusName(fromGround ? Genus::Fog : Genus::St)};
    report.filled["layers[0].cover"] = 1.0;
    report.filled["layers[0].base_m"] = fromGround ? elevation : elevation + seen;
    report.filled["layers[0].top_m"] = fromGround ? elevation + std::max(100.0, seen) : elevation + seen + 400.0;
}

/// mm/h that go with a word: FMH-1 table 8-5 for rain (light to 2.5, heavy over 7.6) and drizzle; the others in water, by habit.
double usualRate(Precipitation kind, int intensity) {
    auto const of = [intensity](double light, double moderate, double heavy) { return intensity < 0 ? light : (intensity > 0 ? heavy : moderate); };
    switch (kind) {
        case Precipitation::None: return 0.0;
        case Precipitation::Drizzle: return of(0.2, 0.4, 0.7);
        case Precipitation::Rain: return of(1.0, 5.0, 12.0);
        case Precipitation::Snow: return of(0.5, 1.5, 3.0);
        case Precipitation::Sleet: return of(0.8, 2.5, 6.0);
        case Precipitation::Hail: return of(2.0, 8.0, 20.0);
        case Precipitation::FreezingRain: return of(0.5, 2.0, 5.0);
        case Precipitation::Unknown: return of(0.5, 1.5, 3.0);
    }
    return 0.0;
}

/// True when what follows the wind was written at all: then silence about the weather means that there is none.
bool saysMore(Metar const& metar) {
    return metar.visibility.visibility_m || metar.clouds || metar.obscured || metar.temperature.temperature_c || metar.pressure_hpa;
}

/// Whether nothing said of the weather means nothing there. An automatic station says "//" where it cannot tell; AO1 tells
/// no precipitation, and without a lightning detector ("///" for the type of cloud, TSNO) no thunder.
struct Sight {
    bool precipitation, thunder;
};

Sight sightOf(Metar const& metar) {
    bool const looks = saysMore(metar) && !metar.weatherMissing && metar.automaticType != 1;
    bool const hidden = metar.clouds && std::any_of(metar.clouds->begin(), metar.clouds->end(), [](MetarCloud const& c) { return c.typeHidden; });
    return {looks && !metar.weatherBlind, looks && !metar.thunderBlind && !(metar.automatic && hidden)};
}

void setWeather(Metar const& metar, Report& report) {
    Sight const sight = sightOf(metar);
    int intensity = 0;
    for (MetarWeather const& weather : metar.weather) {
        if (weather.thunder) report.thunder = true;
        if (report.precipitationKind || !weather.kind) continue;
        report.precipitationKind = weather.kind;
        intensity = weather.intensity;
    }
    if (!report.precipitationKind && sight.precipitation) report.precipitationKind = Precipitation::None;
    if (!report.thunder && sight.thunder) report.thunder = false;
    // P0000 is a trace: it says that something fell, not how much.
    if (metar.fallen_mm.value_or(0.0) > 0.0 && metar.time) {
        bool const routine = metar.time->minute >= kRoutineMinute - 3;
        report.interval_s = routine ? kHour : (metar.time->minute + 60 - kRoutineMinute) * 60.0;
        report.rate_mm_h = *metar.fallen_mm * kHour / *report.interval_s;
    } else if (report.precipitationKind.value_or(Precipitation::None) != Precipitation::None) {
        report.filled["precipitation.rate_mm_h"] = usualRate(*report.precipitationKind, intensity);
    }
}

/// Tenths from the remarks where they agree with the body, or the body has none.
std::optional<double> precise(std::optional<double> whole, std::optional<double> tenths) {
    if (!tenths || (whole && std::abs(*tenths - *whole) > 1.0)) return whole;
    return tenths;
}

/// SLP leaves the hundreds out: those that come nearest to the altimeter setting.
void setPressure(Metar const& metar, Report& report) {
    report.pressure_hpa = metar.pressure_hpa;
    if (!metar.seaLevel) return;
    double const tens = *metar.seaLevel / 10.0, near = metar.pressure_hpa.value_or(1000.0);
    double const low = 900.0 + tens, high = 1000.0 + tens;
    double const pressure = std::abs(low - near) < std::abs(high - near) ? low : high;
    if (std::abs(pressure - near) <= kFarOff || !metar.pressure_hpa) report.pressure_hpa = pressure;
}
}  // namespace

Report reportOf(Metar const& metar, std::optional<double> elevation_m) {
    Report report;
    double const elevation = elevation_m.value_or(0.0);
    report.speed_mps = metar.wind.speed_mps;
    report.gust_mps = metar.wind.gust_mps;
    report.from_deg = metar.wind.from_deg;
    report.visibility_m = metar.visibility.visibility_m;
    report.visibilityIsMinimum = metar.visibility.isMinimum;
    report.temperature_c = precise(metar.temperature.temperature_c, metar.tenths.temperature_c);
    report.dew_point_c = precise(metar.temperature.dew_point_c, metar.tenths.dew_point_c);
    setPressure(metar, report);
    setWeather(metar, report);
    setLayers(metar, elevation, report);
    setObscured(metar, elevation, report);
    return report;
}
}  // namespace luftpost::weather
