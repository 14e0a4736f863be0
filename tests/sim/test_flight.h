// A flight to measure: the default airframe, the standard atmosphere handed in as air, flat land at sea
// level.
#pragma once
#include <fmt/format.h>
#include <cmath>

#include <functional>
#include <string>

#include "engine/core/environment.h"
#include "engine/core/frames.h"
#include "engine/flight/aircraft.h"

namespace luftpost::flight {
/// ISA (ISO 2533) up to 11 km, from its defining constants.
inline core::AirSample isaAir(double altitude) {
    core::AirSample air;
    air.temperature = 288.15 - 0.0065 * altitude;
    double const exponent = core::kGravity / (287.05287 * 0.0065);
    air.pressure = 101325.0 * std::pow(air.temperature / 288.15, exponent);
    air.density = air.pressure / (287.05287 * air.temperature);
    return air;
}

class TestFlight {
public:
    explicit TestFlight(double payload = 240.0, double fuel = 100.0,
                        std::string const& airframe = "mail_plane")
        : aircraft{loadAirframe(std::string{LUFTPOST_SOURCE_DIR} + "/assets/airframes/" + airframe + ".json"),
                   payload, fuel} {}

    explicit TestFlight(AssistLevel level, AssistSettings const& parameters = {}) : TestFlight{} {
        assist = level;
        settings = parameters;
    }
    TestFlight(TestFlight const&) = delete;  // its air looks back at it

    /// `tas` in m/s at `altitude` m, north.
    TestFlight& inAir(double altitude, double tas) {
        aircraft.startInAir({0.0, altitude, 0.0}, 0.0, tas, air, ground, 0.0);
        stick = Controls{.throttle = state().trim.throttle};
        return *this;
    }
    TestFlight& onRunway() {
        aircraft.startOnRunway(0.0, 0.0, 0.0, air, ground, 0.0);
        return *this;
    }
    /// Flies for `seconds`, or until `pilot`, which sets the stick each tick, says false.
    void fly(double seconds, std::function<bool(double)> const& pilot) {
        for (int tick = 0; tick < seconds * core::kTicksPerSecond; ++tick) {
            if (!pilot(tick * core::kTickSeconds)) return;
            aircraft.step(stick, assist, settings, air, ground, time);
            time += core::kTickSeconds;
        }
    }
    void fly(double seconds) {
        fly(seconds, [](double) { return true; });
    }
    AircraftState const& state() const { return aircraft.state(); }
    Readings const& now() const { return aircraft.state().readings; }

    glm::dvec3 wind{0.0};
    core::AirFunction air = [this](glm::dvec3 const& p, core::UtcSeconds) {
        core::AirSample sample = isaAir(p.y);
        sample.windWorld = wind;
        return sample;
    };
    core::GroundFunction ground = [](double, double) {
        return core::GroundSample{.height = 0.0, .surface = core::Surface::runway};
    };
    Aircraft aircraft;
    Controls stick;
    AssistLevel assist = AssistLevel::sim;
    AssistSettings settings;
    double time = 0.0;
    double startsWithIce = 0.0;  // kg, of a card
};

inline double knots(double metresPerSecond) { return metresPerSecond / core::kMetresPerSecondPerKnot; }
inline double fromKnots(double kt) { return kt * core::kMetresPerSecondPerKnot; }
}  // namespace luftpost::flight
