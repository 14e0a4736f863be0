// A field over a site as a report that leaves nothing open: what one weather hands to the next, or to a file.
#pragma once
#include "engine/weather/field.h"

namespace luftpost::weather {
/// Surface, layers, and the wind at heights so close that a straight line between two of them is the wind between. `interval`: s, of the
/// rate and the gust. Any thread.
Report wholeReport(Field const& field, Site const& site, core::UtcSeconds time, double interval);
}  // namespace luftpost::weather
