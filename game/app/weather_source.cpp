#include "game/app/weather_source.h"

#include <fmt/format.h>

#include "engine/core/time.h"
#include "engine/platform/paths.h"

namespace luftpost::app {
std::optional<weather::PlaceWish> placeWish(CommonOptions const& common) {
    if (!common.place) return std::nullopt;
    return weather::PlaceWish{common.place->lat_deg, common.place->lon_deg, common.place->altitude_m};
}

std::string weatherSource(CommonOptions const& common) {
    if (!common.weather.empty()) return common.weather;
    return "recorded:" + platform::dataFile(weather::kDefaultRecording).string();
}

core::UtcSeconds startTime(CommonOptions const& common, weather::Field const& field) {
    core::UtcSeconds const usual = *core::parseUtc(weather::kDefaultTime);
    bool const preset = field.origin().mode == weather::SourceMode::Preset;
    core::UtcSeconds const time = common.time.value_or(preset || field.covers(usual) ? usual : field.start());
    if (!preset && !field.covers(time))
        fmt::print("{}: the time {} lies outside the recording ({} to {}); its nearest end holds\n",
                   weatherSource(common), core::formatUtc(time), core::formatUtc(field.start()),
                   core::formatUtc(field.end()));
    return time;
}

weather::SourceContext sourceContext(CommonOptions const& common) {
    return {.latest = common.time.value_or(weather::contextOfNow().latest),
            .stationTable = platform::dataFile("assets/weather/stations.txt").string()};
}

weather::Field weatherField(CommonOptions const& common) {
    return weather::loadWeather(weatherSource(common), placeWish(common), sourceContext(common));
}

weather::NoiseVolumes noiseVolumes() {
    return weather::loadNoise(platform::dataFile("generated/noise_shape.bin").parent_path());
}
}  // namespace luftpost::app
