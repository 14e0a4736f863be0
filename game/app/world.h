// Land and weather of one session: the functions that everything else asks.
#pragma once
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/environment.h"
#include "engine/terrain/land.h"
#include "engine/weather/air.h"
#include "engine/weather/field.h"
#include "engine/weather/noise_volume.h"
#include "game/app/inputs.h"

namespace luftpost::app {
/// Place and land stay for the whole session; the weather may be exchanged. Main thread; the land and the
/// fields may be asked from any thread.
class World {
    struct Loaded;

public:
    /// `weather` as a flight begins: its source is not empty; a recording that it carries is the weather at once.
    /// `latest` tells the month of METARs; none: now. Throws core::Error where it cannot be loaded.
    World(WeatherInput const& weather, core::Place const& place, unsigned seed, std::optional<core::UtcSeconds> latest = {});
    World(World const&) = delete;
    World& operator=(World const&) = delete;

    /// Loads a source so that `use` can take it by its name. Throws core::Error.
    void loadWeather(std::string const& source);
    /// Loaded sources that are not in use go.
    void forgetUnused();

    /// From now on this is the weather: a loaded source, or the field that goes over to the recording from the weather of now.
    /// Takes what `offer` has made of the same input, else makes it here. Throws core::Error where the recording carries none.
    void use(WeatherInput const& input);

    /// The weather of now, to be taken back later, by this world or by another of the same place and land that lives no longer than this one.
    struct Held {
        std::shared_ptr<Loaded const> weather;
        std::string source;
    };
    Held held() const { return {current_, source_}; }
    void takeBack(Held const& held) { take(held.weather, held.source); }

    /// An input with a recording whose field is to be made beside the frame, on a thread of its own. One is made at a time;
    /// of those that wait only the last counts.
    void offer(WeatherInput input);
    struct Offered {
        WeatherInput input;  // may be used now without waiting
        std::string error;   // or why it may not
    };
    /// Once a frame: what is made, once. `now` is the time from which the next one to be made will go over.
    std::optional<Offered> takeOffered(core::UtcSeconds now);

    std::string const& source() const { return source_; }
    terrain::Land const& land() const { return land_; }
    weather::Field const& field() const;
    weather::Air const& air() const;
    core::Place place() const { return place_; }
    core::GroundFunction const& ground() const { return ground_; }

private:
    struct Loaded {
        weather::Field field;
        weather::Air air;
        Loaded(weather::Field loaded, core::GroundFunction const& ground, unsigned seed,
               weather::NoiseVolumes const& noise)
            : field{std::move(loaded)}, air{field, ground, seed, &noise} {}
    };
    using Weather = std::shared_ptr<Loaded const>;
    struct Made {
        WeatherInput input;
        Weather before, weather;  // weather: none where it failed
        std::string error;
    };

    Weather made(WeatherInput const& input, Weather const& before) const;
    Made tried(WeatherInput const& input, Weather const& before) const;
    void take(Weather weather, std::string source);

    std::string source_;
    core::Place place_;
    std::optional<core::UtcSeconds> latest_;
    terrain::Land land_;
    core::GroundFunction ground_;
    weather::NoiseVolumes noise_;
    std::map<std::string, Weather> loaded_;
    Weather current_;
    Weather previous_;  // whoever still asks it in this frame may
    std::optional<WeatherInput> waiting_;
    std::optional<Made> ready_;
    std::future<Made> making_;  // the last member: it is waited for before anything else goes
};

inline weather::Field const& World::field() const { return current_->field; }
inline weather::Air const& World::air() const { return current_->air; }
}  // namespace luftpost::app
