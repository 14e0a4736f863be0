#include "game/app/world.h"

#include <chrono>
#include <utility>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/weather/source.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
namespace {
weather::PlaceWish wishFor(core::Place const& place) { return {place.lat_deg, place.lon_deg, place.altitude_m}; }

/// The field that takes over.
weather::Field nextFieldOf(WeatherInput const& input, weather::Field const& before) {
    weather::Recording recording = weather::parseRecording(input.recording, input.source);
    weather::Origin origin = originOf(input, recording);
    return weather::nextField(before, std::move(recording), std::move(origin), input.from, input.seconds);
}
}  // namespace

World::World(WeatherInput const& weather, core::Place const& place, unsigned seed, std::optional<core::UtcSeconds> latest)
    : place_{place}, latest_{latest}, land_{seed, place.altitude_m}, ground_{[this](double east, double north) {
          return land_.ground(east, north);
      }},
      noise_{noiseVolumes()} {
    if (weather.recording.empty()) loadWeather(weather.source);
    use(weather);
}

void World::loadWeather(std::string const& source) {
    if (loaded_.contains(source)) return;
    weather::SourceContext const context = sourceContext(latest_.value_or(weather::contextOfNow().latest));
    loaded_[source] = std::make_shared<Loaded>(weather::loadWeather(source, wishFor(place_), context), ground_, land_.seed(), noise_);
}

void World::forgetUnused() {
    std::erase_if(loaded_, [this](auto const& entry) { return entry.second != current_; });
}

void World::use(WeatherInput const& input) {
    if (input.recording.empty()) {
        auto const found = loaded_.find(input.source);
        CHECK(found != loaded_.end(), "weather {} was not loaded", input.source);
        return take(found->second, input.source);
    }
    auto ready = std::exchange(ready_, std::nullopt);
    bool const fits = ready && ready->weather && ready->before == current_ && ready->input == input;
    take(fits ? std::move(ready->weather) : made(input, current_), input.source);
}

void World::take(Weather weather, std::string source) {
    previous_ = std::exchange(current_, std::move(weather));
    source_ = std::move(source);
}

World::Weather World::made(WeatherInput const& input, Weather const& before) const {
    bool const over = before && input.seconds > 0.0;
    return std::make_shared<Loaded>(over ? nextFieldOf(input, before->field) : fieldOf(input, wishFor(place_)), ground_, land_.seed(), noise_);
}

World::Made World::tried(WeatherInput const& input, Weather const& before) const {
    try {
        return {input, before, made(input, before), {}};
    } catch (core::Error const& error) {
        return {input, before, nullptr, error.what()};
    }
}

void World::offer(WeatherInput input) { waiting_ = std::move(input); }

std::optional<World::Offered> World::takeOffered(core::UtcSeconds now) {
    std::optional<Offered> offered;
    if (making_.valid() && making_.wait_for(std::chrono::seconds{0}) == std::future_status::ready) {
        ready_ = making_.get();
        offered = Offered{ready_->input, ready_->error};
    }
    if (offered || making_.valid() || !waiting_) return offered;  // what comes next goes over from this one: in the next frame
    WeatherInput input = *std::exchange(waiting_, std::nullopt);
    input.from = now;
    making_ = std::async(std::launch::async, [this, input = std::move(input), before = current_] { return tried(input, before); });
    return offered;
}
}  // namespace luftpost::app
