// From a pattern's value to its rank, through the distribution that assets/make/rank_table.cpp measured.
#pragma once
#include "engine/weather/weather.h"

namespace luftpost::weather {
/// The share of the plane where the genus' pattern is higher than `value`: 0 where cloud comes first, 1 where last.
float rankOf(Genus genus, bool coarse, float value);
}  // namespace luftpost::weather
