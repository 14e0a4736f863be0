// The common options --weather, --place and --time as the commands use them.
#pragma once
#include <string>

#include "engine/weather/field.h"
#include "engine/weather/noise_volume.h"
#include "engine/weather/source.h"
#include "game/app/commands.h"

namespace luftpost::app {
/// --place, if it was given.
std::optional<weather::PlaceWish> placeWish(CommonOptions const& common);
/// --weather, else the bundled recording.
std::string weatherSource(CommonOptions const& common);
/// --time, else the default hour where the weather has it, else the recording's first report. A time outside the
/// recording is said so on standard output.
core::UtcSeconds startTime(CommonOptions const& common, weather::Field const& field);
/// What a source cannot say of itself: --time, else now; the product's table of stations.
weather::SourceContext sourceContext(CommonOptions const& common);
/// The field of the common options. Throws core::Error.
weather::Field weatherField(CommonOptions const& common);
/// What the build made. Throws core::Error where a file is missing or broken.
weather::NoiseVolumes noiseVolumes();
}  // namespace luftpost::app
