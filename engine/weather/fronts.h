// Fronts: found in the reports of a site, joined to lines over several, and what a line does to time: a site's reports pass over
// a place as much earlier or later as the line does. Private to the field's own files.
#pragma once
#include <vector>

#include "engine/weather/fill.h"

namespace luftpost::weather {
/// The part of an interval between two reports in which all that a front changes goes over.
struct Window {
    double from = 0.0, to = 0.0;  // s
};

/// The part of from..to in which the weather changes: a front's window that lies within, else all of it.
Window windowWithin(std::vector<Window> const& windows, double from, double to);

/// A front as one site's reports show it.
struct FrontSeen {
    std::size_t report = 0;      // the first one behind it
    double time = 0.0;           // of its passage
    glm::dvec2 windBehind{0.0};  // m/s, 10 m above ground, where the air goes to
};

/// A wind shift of 30 degrees or more with a fall of 3 K or more or a rise of 1 hPa or more, within 30 minutes or between two
/// hourly reports; only of what was said, and not into calm. Of several intervals in a row the one with the heaviest gust, else rain, else
/// turn of the wind holds the passage, in its middle.
std::vector<FrontSeen> frontsOver(std::vector<FullReport> const& reports);

/// One site's part in a front. East and north of the site, m.
struct FrontPass {
    std::size_t site = 0;
    double east = 0.0, north = 0.0;
    FrontSeen seen;
    double late = 0.0;  // s, behind the straight line
};

/// A line that moves on. Straight, but bent so that it passes every site when that saw it.
struct Front {
    std::vector<FrontPass> passes;  // in time, at least one
    glm::dvec2 slowness{0.0};       // s/m, east and north, in the direction in which the line moves
    double origin = 0.0;            // s, when the straight line passes the world's origin

    double passageAt(double east, double north) const;  // s
    double speed() const;                               // m/s
    double width() const;                               // m, from 10 to 90 % of the change: 3 to 6 km, about 450 s
    /// When all of the change begins and ends for a passage at `time`: 0 to 100 %.
    Window windowAt(double time) const;
};

/// What each site saw, joined. From three sites on that do not stand in a row the line's motion is the least squares' through their times;
/// else it lies square to the wind behind it and moves with that wind, at least 5 m/s.
std::vector<Front> joinedFronts(std::vector<FrontPass> passes);

/// The time at which a site's reports are to be read for a place where a front passes `late` seconds after it passed the site:
/// the same time far from the front, `late` earlier around it. `fronts`: for each front over the site its time there, and `late`.
struct PassedBy {
    double time, late;  // s
};
double readingTime(double time, std::vector<PassedBy> const& fronts);
/// Seconds around a front's passage over a site beyond which readingTime changes nothing, wherever the place.
inline constexpr double kFrontReach = 4.0 * 3600.0 + 1800.0 + 8.0 * 3600.0;
}  // namespace luftpost::weather
