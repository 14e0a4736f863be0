// The common options --weather, --place and --time as the commands use them.
#pragma once
#include <string>

#include "engine/weather/field.h"
#include "engine/weather/noise_volume.h"
#include "engine/weather/source.h"
#include "game/app/commands.h"
#include "game/app/inputs.h"
#include "game/app/weather_provider.h"

namespace luftpost::app {
/// --place, if it was given.
std::optional<weather::PlaceWish> placeWish(CommonOptions const& common);
/// True for --weather live, and where the settings say so and --weather names nothing else.
bool wantsLive(CommonOptions const& common);
/// Live or stale: from a feed.
constexpr bool isLive(weather::SourceMode mode) { return mode == weather::SourceMode::Live || mode == weather::SourceMode::Stale; }
/// The bundled recording, as --weather takes it.
std::string bundledSource();
/// --weather, else what the settings say, else the bundled recording.
std::string weatherSource(CommonOptions const& common);
/// Where live weather is asked for without an aircraft: --place, else the bundled recording's first site.
FeedPlace feedPlace(CommonOptions const& common);
/// --time, else now.
core::UtcSeconds feedTime(CommonOptions const& common);
/// Of weather that carries its recording, once that is read.
weather::Origin originOf(WeatherInput const& input, weather::Recording const& recording);
/// The field of weather that carries its recording. Throws core::Error.
weather::Field fieldOf(WeatherInput const& input, std::optional<weather::PlaceWish> const& place);
/// --time, else for live weather now, else the default hour where the weather has it, else the recording's first report. A time outside
/// the recording is said so on standard output.
core::UtcSeconds startTime(CommonOptions const& common, weather::Field const& field);
/// The field of a source at a place; `live` is asked for once, within the time-out of the settings. Throws core::Error.
weather::Field loadField(std::string const& source, std::optional<weather::PlaceWish> const& place, CommonOptions const& common);
/// What a source cannot say of itself: reports up to `latest`; the product's table of stations.
weather::SourceContext sourceContext(core::UtcSeconds latest);
/// The field of the common options. Throws core::Error.
weather::Field weatherField(CommonOptions const& common);
/// The volumes of a seed: of the usual one what the build made, of another made now. Throws core::Error where a file is missing or
/// broken.
weather::NoiseVolumes noiseVolumes(int seed = static_cast<int>(weather::kNoiseSeed));
}  // namespace luftpost::app
