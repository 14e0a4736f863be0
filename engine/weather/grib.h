// GRIB edition 2 of the weather models (GFS, ICON and others on a regular grid): bytes -> a recording. Model data.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "engine/weather/field.h"
#include "engine/weather/recording.h"

namespace luftpost::weather {
bool looksLikeGrib(std::string_view bytes);

/// A file has no single place: the first site is the wished place, bilinear between the grid's points, and the 3 x 3 points of the
/// first field's grid around it are sites of their own. Without a wish the point nearest to Basel, where a start without any
/// choice flies, or the grid's middle where that does not lie within; the recording's name says so.
/// One report for each time of which a field is valid: cloud by level and in all, cloud bases and tops, visibility, CAPE, freezing
/// level, precipitation, temperature, dew point, wind and gust near the ground, pressure, radiation, snow depth, and the pressure
/// levels. Means and sums of a step become rates of their own step also where the run adds up from its start; the mean cover of a
/// step, where the model gives no instant, becomes that of the time between two steps. Other fields are passed over.
/// Throws core::Error that names the message and its byte.
Recording parseGrib(std::string_view bytes, std::string const& file, std::optional<PlaceWish> const& place);
}  // namespace luftpost::weather
