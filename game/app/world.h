// Land and weather of one session: the functions that everything else asks.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/environment.h"
#include "engine/terrain/land.h"
#include "engine/weather/air.h"
#include "engine/weather/field.h"
#include "engine/weather/noise_volume.h"

namespace luftpost::app {
/// Place and land stay for the whole session; the weather may be exchanged. Main thread; the land and the
/// fields may be asked from any thread.
class World {
public:
    /// `source` as --weather takes it (not empty). Throws core::Error where it cannot be loaded.
    /// `latest` tells the month of METARs; none: now.
    World(std::string const& source, core::Place const& place, unsigned seed, std::optional<core::UtcSeconds> latest = {});
    World(World const&) = delete;
    World& operator=(World const&) = delete;

    /// Loads a source so that `useWeather` can take it. Throws core::Error.
    void loadWeather(std::string const& source);
    /// From now on this loaded source is the weather.
    void useWeather(std::string const& source);

    std::string const& source() const { return source_; }
    terrain::Land const& land() const { return land_; }
    weather::Field const& field() const { return current_->field; }
    weather::Air const& air() const { return current_->air; }
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

    std::string source_;
    core::Place place_;
    std::optional<core::UtcSeconds> latest_;
    terrain::Land land_;
    core::GroundFunction ground_;
    weather::NoiseVolumes noise_;
    std::map<std::string, std::unique_ptr<Loaded>> loaded_;
    Loaded* current_ = nullptr;
};

}  // namespace luftpost::app
