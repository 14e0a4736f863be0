#include "engine/weather/grib.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "engine/core/error.h"
#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/core/time.h"
#include "engine/weather/grib_quantity.h"
#include "engine/weather/grib_values.h"
#include "engine/weather/report_parts.h"

namespace luftpost::weather {
namespace {
constexpr double kZeroCelsius = 273.15, kGravity = 9.80665;
constexpr PlaceWish kBasel{47.541, 7.583, {}};  // the bundled recording's site
// NCEP's low, mid and high cloud meet at 642 and 350 hPa, ICON's at 800 and 400 hPa: in the standard atmosphere
constexpr CoverBounds kNcepBounds{3690.0, 8120.0}, kIconBounds{1950.0, 7190.0};
constexpr double kMostVisible = 24100.0;  // m: where GFS ends, 15 statute miles as it rounds them
constexpr std::size_t kMostRead = 5000;  // fields; a day of GFS with all its levels has some 3000

/// One field at every site.
struct Sample {
    core::UtcSeconds from = 0.0, time = 0.0;
    bool instant = true;
    std::vector<std::optional<double>> values;  // by site
};

/// What makes fields the same series.
using Series = std::tuple<GribQuantity, GribLevel, double>;
using Samples = std::map<Series, std::vector<Sample>>;

struct Spot {
    double lat_deg = 0.0, lon_deg = 0.0;
};

/// All that was read of a file.
struct Grib {
    std::string const& file;
    std::vector<Spot> spots;
    std::string where;  // of the first spot, in words
    int centre = 0;
    core::UtcSeconds run = 0.0;
    CoverBounds bounds = kNcepBounds;
    Samples samples;
    std::size_t read = 0;  // fields
};

bool isWithin(GribGrid const& grid, Spot spot) { return grid.spotOf(spot.lat_deg, spot.lon_deg).has_value(); }

Spot pointOf(GribGrid const& grid, std::size_t column, std::size_t row) { return {grid.latOf(row), grid.lonOf(column)}; }

/// The wish, else the grid point nearest to Basel, else the middle of the grid.
void choosePlace(Grib& grib, GribGrid const& grid, std::optional<PlaceWish> const& wish, std::string const& message) {
    Spot spot{wish.value_or(kBasel).lat_deg, wish.value_or(kBasel).lon_deg};
    if (wish && !isWithin(grid, spot))
        throw core::Error(
            grib.file, message,
            fmt::format("expected a grid over the place {}, found {} to {}", coordinateName(spot.lat_deg, spot.lon_deg),
                        coordinateName(grid.lat0, grid.lonOf(0)), coordinateName(grid.latOf(grid.rows - 1), grid.lonOf(grid.columns - 1))));
    if (!isWithin(grid, spot)) spot = pointOf(grid, grid.columns / 2, grid.rows / 2);
    auto const within = *grid.spotOf(spot.lat_deg, spot.lon_deg);
    auto const column = static_cast<std::size_t>(std::floor(within.column + 0.5)) % grid.columns,
               row = static_cast<std::size_t>(std::floor(within.row + 0.5));
    if (!wish) spot = pointOf(grid, column, row);
    grib.spots.push_back(spot);
    grib.where = coordinateName(spot.lat_deg, spot.lon_deg) + (wish ? "" : " (no place was asked for)");
    bool const onPoint = std::abs(within.column - std::floor(within.column + 0.5)) + std::abs(within.row - std::floor(within.row + 0.5)) < 0.02;
    std::set<std::pair<std::size_t, std::size_t>> points;
    for (std::size_t i = 0; i < 9; ++i) {
        std::size_t const c = column + grid.columns + i % 3 - 1, r = row + i / 3;  // one row too far
        bool const here = i == 4;
        if (r == 0 || r > grid.rows || (here && (onPoint || !wish)) || (!grid.around && (c < grid.columns || c >= 2 * grid.columns))) continue;
        if (points.emplace(c % grid.columns, r - 1).second) grib.spots.push_back(pointOf(grid, c % grid.columns, r - 1));
    }
}

void keep(Grib& grib, GribField const& field, GribMeaning const& meaning) {
    if (++grib.read > kMostRead) throw core::Error(grib.file, field.place, fmt::format("expected at most {} fields that are read", kMostRead));
    std::vector<double> const values = gribValues(field, grib.file);
    Sample sample{field.from, field.time, field.statistic == GribStatistic::Instant, {}};
    for (Spot const& spot : grib.spots) {
        auto const at = field.grid.spotOf(spot.lat_deg, spot.lon_deg);
        sample.values.push_back(at ? gribValueAt(values, field.grid, *at) : std::nullopt);
    }
    bool const cover = meaning.quantity >= GribQuantity::CoverTotal && meaning.quantity <= GribQuantity::CoverHigh;
    if (cover && meaning.level == GribLevel::Pressure) grib.bounds = kIconBounds;
    GribLevel const level = cover ? GribLevel::Ground : meaning.level;
    grib.samples[{meaning.quantity, level, meaning.value}].push_back(std::move(sample));
}

/// One site's view of the samples.
class SiteView {
public:
    SiteView(Grib const& grib, std::size_t site) : grib_{grib}, site_{site} {}

    /// An instant at the time.
    std::optional<double> instant(Series const& series, core::UtcSeconds time) const {
        for (Sample const& sample : samples(series))
            if (sample.instant && sample.time == time && sample.values[site_]) return sample.values[site_];
        return std::nullopt;
    }
    std::optional<double> instant(GribQuantity quantity, core::UtcSeconds time) const {
        return instant(Series{quantity, GribLevel::Ground, 0.0}, time);
    }

    /// The first that is known at any time: of what does not change.
    std::optional<double> ever(GribQuantity quantity) const {
        for (Sample const& sample : samples({quantity, GribLevel::Ground, 0.0}))
            if (sample.values[site_]) return sample.values[site_];
        return std::nullopt;
    }

    enum class Of { Mean, Sum, Maximum };
    struct Step {
        core::UtcSeconds from;
        double value;
    };
    /// What a step that ends at the time holds, the shortest if there are several; where the model adds up (or takes the mean) from
    /// further back and gives that up to an earlier time too, the difference.
    std::optional<Step> step(GribQuantity quantity, core::UtcSeconds time, Of of) const {
        Sample const* last = nullptr;
        for (Sample const& sample : samples({quantity, GribLevel::Ground, 0.0}))
            if (!sample.instant && sample.time == time && sample.from < time && sample.values[site_] && (!last || sample.from > last->from))
                last = &sample;
        if (!last) return std::nullopt;
        Sample const* before = nullptr;
        for (Sample const& sample : samples({quantity, GribLevel::Ground, 0.0}))
            if (!sample.instant && sample.from == last->from && sample.time < time && sample.time > sample.from && sample.values[site_] &&
                (!before || sample.time > before->time))
                before = &sample;
        if (!before || of == Of::Maximum) return Step{last->from, *last->values[site_]};
        auto const sum = [&](Sample const& sample) { return *sample.values[site_] * (of == Of::Sum ? 1.0 : sample.time - sample.from); };
        double const rest = sum(*last) - sum(*before);
        return Step{before->time, of == Of::Sum ? rest : rest / (time - before->time)};
    }

    /// The step that begins at the time, as its mean.
    std::optional<double> meanAfter(GribQuantity quantity, core::UtcSeconds time) const {
        std::optional<core::UtcSeconds> end;
        for (Sample const& sample : samples({quantity, GribLevel::Ground, 0.0}))
            if (!sample.instant && sample.time > time && (!end || sample.time < *end)) end = sample.time;
        auto const next = end ? step(quantity, *end, Of::Mean) : std::nullopt;
        return next && next->from == time ? std::optional{next->value} : std::nullopt;
    }

    Samples const& all() const { return grib_.samples; }

private:
    std::vector<Sample> const& samples(Series const& series) const {
        static std::vector<Sample> const none;
        auto const found = grib_.samples.find(series);
        return found == grib_.samples.end() ? none : found->second;
    }
    Grib const& grib_;
    std::size_t site_;
};

std::optional<double> within(std::optional<double> value, Range range) {
    return value ? std::optional{std::clamp(*value, range.low, range.high)} : std::nullopt;
}

/// The instant; else half way between the means of the steps before and after; else the step's before.
std::optional<double> coverAt(SiteView const& view, GribQuantity quantity, core::UtcSeconds time) {
    std::optional<double> percent = view.instant(quantity, time);
    if (!percent) {
        auto const before = view.step(quantity, time, SiteView::Of::Mean);
        auto const after = view.meanAfter(quantity, time);
        if (before) percent = after ? 0.5 * (before->value + *after) : before->value;
        else percent = after;
    }
    return percent ? within(*percent / 100.0, kCover) : std::nullopt;
}

std::optional<double> celsius(std::optional<double> kelvin) { return kelvin ? within(*kelvin - kZeroCelsius, kTemperature) : std::nullopt; }
std::optional<double> percent(std::optional<double> value) { return value ? std::optional{*value / 100.0} : std::nullopt; }

struct Wind {
    std::optional<double> speed, from;
};
Wind windOf(std::optional<double> east, std::optional<double> north) {
    if (!east || !north) return {};
    double const speed = std::min(std::sqrt(*east * *east + *north * *north), kSpeed.high);
    double const from = core::degrees(core::atan2(-*east, -*north));
    Wind wind;
    setWind(speed, from < 0.0 ? from + 360.0 : from, wind.speed, wind.from);
    return wind;
}

/// Of water, kilograms a square metre are millimetres.
void addFall(SiteView const& view, core::UtcSeconds time, Report& report) {
    if (auto const sum = view.step(GribQuantity::Water, time, SiteView::Of::Sum)) {
        report.interval_s = time - sum->from;
        report.rate_mm_h = within(std::max(sum->value, 0.0) * 3600.0 / *report.interval_s, kRate);
    } else if (auto const mean = view.step(GribQuantity::Rate, time, SiteView::Of::Mean)) {
        report.interval_s = time - mean->from;
        report.rate_mm_h = within(std::max(mean->value, 0.0) * 3600.0, kRate);
    } else if (auto const now = view.instant(GribQuantity::Rate, time)) {
        report.rate_mm_h = within(std::max(*now, 0.0) * 3600.0, kRate);
    }
    if (!report.rate_mm_h) return;
    auto const share = [&](GribQuantity quantity) {
        auto const step = view.step(quantity, time, SiteView::Of::Mean);
        return step && step->value >= 0.5;
    };
    if (*report.rate_mm_h < 0.005) report.precipitationKind = Precipitation::None;  // less than the models' own trace
    else if (share(GribQuantity::FreezingRain)) report.precipitationKind = Precipitation::FreezingRain;
    else if (share(GribQuantity::Snow)) report.precipitationKind = share(GribQuantity::Rain) ? Precipitation::Sleet : Precipitation::Snow;
    else if (share(GribQuantity::IcePellets)) report.precipitationKind = Precipitation::Sleet;
    else if (share(GribQuantity::Rain)) report.precipitationKind = Precipitation::Rain;
}

void addRadiation(SiteView const& view, core::UtcSeconds time, Report& report) {
    auto const mean = [&](GribQuantity quantity, Range range) -> std::optional<double> {
        auto const step = view.step(quantity, time, SiteView::Of::Mean);
        if (!step) return std::nullopt;
        if (!report.interval_s) report.interval_s = time - step->from;
        return within(step->value, range);
    };
    report.radiation_w_m2 = mean(GribQuantity::Radiation, kRadiation);
    report.longwave_w_m2 = mean(GribQuantity::Longwave, kLongwave);
}

/// Where a pressure lies in the standard atmosphere over that pressure at sea level. m.
double altitudeOf(double pressure, double sea) { return 288.15 / 0.0065 * (1.0 - core::pow(pressure / sea, 0.190263)); }

/// Low, mid and high cloud with the bases and tops that the model gives as pressures; a level without one keeps its cover.
void addLayers(SiteView const& view, core::UtcSeconds time, Report& report) {
    struct Row {
        GribQuantity base, top;
        std::optional<double> cover;
    };
    double const sea = report.pressure_hpa.value_or(1013.25) * 100.0;
    auto const altitude = [&](GribQuantity quantity) -> std::optional<double> {
        auto pressure = view.instant(quantity, time);
        if (auto const step = view.step(quantity, time, SiteView::Of::Mean); !pressure && step) pressure = step->value;
        if (!pressure || *pressure < 5000.0 || *pressure > 110000.0) return std::nullopt;
        return within(altitudeOf(*pressure, sea), kCloudHeight);
    };
    std::vector<ReportedLayer> layers;
    bool anyBase = false;
    for (Row const& row :
         {Row{GribQuantity::BaseLow, GribQuantity::TopLow, report.coverLow}, Row{GribQuantity::BaseMid, GribQuantity::TopMid, report.coverMid},
          Row{GribQuantity::BaseHigh, GribQuantity::TopHigh, report.coverHigh}}) {
        if (!row.cover) return;
        if (*row.cover < 0.01) continue;
        ReportedLayer layer{{}, row.cover, altitude(row.base), altitude(row.top)};
        if (layer.base_m && layer.top_m && *layer.top_m <= *layer.base_m) layer.top_m.reset();
        anyBase = anyBase || layer.base_m;
        layers.push_back(layer);
    }
    if (anyBase) report.layers = layers;
}

void addLevels(SiteView const& view, core::UtcSeconds time, std::optional<double> elevation, Report& report) {
    std::set<std::pair<GribLevel, double>> places;
    for (auto const& [series, samples] : view.all())
        if (std::get<1>(series) != GribLevel::Ground) places.emplace(std::get<1>(series), std::get<2>(series));
    for (auto const& [kind, value] : places) {
        auto const at = [&](GribQuantity quantity) { return view.instant(Series{quantity, kind, value}, time); };
        std::optional<double> altitude;
        if (kind == GribLevel::AboveSea) altitude = value;
        if (kind == GribLevel::AboveGround && elevation) altitude = *elevation + value;
        if (kind == GribLevel::Pressure) altitude = at(GribQuantity::Height);
        if (auto const geopotential = at(GribQuantity::Geopotential); kind == GribLevel::Pressure && !altitude && geopotential)
            altitude = *geopotential / kGravity;
        if (!altitude || *altitude < kAltitude.low || *altitude > kAltitude.high) continue;
        ReportedLevel level{*altitude, celsius(at(GribQuantity::Temperature)), {}, {}, {}, within(percent(at(GribQuantity::Cover)), kCover)};
        level.dew_point_c = dewPoint_c(level.temperature_c, percent(at(GribQuantity::Humidity)));
        Wind const wind = windOf(at(GribQuantity::EastWind), at(GribQuantity::NorthWind));
        level.speed_mps = wind.speed;
        level.from_deg = wind.from;
        if (level.temperature_c || level.dew_point_c || level.speed_mps || level.cover) report.levels.push_back(level);
    }
    orderLevels(report.levels, elevation.value_or(kAltitude.low) + 10.0);
}

Report reportOf(Grib const& grib, SiteView const& view, core::UtcSeconds time, std::optional<double> elevation) {
    Report report;
    report.time = time;
    report.temperature_c = celsius(view.instant(GribQuantity::Temperature, time));
    report.dew_point_c = celsius(view.instant(GribQuantity::DewPoint, time));
    if (!report.dew_point_c) report.dew_point_c = dewPoint_c(report.temperature_c, percent(view.instant(GribQuantity::Humidity, time)));
    Wind const wind = windOf(view.instant(GribQuantity::EastWind, time), view.instant(GribQuantity::NorthWind, time));
    report.speed_mps = wind.speed;
    report.from_deg = wind.from;
    report.gust_mps = within(view.instant(GribQuantity::Gust, time), kSpeed);
    addFall(view, time, report);
    if (auto const gust = view.step(GribQuantity::Gust, time, SiteView::Of::Maximum); gust && !report.gust_mps) {
        report.gust_mps = within(gust->value, kSpeed);
        if (!report.interval_s) report.interval_s = time - gust->from;
    }
    addRadiation(view, time, report);
    if (auto const sea = view.instant(GribQuantity::SeaPressure, time)) report.pressure_hpa = within(*sea / 100.0, kPressure);
    else if (auto const station = view.instant(GribQuantity::StationPressure, time); station && elevation && *station > 30000.0)
        fillSeaPressure(report, *station / 100.0, *elevation, grib.file, "surface pressure");
    report.coverBounds = grib.bounds;
    report.coverLow = coverAt(view, GribQuantity::CoverLow, time);
    report.coverMid = coverAt(view, GribQuantity::CoverMid, time);
    report.coverHigh = coverAt(view, GribQuantity::CoverHigh, time);
    report.coverTotal = coverAt(view, GribQuantity::CoverTotal, time);
    addLayers(view, time, report);
    report.visibility_m = within(view.instant(GribQuantity::Visibility, time), kVisibility);
    report.visibilityIsMinimum = report.visibility_m && *report.visibility_m >= kMostVisible && *report.visibility_m < kMostVisible + 100.0;
    report.cape_j_kg = within(view.instant(GribQuantity::Cape, time), kCape);
    report.freezingLevel_m = within(view.instant(GribQuantity::FreezingLevel, time), kFreezingLevel);
    report.snowDepth_m = within(view.instant(GribQuantity::SnowDepth, time), kSnowDepth);
    addLevels(view, time, elevation, report);
    return report;
}

std::set<core::UtcSeconds> timesOf(Samples const& samples) {
    std::set<core::UtcSeconds> times;
    for (auto const& [series, list] : samples)
        for (Sample const& sample : list) times.insert(sample.time);
    return times;
}

std::string_view centreName(int centre) {
    switch (centre) {
        case 7: return "NCEP";
        case 54: return "Canadian Meteorological Centre";
        case 74: return "UK Met Office";
        case 78: return "DWD";
        case 85: return "Meteo-France";
        case 98: return "ECMWF";
        case 215: return "MeteoSwiss";
        default: return "a weather centre";
    }
}

std::string_view licenceOf(int centre) {
    switch (centre) {
        case 7: return "US public domain";
        case 78: return "CC BY 4.0, Deutscher Wetterdienst";
        case 98: return "CC BY 4.0, ECMWF open data";
        default: return "as the centre says";
    }
}
}  // namespace

bool looksLikeGrib(std::string_view bytes) { return bytes.starts_with("GRIB"); }

Recording parseGrib(std::string_view bytes, std::string const& file, std::optional<PlaceWish> const& place) {
    Grib grib{file, {}, {}, 0, 0.0, kNcepBounds, {}, 0};
    forEachGribField(
        bytes, file, [](GribField const& field) { return gribMeaning(field).has_value(); },
        [&](GribField const& field) {
            if (grib.spots.empty()) {
                choosePlace(grib, field.grid, place, field.place);
                grib.centre = field.centre;
                grib.run = field.reference;
            }
            keep(grib, field, *gribMeaning(field));
        });
    if (grib.spots.empty()) throw core::Error(file, "", "expected at least one field that a report has a place for");
    auto const times = timesOf(grib.samples);
    if (times.size() * grib.spots.size() > kMostReports) throw core::Error(file, "", fmt::format("expected at most {} reports", kMostReports));
    Recording recording;
    recording.file = file;
    for (std::size_t i = 0; i < grib.spots.size(); ++i) {
        SiteView const view{grib, i};
        Spot const& spot = grib.spots[i];
        Site site{coordinateName(spot.lat_deg, spot.lon_deg), spot.lat_deg, spot.lon_deg, within(view.ever(GribQuantity::Elevation), kElevation), {}};
        for (core::UtcSeconds const time : times) site.reports.push_back(reportOf(grib, view, time, site.elevation_m));
        keepWhatSpeaks(site.reports);
        if (!site.reports.empty()) recording.sites.push_back(std::move(site));
    }
    if (recording.sites.empty()) throw core::Error(file, "", "expected a value at the place, found none");
    recording.name = fmt::format("{} run of {}, {}", centreName(grib.centre), core::formatUtc(grib.run).substr(0, 13) + "Z", grib.where);
    recording.source = fmt::format("{} (GRIB2, model data)", centreName(grib.centre));
    recording.licence = licenceOf(grib.centre);
    recording.sha256 = sha256Hex(bytes);
    return recording;
}
}  // namespace luftpost::weather
