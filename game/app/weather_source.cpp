#include "game/app/weather_source.h"

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
    if (common.time) return *common.time;
    core::UtcSeconds const usual = *core::parseUtc(weather::kDefaultTime);
    return field.covers(usual) ? usual : field.start();
}

weather::Field weatherField(CommonOptions const& common) { return weather::loadWeather(weatherSource(common), placeWish(common)); }
}  // namespace luftpost::app
