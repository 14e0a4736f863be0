// Cloud layers over time. A layer of one report is the same as a layer of the next when genus and level agree; a track is such
// a layer's life. A layer without a partner changes its cover, never its base.
#pragma once
#include <optional>
#include <vector>

#include "engine/weather/curve.h"
#include "engine/weather/fill.h"
#include "engine/weather/fronts.h"

namespace luftpost::weather {
/// One layer's life over one site: cover at every report (0 where it is absent), base and top held where it is absent.
struct SiteTrack {
    Genus genus = Genus::Cu;
    std::vector<double> cover, base, top;  // one a report
    std::vector<int> layer;                // which of the report's layers it is, -1 where it is absent
};

/// The tracks of a site's reports, in the order of their first appearance. A track that ended is taken up again by the next
/// layer of its genus near its level, so that there are few.
std::vector<SiteTrack> siteTracks(std::vector<FullReport> const& reports);

/// The cover of one of a site's tracks over time. Where a layer goes while another of its level comes, the two change places
/// so that the sky between them stays as covered as both ends say, overlap by chance reckoned with. Where a front passes all
/// changes within its window.
Curve coverCurve(std::vector<SiteTrack> const& tracks, std::size_t which, std::vector<double> const& times, std::vector<Window> const& windows);

/// Its base in the mean, weighted by cover. m above sea level.
double meanBase(SiteTrack const& track);

/// For each of `tracks`, which of the `known` ones it continues at another site: the nearest in mean base of the same genus,
/// each at most once; none: a new one.
std::vector<std::optional<std::size_t>> matchedTracks(std::vector<SiteTrack> const& tracks, std::vector<SiteTrack> const& known);
}  // namespace luftpost::weather
