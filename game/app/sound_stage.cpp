#include "game/app/sound_stage.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "engine/assets/sound.h"
#include "engine/platform/paths.h"
#include "engine/weather/lightning.h"

namespace luftpost::app {
namespace {
audio::Clip clip(char const* name) {
    assets::Sound sound =
        assets::readSound(platform::dataFile("assets/sounds/" + std::string{name} + ".wav"));
    return {std::move(sound.samples), sound.rate};
}

audio::SoundEvent sound(audio::Event event, glm::dvec3 const& positionWorld, bool near) {
    return {event, positionWorld, near, 1.0f};
}
}  // namespace

SoundStage::SoundStage() {
    if (mixer_.silent()) return;
    for (int i = 0; i < static_cast<int>(audio::Loop::count); ++i) {
        auto const loop = static_cast<audio::Loop>(i);
        mixer_.load(loop, clip(audio::fileName(loop)));
    }
    for (int i = 0; i < static_cast<int>(audio::Event::count); ++i) {
        auto const event = static_cast<audio::Event>(i);
        mixer_.load(event, clip(audio::fileName(event)));
    }
}

void SoundStage::note(FlightEventAt const& event) {
    using audio::Event;
    auto const add = [&](Event which, bool near) {
        events_.push_back(sound(which, event.positionWorld, near));
    };
    switch (event.event) {
        case FlightEvent::released:
            return add(Event::release, true);
        case FlightEvent::chuteOpened:
            return add(Event::chute, false);
        case FlightEvent::delivered:
            return add(Event::parcel_landed, false), add(Event::delivery, true);
        case FlightEvent::lost:
            return add(Event::parcel_landed, false), add(Event::lost, true);
        case FlightEvent::crashed:
            return add(Event::crash, true);
        case FlightEvent::touchdown:
            return add(Event::touchdown, true);
        case FlightEvent::landed:
        case FlightEvent::respawned:
        case FlightEvent::autopilot:
            return;
    }
}

/// The motor is heard when the lever moves to another notch.
void SoundStage::noteFlaps(double flaps) {
    if (std::abs(flaps - flaps_) > 0.05) events_.push_back(sound(audio::Event::flaps, glm::dvec3{0.0}, true));
    flaps_ = flaps;
}

/// The thunder of the flashes that one sees, as late as it is far; nothing after a jump of the clock.
void SoundStage::noteThunder(Simulation const& simulation, weather::Weather const& weather, glm::dvec3 const& eyeWorld) {
    constexpr double kLongestFrame = 2.0;  // s
    core::UtcSeconds const now = simulation.utc(), before = std::exchange(heardUntil_, now);
    if (!(now > before) || now - before > kLongestFrame) return;
    World const& world = simulation.world();
    for (weather::Flash const& flash : weather::thunders(weather, world.land().seed(), before, now, eyeWorld, world.place().altitude_m))
        events_.push_back(sound(audio::Event::thunder, flash.toGround ? 0.5 * (flash.sourceWorld + flash.groundWorld) : flash.sourceWorld, false));
}

/// How fast the aircraft goes away from the ear; nothing where the camera jumped.
double SoundStage::recession(double distance, double passed) {
    constexpr double kFastest = 200.0, kLag = 0.1;  // m/s, s
    double const moved = distance - std::exchange(distance_, distance);
    if (!(passed > 0.0)) return recession_;
    double const now = std::abs(moved) < kFastest * passed ? moved / passed : 0.0;
    return recession_ += (now - recession_) * std::min(passed / kLag, 1.0);
}

void SoundStage::play(Simulation const& simulation, ui::CameraPose const& camera, bool inside, bool paused,
                      audio::AudioSettings const& settings, double wallSeconds) {
    constexpr double kSecondsPerHour = 3600.0;
    flight::AircraftState const& aircraft = simulation.aircraft().state();
    flight::Readings const& readings = aircraft.readings;
    audio::AudioState state;
    state.rpm = aircraft.propellerRate * 60.0 / (2.0 * core::kPi);
    state.throttle = simulation.stick().controls().throttle;
    state.engineRunning = aircraft.fuel > 0.0;
    state.airspeed = readings.tas;
    state.slip = readings.beta;
    state.turbulence = readings.turbulence;
    glm::dvec3 const& eye = camera.positionWorld;
    weather::Weather const weather = simulation.world().field().at(eye.x, -eye.z, simulation.utc());
    core::AirSample const air = simulation.airNow().at(eye);
    state.rain = (air.rain + air.hail) / kSecondsPerHour;  // snow is not heard
    noteFlaps(simulation.stick().controls().flaps);
    if (!paused) noteThunder(simulation, weather, eye);
    state.stalled = readings.stallHorn;
    state.separated = readings.stalled;
    double const passed = std::max(simulation.seconds() - std::exchange(since_, simulation.seconds()), 0.0);
    state.climb = readings.climb;
    state.climbBeat = climbBeat_ += passed * audio::climbBeats(readings.climb);
    state.recession = recession(glm::length(aircraft.positionWorld - eye), passed);
    state.onGround = readings.onGround;
    state.groundSpeed = readings.groundSpeed;
    state.inside = inside;
    state.paused = paused;
    state.listenerWorld = eye;
    state.worldFromListener = camera.worldFromCamera;
    state.aircraftWorld = aircraft.positionWorld;
    state.events = std::exchange(events_, {});
    mixer_.play(state, settings, wallSeconds);
}
}  // namespace luftpost::app
