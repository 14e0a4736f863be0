// What is heard. `mixFrom` says how loud and how high each loop is, from the state of one frame (pure); `Mixer` plays it on
// OpenAL. Without a sound device the mixer is silent and says so once; it is never an error.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/audio/audio_settings.h"

namespace luftpost::audio {
/// Loops run always; a gain of 0 pauses them. Events play once. The names are those of assets/sounds/NAME.wav.
enum class Loop { engine, propeller, wind, rain, stall, wheels, buffet, climb, count };
enum class Event { chute, touchdown, parcel_landed, delivery, lost, crash, release, click, thunder, flaps, count };
char const* fileName(Loop loop);
char const* fileName(Event event);

/// An event to be heard, where it happens (world frame) or, when `near` is set, at the listener.
struct SoundEvent {
    Event event = Event::click;
    glm::dvec3 positionWorld{0.0};
    bool near = true;
    float gain = 1.0f;
};

/// What one frame sounds like. SI; from the same air as the flight.
struct AudioState {
    double rpm = 0.0;
    double throttle = 0.0;       // 0..1, the engine's load
    bool engineRunning = true;
    double airspeed = 0.0;       // m/s, true
    double slip = 0.0;           // rad, angle of the air from the side
    double turbulence = 0.0;     // m/s
    double rain = 0.0;           // kg/(m2 s), falling rate
    bool stalled = false;        // the horn
    double separated = 0.0;      // 0..1, share of the wing whose flow has left: it buffets
    double climb = 0.0;          // m/s, of the air and the aircraft together
    double climbBeat = 0.0;      // beats of the climb's tone so far, at climbBeats a second
    double recession = 0.0;      // m/s, at which the aircraft goes away from the ear: Doppler
    bool onGround = false;
    double groundSpeed = 0.0;    // m/s
    bool inside = false;         // the cockpit muffles
    bool paused = false;
    glm::dvec3 listenerWorld{0.0};
    glm::dquat worldFromListener{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 aircraftWorld{0.0};
    std::vector<SoundEvent> events;  // that began in this frame
};

struct LoopMix {
    float gain = 0.0f;   // 0..1
    float pitch = 1.0f;  // 0.25..4
};
using Mix = std::array<LoopMix, static_cast<std::size_t>(Loop::count)>;

/// Gain and pitch of each loop. Pure.
Mix mixFrom(AudioState const& state, AudioSettings const& settings);
/// Beats a second of the tone of a climb (m/s). Pure.
double climbBeats(double climb);
/// Gain of an event under the player's settings. Pure.
float eventGain(SoundEvent const& event, AudioSettings const& settings);

/// Samples of one sound, 16 bit mono, as the app read them (engine/assets/sound.h).
struct Clip {
    std::vector<std::int16_t> samples;
    int rate = 0;  // samples a second
};

class Mixer {
public:
    /// Opens the default device, if there is one.
    Mixer();
    ~Mixer();
    Mixer(Mixer const&) = delete;
    Mixer& operator=(Mixer const&) = delete;

    bool silent() const { return impl_ == nullptr; }
    /// Hands the samples of a sound over; a loop starts when its gain rises over 0.
    void load(Loop loop, Clip const& clip);
    void load(Event event, Clip const& clip);
    /// Plays one frame. Main thread. Smooth: gains follow over some 50 ms.
    void play(AudioState const& state, AudioSettings const& settings, double seconds);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};
}  // namespace luftpost::audio
