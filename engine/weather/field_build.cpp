// From a recording to the curves of a Field.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/field_data.h"

namespace luftpost::weather {
namespace {
constexpr double kNowhere = 1e9;           // m
constexpr double kMeanHours = 1.5;         // h to either side: the wind that the free air above goes by
constexpr double kZeroCelsius = 273.15;    // K
constexpr double kBoundaryHeight = 300.0;  // m above ground: its wind carries the turbulence

std::vector<double> column(std::vector<FullReport> const& reports, double FullReport::*member) {
    std::vector<double> values;
    for (FullReport const& report : reports) values.push_back(report.*member);
    return values;
}

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

/// A difference of longitudes the short way round. Degrees.
double turn(double degrees) { return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0); }

SiteData siteData(Site const& site, core::Place const& place) {
    SiteData data;
    double const degree = core::radians(1.0) * core::kEarthRadius;
    data.elevation = site.elevation_m.value_or(0.0);
    data.east = turn(site.lon_deg.value_or(place.lon_deg) - place.lon_deg) * degree * core::cos(core::radians(place.lat_deg));
    data.north = (site.lat_deg.value_or(place.lat_deg) - place.lat_deg) * degree;
    data.southern = site.lat_deg.value_or(place.lat_deg) < 0.0;
    data.reports = fullReports(site);
    data.times = column(data.reports, &FullReport::time);
    data.tracks = siteTracks(data.reports);
    data.knows = knownBy(site);
    return data;
}

/// Sites whose place nobody knows stand alone, far from everywhere: each answers for itself and blends into nothing else. Where
/// no place is known at all the first site is here.
void setApart(std::vector<Site> const& said, std::vector<SiteData>& sites) {
    bool const placed = std::any_of(said.begin(), said.end(), [](Site const& site) { return site.lat_deg.has_value(); });
    for (std::size_t i = placed ? 0 : 1; i < sites.size(); ++i)
        if (!said[i].lat_deg) sites[i].east = kNowhere * static_cast<double>(i + 1);
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

unsigned patternId(Genus genus, unsigned ordinal) {
    unsigned x = static_cast<unsigned>(genus) * 0x9E3779B9u + ordinal * 0x85EBCA6Bu + 0x27D4EB2Fu;
    x = (x ^ (x >> 15)) * 0x2C1B3C6Du;
    x = (x ^ (x >> 12)) * 0x297A2D39u;
    return x ^ (x >> 15);
}

/// The wish, else the first site whose place is known; without an altitude the nearest site's elevation.
core::Place placeOf(Recording const& recording, std::optional<PlaceWish> const& wish) {
    auto const placed = std::find_if(recording.sites.begin(), recording.sites.end(), [](Site const& site) { return site.lat_deg.has_value(); });
    Site const& first = placed == recording.sites.end() ? recording.sites.front() : *placed;
    core::Place place{first.lat_deg.value_or(0.0), first.lon_deg.value_or(0.0), first.elevation_m.value_or(0.0)};
    if (!wish) return place;
    place.lat_deg = wish->lat_deg;
    place.lon_deg = wish->lon_deg;
    double nearest = 1e300;
    for (Site const& site : recording.sites) {
        if (!site.lat_deg || !site.lon_deg) continue;
        double const north = *site.lat_deg - place.lat_deg;
        double const east = turn(*site.lon_deg - place.lon_deg) * core::cos(core::radians(place.lat_deg));
        if (north * north + east * east >= nearest) continue;
        nearest = north * north + east * east;
        place.altitude_m = site.elevation_m.value_or(0.0);
    }
    place.altitude_m = wish->altitude_m.value_or(place.altitude_m);
    return place;
}
constexpr double kLittle = 1e-3;  // what the sites that do not count at the origin weigh together

struct SiteShare {
    std::size_t site;
    double share;
};

/// The sites that count, of shares that sum to 1: of a thousand stations around the world but a few.
std::vector<SiteShare> countingShares(std::vector<double> const& all) {
    std::vector<SiteShare> shares;
    for (std::size_t i = 0; i < all.size(); ++i) shares.push_back({i, all[i]});
    std::stable_sort(shares.begin(), shares.end(), [](SiteShare const& a, SiteShare const& b) { return a.share > b.share; });
    double sum = 0.0;
    std::size_t count = 0;
    while (count < shares.size() && sum < 1.0 - kLittle) sum += shares[count++].share;
    shares.resize(count);
    for (SiteShare& own : shares) own.share /= sum;
    return shares;
}

/// The wind over the origin at one moment.
struct OriginWind {
    struct Site {
        double share, elevation;
        Profile profile;
    };
    std::vector<Site> sites;
    glm::dvec2 at(double altitude) const {
        glm::dvec2 wind{0.0};
        for (Site const& site : sites) wind += site.share * windAt(site.profile, altitude, site.elevation);
        return wind;
    }
};

/// The middle of a track's layer over the origin. m above sea level.
double trackMiddle(std::vector<SiteData> const& sites, std::vector<double> const& shares, std::size_t track, double time) {
    double middle = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        auto const& curves = sites[i].curves[track];
        if (!curves) continue;
        middle += shares[i] * 0.5 * (curves->base.at(time) + curves->top.at(time));
        sum += shares[i];
    }
    return middle / sum;
}
}  // namespace

std::vector<double> Field::Data::allTimes() const {
    std::vector<double> times;
    for (SiteData const& site : sites) times.insert(times.end(), site.times.begin(), site.times.end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// Fronts over the sites, joined; each site's windows in which they change its weather.
void Field::Data::findFronts() {
    std::vector<FrontPass> passes;
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (FrontSeen const& seen : frontsOver(sites[i].reports)) passes.push_back({i, sites[i].east, sites[i].north, seen, 0.0});
    fronts = joinedFronts(std::move(passes));
    for (std::size_t f = 0; f < fronts.size(); ++f)
        for (FrontPass const& pass : fronts[f].passes) {
            SiteData& site = sites[pass.site];
            Window window = fronts[f].windowAt(pass.seen.time);
            window.from = std::max(window.from, site.times[pass.seen.report - 1]);
            window.to = std::min(window.to, site.times[pass.seen.report]);
            site.fronts.push_back({f, window});
            passages.push_back({pass.site, pass.seen.time, fronts[f].slowness * fronts[f].speed(), fronts[f].speed()});
        }
    for (SiteData& site : sites)
        std::sort(site.fronts.begin(), site.fronts.end(), [](auto const& a, auto const& b) { return a.second.from < b.second.from; });
    std::stable_sort(passages.begin(), passages.end(), [](Passage const& a, Passage const& b) { return a.time < b.time; });
}

/// The sites' tracks become the field's: the same genus at a like level is one pattern that stretches over all sites.
void Field::Data::joinTracks() {
    std::vector<SiteTrack> known;
    for (SiteData& site : sites) {
        auto const matches = matchedTracks(site.tracks, known);
        site.trackOf.assign(known.size(), std::nullopt);
        for (std::size_t i = 0; i < site.tracks.size(); ++i) {
            if (!matches[i]) known.push_back(site.tracks[i]);
            std::size_t const track = matches[i].value_or(known.size() - 1);
            site.trackOf.resize(known.size());
            site.trackOf[track] = i;
        }
    }
    for (SiteTrack const& track : known)
        tracks.push_back({track.genus, patternId(track.genus, ordinals[static_cast<std::size_t>(track.genus)]++), meanBase(track), {}, glm::dvec2{0.0}});
    for (SiteData& site : sites) {
        std::vector<Window> const windows = windowsOf(site);
        site.trackOf.resize(known.size());
        for (auto const& own : site.trackOf) {
            site.curves.emplace_back();
            if (!own) continue;
            SiteTrack const& track = site.tracks[*own];
            site.curves.back() = TrackCurves{coverCurve(site.tracks, *own, site.times, windows), steppedCurve(site.times, track.base, windows),
                                              steppedCurve(site.times, track.top, windows)};
        }
    }
}

/// A track that stands at the time of the change keeps the pattern of the layer it was: the nearest of its genus, each once.
void Field::Data::carryPatterns() {
    std::vector<Carry::CarriedLayer> left = carry->layers;
    for (std::size_t t = 0; t < tracks.size(); ++t) {
        std::optional<double> base;
        for (SiteData const& site : sites)
            if (site.curves[t] && site.curves[t]->cover.at(carry->time) > 0.0) base = site.curves[t]->base.at(carry->time);
        if (!base) continue;
        auto best = left.end();
        for (auto layer = left.begin(); layer != left.end(); ++layer)
            if (layer->genus == tracks[t].genus && (best == left.end() || std::abs(layer->base - *base) < std::abs(best->base - *base))) best = layer;
        if (best == left.end()) continue;
        tracks[t].pattern = best->pattern;
        tracks[t].atStart = -best->drift;  // findWinds adds the integral up to the change
        left.erase(best);
    }
}

/// Each track's wind at the middle of its layer at every report, then a curve through it: its integral is the drift.
void Field::Data::findWinds() {
    auto const times = allTimes();
    std::vector<double> const all = weights(0.0, 0.0);
    std::vector<SiteShare> const near = countingShares(all);
    std::vector<glm::dvec2> boundaryWinds;
    std::vector<std::vector<glm::dvec2>> winds(tracks.size());
    for (double const time : times) {
        OriginWind wind;
        for (SiteShare const& own : near) wind.sites.push_back({own.share, sites[own.site].elevation, profile(own.site, time)});
        boundaryWinds.push_back(wind.at(place.altitude_m + kBoundaryHeight));
        for (std::size_t t = 0; t < tracks.size(); ++t) winds[t].push_back(wind.at(trackMiddle(sites, all, t, time)));
    }
    boundary = {times, boundaryWinds};
    double const from = carry ? carry->time : start;
    boundaryAtStart = boundary.integralTo(from) - (carry ? carry->boundaryDrift : glm::dvec2{0.0});
    for (std::size_t t = 0; t < tracks.size(); ++t) {
        tracks[t].wind = {times, winds[t]};
        tracks[t].atStart += tracks[t].wind.integralTo(from);
    }
}

void Field::Data::listReports() {
    for (std::size_t i = 0; i < sites.size(); ++i) {
        reports.emplace_back();
        for (std::size_t k = 0; k < sites[i].reports.size(); ++k)
            reports[i].push_back({recording.sites[i].reports[k], sites[i].reports[k].filled});
    }
}

/// From recording, origin and place to all the rest.
void Field::Data::build() {
    for (Site const& site : recording.sites) sites.push_back(siteData(site, place));
    setApart(recording.sites, sites);
    findFronts();
    for (SiteData& site : sites) drawCurves(site);
    start = end = sites.front().times.front();
    for (SiteData const& site : sites) {
        start = std::min(start, site.times.front());
        end = std::max(end, site.times.back());
    }
    if (carry) {
        start = std::min(start, carry->start);
        ordinals = carry->ordinals;
    }
    joinTracks();
    if (carry) carryPatterns();
    findWinds();
    listReports();
}

Field fieldFrom(Recording recording, Origin origin, std::optional<PlaceWish> const& place) {
    auto data = std::make_shared<FieldAccess::Data>();
    data->place = placeOf(recording, place);
    data->origin = std::move(origin);
    data->recording = std::move(recording);
    data->build();
    return FieldAccess::field(std::move(data));
}
}  // namespace luftpost::weather
