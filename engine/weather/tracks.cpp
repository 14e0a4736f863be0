#include "engine/weather/tracks.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
/// How far bases may differ for two layers to be one: m.
double reachOf(Genus genus) {
    switch (levelOf(genus)) {
        case Level::Low: return 700.0;
        case Level::Mid: return 1500.0;
        default: return 3000.0;
    }
}

/// The track among those not yet `taken` that the layer of report k continues. One that was absent for a single report is no
/// candidate: its base would have to move while one still sees it.
std::optional<std::size_t> continued(FullLayer const& layer, std::size_t k, std::vector<SiteTrack> const& tracks,
                                     std::vector<std::size_t> const& lastSeen, std::vector<bool> const& taken) {
    std::optional<std::size_t> best;
    double nearest = reachOf(layer.genus);
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        double const distance = std::abs(tracks[i].base[lastSeen[i]] - layer.base);
        if (tracks[i].genus != layer.genus || taken[i] || k - lastSeen[i] == 2 || distance > nearest) continue;
        nearest = distance;
        best = i;
    }
    return best;
}

/// Base and top where the layer is absent: those of its next presence at the report just before it, else of its last one.
void holdWhereAbsent(SiteTrack& track) {
    auto const first = std::find_if(track.layer.begin(), track.layer.end(), [](int layer) { return layer >= 0; }) - track.layer.begin();
    auto held = static_cast<std::size_t>(first);
    for (std::size_t i = 0; i < track.layer.size(); ++i) {
        bool const next = i + 1 < track.layer.size() && track.layer[i + 1] >= 0;
        if (track.layer[i] >= 0) held = i;
        std::size_t const from = track.layer[i] < 0 && next ? i + 1 : held;
        track.base[i] = track.base[from];
        track.top[i] = track.top[from];
    }
}
/// Between reports k and k + 1: comes from nothing (1), goes to nothing (-1), or neither.
int turnOf(SiteTrack const& track, std::size_t k) {
    bool const before = track.cover[k] > 0.0, after = track.cover[k + 1] > 0.0;
    return before == after ? 0 : (after ? 1 : -1);
}

bool changesPlaces(std::vector<SiteTrack> const& tracks, std::size_t which, std::size_t k) {
    int const own = turnOf(tracks[which], k);
    if (own == 0) return false;
    return std::any_of(tracks.begin(), tracks.end(), [&](SiteTrack const& other) {
        return turnOf(other, k) == -own && levelOf(other.genus) == levelOf(tracks[which].genus);
    });
}

/// The cover of a layer of which a share is there, so that layers of shares that sum to 1 leave the same gaps as one whole.
double sharedCover(double cover, double share) {
    constexpr double kNearlyClosed = 0.97;
    double const gap = 1.0 - std::min(cover, kNearlyClosed);
    return (1.0 - core::pow(gap, share)) * cover / std::min(cover, kNearlyClosed);
}
}  // namespace

double meanBase(SiteTrack const& track) {
    double sum = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < track.base.size(); ++i) {
        sum += track.cover[i] * track.base[i];
        weight += track.cover[i];
    }
    return weight > 0.0 ? sum / weight : track.base.front();
}

Curve coverCurve(std::vector<SiteTrack> const& tracks, std::size_t which, std::vector<double> const& times, std::vector<Window> const& windows) {
    SiteTrack const& track = tracks[which];
    std::vector<double> knots, covers;
    for (std::size_t k = 0; k < times.size(); ++k) {
        knots.push_back(times[k]);
        covers.push_back(track.cover[k]);
        if (k + 1 == times.size()) break;
        Window const span = windowWithin(windows, times[k], times[k + 1]);
        auto const add = [&](double time, double cover) {
            if (time - knots.back() < 1.0 || times[k + 1] - time < 1.0) return;
            knots.push_back(time);
            covers.push_back(cover);
        };
        add(span.from, track.cover[k]);
        bool const comes = turnOf(track, k) > 0, exchange = changesPlaces(tracks, which, k);
        for (double const u : {0.25, 0.5, 0.75})
            if (exchange) add(span.from + u * (span.to - span.from), sharedCover(track.cover[comes ? k + 1 : k], comes ? u : 1.0 - u));
        add(span.to, track.cover[k + 1]);
    }
    return {knots, covers};
}

std::vector<SiteTrack> siteTracks(std::vector<FullReport> const& reports) {
    std::vector<SiteTrack> tracks;
    std::vector<std::size_t> lastSeen;
    std::size_t const n = reports.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::vector<bool> taken(tracks.size(), false);
        for (std::size_t l = 0; l < reports[k].layers.size(); ++l) {
            FullLayer const& layer = reports[k].layers[l];
            auto i = continued(layer, k, tracks, lastSeen, taken);
            if (!i) {
                i = tracks.size();
                tracks.push_back({layer.genus, std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), std::vector<int>(n, -1)});
                lastSeen.push_back(k);
                taken.push_back(false);
            }
            taken[*i] = true;
            lastSeen[*i] = k;
            tracks[*i].cover[k] = layer.cover;
            tracks[*i].base[k] = layer.base;
            tracks[*i].top[k] = layer.top;
            tracks[*i].layer[k] = static_cast<int>(l);
        }
    }
    for (SiteTrack& track : tracks) holdWhereAbsent(track);
    return tracks;
}

std::vector<std::optional<std::size_t>> matchedTracks(std::vector<SiteTrack> const& tracks, std::vector<SiteTrack> const& known) {
    std::vector<bool> taken(known.size(), false);
    std::vector<std::optional<std::size_t>> matches;
    for (SiteTrack const& track : tracks) {
        std::optional<std::size_t> best;
        double nearest = reachOf(track.genus);
        for (std::size_t i = 0; i < known.size(); ++i) {
            double const distance = std::abs(meanBase(track) - meanBase(known[i]));
            if (known[i].genus != track.genus || taken[i] || distance > nearest) continue;
            nearest = distance;
            best = i;
        }
        if (best) taken[*best] = true;
        matches.push_back(best);
    }
    return matches;
}
}  // namespace luftpost::weather
