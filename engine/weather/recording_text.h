// A recording as text in our own format: what is read back is the same weather.
#pragma once
#include <string>

#include "engine/weather/recording.h"

namespace luftpost::weather {
/// JSON, "luftpost-weather-1"; holds what was reported and nothing else.
std::string recordingText(Recording const& recording);
}  // namespace luftpost::weather
