#include "engine/audio/mixer.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"

namespace luftpost::audio {
namespace {
constexpr double kLoopRpm = 2400.0;      // that of assets/sounds/engine.wav and propeller.wav
constexpr double kCruise = 55.0;         // m/s
constexpr double kHeavyRain = 20.0 / 3600.0;  // kg/(m2 s): 20 mm/h
constexpr std::size_t kLoops = static_cast<std::size_t>(Loop::count);
constexpr std::size_t kEvents = static_cast<std::size_t>(Event::count);
constexpr int kShots = 12;               // voices for events: the oldest makes way
constexpr double kFadeSeconds = 0.05;

float clamped(double value, double low, double high) { return static_cast<float>(std::clamp(value, low, high)); }

std::size_t index(Loop loop) { return static_cast<std::size_t>(loop); }

bool isSurroundings(Event event) { return event == Event::thunder; }
}  // namespace

char const* fileName(Loop loop) {
    constexpr std::array<char const*, kLoops> kNames{"engine", "propeller", "wind", "rain", "stall", "wheels", "buffet", "climb"};
    CHECK(index(loop) < kLoops, "loop {}", index(loop));
    return kNames[index(loop)];
}

char const* fileName(Event event) {
    constexpr std::array<char const*, kEvents> kNames{"chute", "touchdown", "parcel_landed", "delivery", "lost",
                                                      "crash", "release", "click", "thunder", "flaps"};
    auto const i = static_cast<std::size_t>(event);
    CHECK(i < kEvents, "event {}", i);
    return kNames[i];
}

namespace {
/// What an ear hears of a tone whose source goes away.
double dopplerFactor(double recession) {
    constexpr double kSound = 340.0;  // m/s
    return kSound / (kSound + std::clamp(recession, -150.0, 150.0));
}

/// The tone of the climb: it rises with the lift and beats the faster the better it is; a deep steady one says sink.
LoopMix climbTone(AudioState const& state, AudioSettings const& settings) {
    constexpr double kQuiet = 0.3, kSink = -2.5;  // m/s
    if (state.onGround || (state.climb < kQuiet && state.climb > kSink)) return {};
    double const lift = std::clamp(state.climb, -8.0, 8.0);
    bool const on = lift < 0.0 || state.climbBeat - std::floor(state.climbBeat) < 0.5;
    return {on ? clamped(settings.master * settings.climb * 0.5, 0.0, 1.0) : 0.0f, clamped(1.0 + 0.14 * lift, 0.5, 2.2)};
}
}  // namespace

Mix mixFrom(AudioState const& state, AudioSettings const& settings) {
    Mix mix;
    if (state.paused) return mix;
    double const turning = state.rpm / kLoopRpm, pace = state.airspeed / kCruise;
    double const muffled = state.inside ? 0.62 : 1.0;
    double const power = settings.master * settings.engine * muffled;
    double const air = settings.master * settings.surroundings;
    if (state.rpm > 60.0) {
        double const heard = turning * dopplerFactor(state.recession);
        double const load = state.engineRunning ? state.throttle : 0.0;
        double const firing = state.engineRunning ? 0.30 + 0.42 * load : 0.05;
        mix[index(Loop::engine)] = {clamped(power * firing * std::min(1.0, 0.35 + 0.65 * turning), 0.0, 1.0), clamped(heard, 0.25, 2.0)};
        mix[index(Loop::propeller)] = {clamped(power * 0.42 * turning * turning * (0.55 + 0.45 * load), 0.0, 1.0), clamped(heard, 0.25, 2.0)};
    }
    // The pressure of the air grows with the square of its speed; a slip and rough air roar besides.
    double const slip = std::min(1.0, std::abs(state.slip) / 0.35), rough = std::min(1.0, state.turbulence / 4.0);
    double const rush = 0.42 * pace * pace + 0.25 * slip * std::min(1.0, pace) + 0.16 * rough * std::min(1.0, pace);
    mix[index(Loop::wind)] = {clamped(air * muffled * std::max(0.0, rush - 0.004), 0.0, 1.0), clamped(0.55 + 0.45 * pace + 0.1 * slip, 0.4, 2.2)};
    double const wet = std::sqrt(std::clamp(state.rain / kHeavyRain, 0.0, 1.5));
    mix[index(Loop::rain)] = {clamped(air * 0.55 * wet * (0.5 + 0.5 * std::min(1.0, pace)), 0.0, 1.0), clamped(0.85 + 0.2 * pace, 0.8, 1.4)};
    mix[index(Loop::stall)] = {state.stalled && !state.onGround ? clamped(settings.master * settings.effects * 0.5, 0.0, 1.0) : 0.0f, 1.0f};
    double const shaking = state.onGround ? 0.0 : std::min(1.0, 1.6 * state.separated) * std::min(1.0, state.airspeed / 25.0);
    mix[index(Loop::buffet)] = {clamped(settings.master * settings.effects * muffled * 0.8 * shaking, 0.0, 1.0), clamped(0.75 + 0.4 * state.airspeed / kCruise, 0.5, 1.6)};
    mix[index(Loop::climb)] = climbTone(state, settings);
    double const rolling = state.onGround ? std::min(1.0, state.groundSpeed / 20.0) : 0.0;
    mix[index(Loop::wheels)] = {clamped(settings.master * settings.effects * 0.7 * rolling, 0.0, 1.0), clamped(0.6 + 0.5 * state.groundSpeed / 20.0, 0.5, 2.0)};
    return mix;
}

double climbBeats(double climb) { return 1.5 + 0.6 * std::clamp(climb, 0.0, 8.0); }

float eventGain(SoundEvent const& event, AudioSettings const& settings) {
    double const share = isSurroundings(event.event) ? settings.surroundings : settings.effects;
    return clamped(settings.master * share * static_cast<double>(event.gain), 0.0, 1.0);
}

/// Device, context, buffers and sources; all freed together.
struct Mixer::Impl {
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    std::array<ALuint, kLoops> loopBuffers{}, loopSources{};
    std::array<ALuint, kEvents> eventBuffers{};
    std::array<ALuint, kShots> shotSources{};
    std::array<float, kLoops> gains{};
    std::size_t nextShot = 0;

    bool open();
    ~Impl();
    void playLoop(std::size_t i, LoopMix const& mix, double seconds);
    void playEvent(SoundEvent const& event, AudioState const& state, float gain);
};

bool Mixer::Impl::open() {
    device = alcOpenDevice(nullptr);
    if (!device) return false;
    context = alcCreateContext(device, nullptr);
    if (!context || !alcMakeContextCurrent(context)) return false;
    alGenSources(static_cast<ALsizei>(kLoops), loopSources.data());
    alGenSources(kShots, shotSources.data());
    alGenBuffers(static_cast<ALsizei>(kLoops), loopBuffers.data());
    alGenBuffers(static_cast<ALsizei>(kEvents), eventBuffers.data());
    alDistanceModel(AL_INVERSE_DISTANCE_CLAMPED);
    for (ALuint source : loopSources) alSourcei(source, AL_SOURCE_RELATIVE, AL_TRUE);
    return alGetError() == AL_NO_ERROR;
}

Mixer::Impl::~Impl() {
    if (context) {
        alDeleteSources(static_cast<ALsizei>(kLoops), loopSources.data());
        alDeleteSources(kShots, shotSources.data());
        alDeleteBuffers(static_cast<ALsizei>(kLoops), loopBuffers.data());
        alDeleteBuffers(static_cast<ALsizei>(kEvents), eventBuffers.data());
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context);
    }
    if (device) alcCloseDevice(device);
}

void Mixer::Impl::playLoop(std::size_t i, LoopMix const& mix, double seconds) {
    ALuint const source = loopSources[i];
    float const share = static_cast<float>(1.0 - std::exp(-seconds / kFadeSeconds));
    gains[i] += (mix.gain - gains[i]) * share;
    if (gains[i] < 1e-4f && mix.gain == 0.0f) gains[i] = 0.0f;
    ALint playing = AL_STOPPED;
    alGetSourcei(source, AL_SOURCE_STATE, &playing);
    if (gains[i] == 0.0f) {
        if (playing == AL_PLAYING) alSourcePause(source);
        return;
    }
    alSourcef(source, AL_GAIN, gains[i]);
    alSourcef(source, AL_PITCH, std::clamp(mix.pitch, 0.25f, 4.0f));
    if (playing != AL_PLAYING) alSourcePlay(source);
}

void Mixer::Impl::playEvent(SoundEvent const& event, AudioState const& state, float gain) {
    ALuint const source = shotSources[nextShot];
    nextShot = (nextShot + 1) % kShots;
    alSourceStop(source);
    alSourcei(source, AL_BUFFER, static_cast<ALint>(eventBuffers[static_cast<std::size_t>(event.event)]));
    glm::vec3 place{0.0f};
    if (!event.near) place = glm::vec3{glm::conjugate(state.worldFromListener) * (event.positionWorld - state.listenerWorld)};
    alSourcei(source, AL_SOURCE_RELATIVE, AL_TRUE);
    alSource3f(source, AL_POSITION, place.x, place.y, place.z);
    alSourcef(source, AL_REFERENCE_DISTANCE, event.event == Event::thunder ? 1500.0f : 40.0f);
    alSourcef(source, AL_GAIN, gain);
    alSourcePlay(source);
}

Mixer::Mixer() : impl_{std::make_unique<Impl>()} {
    if (impl_->open()) return;
    impl_.reset();
    spdlog::info("No sound device: the game is silent.");
}

Mixer::~Mixer() = default;

void Mixer::load(Loop loop, Clip const& clip) {
    CHECK(clip.rate > 0 && !clip.samples.empty(), "sound {} is empty", fileName(loop));
    if (!impl_) return;
    std::size_t const i = index(loop);
    alBufferData(impl_->loopBuffers[i], AL_FORMAT_MONO16, clip.samples.data(), static_cast<ALsizei>(clip.samples.size() * 2), clip.rate);
    alSourcei(impl_->loopSources[i], AL_BUFFER, static_cast<ALint>(impl_->loopBuffers[i]));
    alSourcei(impl_->loopSources[i], AL_LOOPING, AL_TRUE);
}

void Mixer::load(Event event, Clip const& clip) {
    CHECK(clip.rate > 0 && !clip.samples.empty(), "sound {} is empty", fileName(event));
    if (!impl_) return;
    alBufferData(impl_->eventBuffers[static_cast<std::size_t>(event)], AL_FORMAT_MONO16, clip.samples.data(),
                 static_cast<ALsizei>(clip.samples.size() * 2), clip.rate);
}

void Mixer::play(AudioState const& state, AudioSettings const& settings, double seconds) {
    if (!impl_) return;
    Mix const mix = mixFrom(state, settings);
    glm::vec3 const away{glm::conjugate(state.worldFromListener) * (state.aircraftWorld - state.listenerWorld)};
    for (std::size_t i = 0; i < kLoops; ++i) {
        bool const aircraft = i == index(Loop::engine) || i == index(Loop::propeller) || i == index(Loop::wheels) || i == index(Loop::buffet);
        glm::vec3 const place = aircraft ? away : glm::vec3{0.0f};
        alSource3f(impl_->loopSources[i], AL_POSITION, place.x, place.y, place.z);
        alSourcef(impl_->loopSources[i], AL_REFERENCE_DISTANCE, 25.0f);
        impl_->playLoop(i, mix[i], seconds);
    }
    for (SoundEvent const& event : state.events) impl_->playEvent(event, state, eventGain(event, settings));
    if (ALenum const error = alGetError(); error != AL_NO_ERROR) spdlog::debug("OpenAL error {:#x}", error);
}
}  // namespace luftpost::audio
