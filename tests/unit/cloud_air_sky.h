// What clouds and heat do to the air of a preset over flat land, without its gusts.
#pragma once
#include "engine/weather/cloud_air.h"
#include "engine/weather/source.h"

namespace luftpost::tests {
inline constexpr double kFlatGround = 316.0;  // m

struct CloudAirSky {
    weather::Field field;
    core::UtcSeconds time;
    weather::Ranks ranks;
    weather::Relief relief;
    weather::Layer dry;
    weather::CloudsNow clouds;

    explicit CloudAirSky(std::string const& preset, core::UtcSeconds when, core::Surface surface = core::Surface::grass)
        : field{weather::loadWeather(preset)}, time{when}, ranks{patterns(), 1}, relief{[surface](double, double) {
              return core::GroundSample{kFlatGround, {0.0, 1.0, 0.0}, surface};
          }},
          dry{weather::dryLayer(field.boundaryDrift(when), (when - field.start()) / 3600.0)},
          clouds{weather::cloudsOf(field.at(0.0, 0.0, when), 1, {}, false, weather::sunHeating(field.place(), when))} {}

    weather::CloudEffect at(double east, double north, double height, double temperature = 285.0) const {
        weather::AirPoint p;
        p.positionWorld = {east, kFlatGround + height, -north};
        p.east = east;
        p.north = north;
        p.altitude = kFlatGround + height;
        p.ground = kFlatGround;
        p.height = height;
        p.temperature = temperature;
        return weather::cloudEffect(clouds, p, {ranks, relief, dry, nullptr, 1.0});
    }
    double lift(double east, double north, double height) const { return at(east, north, height).lift; }
    double strongest(double height) const {
        double most = 0.0;
        for (int i = 0; i < 1500; ++i) most = std::max(most, lift((i % 50) * 431.0, (i / 50) * 557.0, height));
        return most;
    }

private:
    std::vector<unsigned> patterns() const {
        std::vector<unsigned> all = field.patterns();
        all.push_back(weather::kDryPattern);
        return all;
    }
};
}  // namespace luftpost::tests
