// From a recording to the curves of a Field.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/field_data.h"

namespace luftpost::weather {
namespace {
constexpr double kMeanHours = 1.5;         // h to either side: the wind that the free air above goes by
constexpr double kBoundaryHeight = 300.0;  // m above ground: its wind carries the turbulence

std::vector<double> column(std::vector<FullReport> const& reports, double FullReport::*member) {
    std::vector<double> values;
    for (FullReport const& report : reports) values.push_back(report.*member);
    return values;
}

/// Sums over the reports' intervals. A hole between two of them goes over evenly from one rate to the other; an interval that
/// reaches back over the report before counts from there on.
SumCurve rateCurve(std::vector<FullReport> const& reports) {
    std::vector<double> edges{reports.front().time - reports.front().interval}, rates{reports.front().rate};
    edges.push_back(reports.front().time);
    for (std::size_t k = 1; k < reports.size(); ++k) {
        double const gap = reports[k].time - reports[k - 1].time - reports[k].interval;
        if (gap > 1.0) {
            edges.push_back(reports[k - 1].time + gap);
            rates.push_back(0.5 * (reports[k - 1].rate + reports[k].rate));
        }
        edges.push_back(reports[k].time);
        rates.push_back(reports[k].rate);
    }
    return {edges, rates};
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

/// Altitudes at which any report has a wind, thinned to what a profile can hold.
std::vector<double> levelAltitudes(std::vector<FullReport> const& reports, double lowest) {
    std::vector<double> altitudes;
    for (FullReport const& report : reports)
        for (ReportedLevel const& level : report.levels)
            if (level.speed_mps && level.from_deg && level.altitude_m > lowest) altitudes.push_back(level.altitude_m);
    std::sort(altitudes.begin(), altitudes.end());
    altitudes.erase(std::unique(altitudes.begin(), altitudes.end(), [](double a, double b) { return b - a < 1.0; }), altitudes.end());
    std::size_t const most = Profile::kMaxLevels;
    if (altitudes.size() <= most) return altitudes;
    std::vector<double> thinned;
    for (std::size_t i = 0; i < most; ++i) thinned.push_back(altitudes[i * (altitudes.size() - 1) / (most - 1)]);
    return thinned;
}

std::vector<LevelCurve> levelCurves(std::vector<FullReport> const& reports, double elevation) {
    std::vector<LevelCurve> curves;
    for (double const altitude : levelAltitudes(reports, elevation + 15.0)) {
        std::vector<double> times;
        std::vector<glm::dvec2> winds;
        for (FullReport const& report : reports)
            if (auto const wind = levelWind(report, altitude)) {
                times.push_back(report.time);
                winds.push_back(*wind);
            }
        if (!times.empty()) curves.push_back({altitude, {times, winds}});
    }
    return curves;
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
    auto const curve = [&](double FullReport::*member) { return Curve{data.times, column(data.reports, member)}; };
    data.temperature = curve(&FullReport::temperature);
    data.dewPoint = curve(&FullReport::dewPoint);
    data.pressureSea = curve(&FullReport::pressureSea);
    data.cape = curve(&FullReport::cape);
    data.freezingLevel = curve(&FullReport::freezingLevel);
    data.snowDepth = curve(&FullReport::snowDepth);
    std::vector<double> visibility = column(data.reports, &FullReport::visibility);
    for (double& value : visibility) value = core::log(value);
    data.logVisibility = Curve{data.times, visibility};
    std::vector<glm::dvec2> winds;
    for (FullReport const& report : data.reports) winds.push_back(report.wind);
    data.wind = {data.times, winds};
    data.windMean = runningMean(data.wind, data.times);
    data.gust = MaximumCurve{data.times, column(data.reports, &FullReport::gust)};
    data.rate = rateCurve(data.reports);
    data.levels = levelCurves(data.reports, data.elevation);
    data.tracks = siteTracks(data.reports);
    return data;
}

unsigned patternId(Genus genus, unsigned ordinal) {
    unsigned x = static_cast<unsigned>(genus) * 0x9E3779B9u + ordinal * 0x85EBCA6Bu + 0x27D4EB2Fu;
    x = (x ^ (x >> 15)) * 0x2C1B3C6Du;
    x = (x ^ (x >> 12)) * 0x297A2D39u;
    return x ^ (x >> 15);
}

/// The wish, else the first site; without an altitude the nearest site's elevation.
core::Place placeOf(Recording const& recording, std::optional<PlaceWish> const& wish) {
    Site const& first = recording.sites.front();
    core::Place place{first.lat_deg.value_or(0.0), first.lon_deg.value_or(0.0), first.elevation_m.value_or(0.0)};
    if (!wish) return place;
    place.lat_deg = wish->lat_deg;
    place.lon_deg = wish->lon_deg;
    double nearest = 1e300;
    for (Site const& site : recording.sites) {
        double const north = site.lat_deg.value_or(place.lat_deg) - place.lat_deg;
        double const east = turn(site.lon_deg.value_or(place.lon_deg) - place.lon_deg) * core::cos(core::radians(place.lat_deg));
        if (north * north + east * east >= nearest) continue;
        nearest = north * north + east * east;
        place.altitude_m = site.elevation_m.value_or(0.0);
    }
    place.altitude_m = wish->altitude_m.value_or(place.altitude_m);
    return place;
}
}  // namespace

glm::dvec2 Field::Data::windAtOrigin(double altitude, double time) const {
    glm::dvec2 wind{0.0};
    for (std::size_t i = 0; i < sites.size(); ++i)
        wind += weight(i, 0.0, 0.0) * weather::windAt(profile(i, time), altitude, sites[i].elevation);
    return wind;
}

std::vector<double> Field::Data::allTimes() const {
    std::vector<double> times;
    for (SiteData const& site : sites) times.insert(times.end(), site.times.begin(), site.times.end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
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
        tracks.push_back({track.genus, patternId(track.genus, ordinals[static_cast<std::size_t>(track.genus)]++), {}, glm::dvec2{0.0}});
    for (SiteData& site : sites) {
        site.trackOf.resize(known.size());
        for (auto const& own : site.trackOf) {
            site.curves.emplace_back();
            if (!own) continue;
            SiteTrack const& track = site.tracks[*own];
            site.curves.back() = TrackCurves{coverCurve(site.tracks, *own, site.times), {site.times, track.base}, {site.times, track.top}};
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
    std::vector<glm::dvec2> boundaryWinds;
    for (double const time : times) boundaryWinds.push_back(windAtOrigin(place.altitude_m + kBoundaryHeight, time));
    boundary = {times, boundaryWinds};
    double const from = carry ? carry->time : start;
    boundaryAtStart = boundary.integralTo(from) - (carry ? carry->boundaryDrift : glm::dvec2{0.0});
    for (std::size_t t = 0; t < tracks.size(); ++t) {
        std::vector<glm::dvec2> winds;
        for (double const time : times) {
            double middle = 0.0, sum = 0.0;
            for (std::size_t i = 0; i < sites.size(); ++i) {
                if (!sites[i].curves[t]) continue;
                double const share = weight(i, 0.0, 0.0);
                middle += share * 0.5 * (sites[i].curves[t]->base.at(time) + sites[i].curves[t]->top.at(time));
                sum += share;
            }
            winds.push_back(windAtOrigin(middle / sum, time));
        }
        tracks[t].wind = {times, winds};
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
