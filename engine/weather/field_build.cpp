// From a recording to the curves of a Field.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/site_curves.h"

namespace luftpost::weather {
namespace {
constexpr double kNowhere = 1e9;           // m
constexpr double kBoundaryHeight = 300.0;  // m above ground: its wind carries the turbulence

/// Sites whose place nobody knows stand alone, far from everywhere: each answers for itself and blends into nothing else. Where
/// no place is known at all the first site is here.
void setApart(std::vector<Site> const& said, std::vector<SiteData>& sites) {
    bool const placed = std::any_of(said.begin(), said.end(), [](Site const& site) { return site.lat_deg.has_value(); });
    for (std::size_t i = placed ? 0 : 1; i < sites.size(); ++i)
        if (!said[i].lat_deg) sites[i].east = kNowhere * static_cast<double>(i + 1);
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
