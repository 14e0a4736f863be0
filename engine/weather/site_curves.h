// One site's reports as curves over time. Private to the field's own files.
#pragma once
#include "engine/weather/field_data.h"

namespace luftpost::weather {
/// Where a site stands in the world of a place, m; at the place where nobody says.
glm::dvec2 eastNorthOf(Site const& site, core::Place const& place);

/// The reports filled, the layers as tracks, what the site knows and where it stands in the world of a place; no curves yet: the fronts
/// that shape them are found from the reports of all sites.
SiteData siteData(Site const& site, core::Place const& place);

/// All that changes over the site with time, but for its tracks.
void drawCurves(SiteData& data);

/// When fronts change the weather over the site.
std::vector<Window> windowsOf(SiteData const& data);

/// A curve through the values; where a front passes, what was before holds up to its window and what is behind it holds after.
Curve steppedCurve(std::vector<double> const& times, std::vector<double> const& values, std::vector<Window> const& windows);

/// A difference of longitudes the short way round. Degrees.
double turn(double degrees);
}  // namespace luftpost::weather
