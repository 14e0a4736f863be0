#include "game/app/world.h"

#include "engine/core/check.h"
#include "engine/weather/source.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
World::World(std::string const& source, core::Place const& place, unsigned seed, std::optional<core::UtcSeconds> latest)
    : place_{place}, latest_{latest}, land_{seed, place.altitude_m}, ground_{[this](double east, double north) {
          return land_.ground(east, north);
      }},
      noise_{noiseVolumes()} {
    loadWeather(source);
    useWeather(source);
}

void World::loadWeather(std::string const& source) {
    if (loaded_.contains(source)) return;
    weather::PlaceWish const here{place_.lat_deg, place_.lon_deg, place_.altitude_m};
    weather::SourceContext const context = sourceContextAt(latest_.value_or(weather::contextOfNow().latest));
    loaded_[source] = std::make_unique<Loaded>(weather::loadWeather(source, here, context), ground_, land_.seed(), noise_);
}

void World::useWeather(std::string const& source) {
    auto const found = loaded_.find(source);
    CHECK(found != loaded_.end(), "weather {} was not loaded", source);
    source_ = source;
    current_ = found->second.get();
}
}  // namespace luftpost::app
