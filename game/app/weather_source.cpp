#include "game/app/weather_source.h"

#include <fmt/format.h>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/platform/paths.h"
#include "game/app/live_weather.h"

namespace luftpost::app {
std::optional<weather::PlaceWish> placeWish(CommonOptions const& common) {
    if (!common.place) return std::nullopt;
    return weather::PlaceWish{common.place->lat_deg, common.place->lon_deg, common.place->altitude_m};
}

bool wantsLive(CommonOptions const& common) {
    return common.weather == kLiveSource || (common.weather.empty() && common.settings.weather.live);
}

std::string bundledSource() { return "recorded:" + platform::dataFile(weather::kDefaultRecording).string(); }

std::string weatherSource(CommonOptions const& common) {
    if (!common.weather.empty()) return common.weather;
    return wantsLive(common) ? kLiveSource : bundledSource();
}

FeedPlace feedPlace(CommonOptions const& common) {
    if (common.place) return {common.place->lat_deg, common.place->lon_deg};
    weather::Site const site = weather::readRecording(platform::dataFile(weather::kDefaultRecording).string()).sites.front();
    return {site.lat_deg.value_or(0.0), site.lon_deg.value_or(0.0)};
}

core::UtcSeconds feedTime(CommonOptions const& common) { return common.time.value_or(weather::contextOfNow().latest); }

weather::Origin originOf(WeatherInput const& input, weather::Recording const& recording) {
    return {input.mode, recording.name, recording.source, recording.licence, recording.sha256, input.fetched};
}

weather::Field fieldOf(WeatherInput const& input, std::optional<weather::PlaceWish> const& place) {
    weather::Recording recording = weather::parseRecording(input.recording, input.source);
    weather::Origin origin = originOf(input, recording);
    return weather::fieldFrom(std::move(recording), std::move(origin), place);
}

core::UtcSeconds startTime(CommonOptions const& common, weather::Field const& field) {
    using weather::SourceMode;
    SourceMode const mode = field.origin().mode;
    bool const preset = mode == SourceMode::Preset, live = isLive(mode);
    core::UtcSeconds const usual = live ? feedTime(common) : *core::parseUtc(weather::kDefaultTime);
    core::UtcSeconds const time = common.time.value_or(preset || live || field.covers(usual) ? usual : field.start());
    if (!preset && !field.covers(time))
        fmt::print("{}: the time {} lies outside the recording ({} to {}); its nearest end holds\n",
                   weatherSource(common), core::formatUtc(time), core::formatUtc(field.start()),
                   core::formatUtc(field.end()));
    return time;
}

weather::SourceContext sourceContext(core::UtcSeconds latest) {
    return {.latest = latest, .stationTable = platform::dataFile("assets/weather/stations.txt").string()};
}

namespace {
/// Asked for once.
weather::Field liveField(std::optional<weather::PlaceWish> const& place, CommonOptions const& common) {
    core::UtcSeconds const now = feedTime(common);
    Validators none;
    std::atomic<bool> const goOn = false;
    Fetched const fetched = fetchWeather(common.settings.weather, feedPlace(common), now, none, goOn);
    if (!fetched.news) throw core::Error{kLiveSource, "", fetched.error};
    core::UtcSeconds const given = fetched.news->givenAt(now);
    return fieldOf(liveInput(*fetched.news, given, isStale(given, now, common.settings.weather)), place);
}
}  // namespace

weather::Field loadField(std::string const& source, std::optional<weather::PlaceWish> const& place, CommonOptions const& common) {
    return source == kLiveSource ? liveField(place, common) : weather::loadWeather(source, place, sourceContext(feedTime(common)));
}

weather::Field weatherField(CommonOptions const& common) { return loadField(weatherSource(common), placeWish(common), common); }

weather::NoiseVolumes noiseVolumes(int seed) {
    if (seed != static_cast<int>(weather::kNoiseSeed)) return weather::makeNoise(static_cast<unsigned>(seed), toolWorkers());
    return weather::loadNoise(platform::dataFile("generated/noise_shape.bin").parent_path());
}
}  // namespace luftpost::app
