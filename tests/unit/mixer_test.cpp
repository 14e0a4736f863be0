// What is heard follows from the flight: gains and pitches of the loops.
#include "engine/audio/mixer.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {
using namespace luftpost::audio;

AudioState cruise() {
    AudioState state;
    state.rpm = 2400.0;
    state.throttle = 0.7;
    state.airspeed = 55.0;
    return state;
}

LoopMix of(Mix const& mix, Loop loop) { return mix[static_cast<std::size_t>(loop)]; }

TEST(Mix, RaisesTheEnginesPitchWithItsSpeedAndItsLoudnessWithTheLoad) {
    AudioState slow = cruise(), idle = cruise();
    slow.rpm = 1200.0;
    idle.throttle = 0.0;
    LoopMix const engine = of(mixFrom(cruise(), {}), Loop::engine);
    EXPECT_FLOAT_EQ(engine.pitch, 1.0f);
    EXPECT_FLOAT_EQ(of(mixFrom(slow, {}), Loop::engine).pitch, 0.5f);
    EXPECT_LT(of(mixFrom(idle, {}), Loop::engine).gain, 0.7f * engine.gain);
    idle.rpm = 0.0;
    EXPECT_EQ(of(mixFrom(idle, {}), Loop::engine).gain, 0.0f);
}

TEST(Mix, LetsTheWindRoarWithTheSquareOfTheAirspeedAndInASlip) {
    AudioState fast = cruise(), slipping = cruise(), still = cruise();
    fast.airspeed *= 1.4;
    slipping.slip = 0.3;
    still.airspeed = 0.0;
    float const wind = of(mixFrom(cruise(), {}), Loop::wind).gain;
    EXPECT_NEAR(of(mixFrom(fast, {}), Loop::wind).gain, 1.96f * wind, 0.03f * wind);
    EXPECT_GT(of(mixFrom(slipping, {}), Loop::wind).gain, 1.2f * wind);
    EXPECT_EQ(of(mixFrom(still, {}), Loop::wind).gain, 0.0f);
}

TEST(Mix, RainsOnlyInRainAndRollsOnlyOnTheGround) {
    AudioState state = cruise();
    EXPECT_EQ(of(mixFrom(state, {}), Loop::rain).gain, 0.0f);
    EXPECT_EQ(of(mixFrom(state, {}), Loop::wheels).gain, 0.0f);
    state.rain = 5.0 / 3600.0;
    state.onGround = true;
    state.groundSpeed = 15.0;
    EXPECT_GT(of(mixFrom(state, {}), Loop::rain).gain, 0.1f);
    EXPECT_GT(of(mixFrom(state, {}), Loop::wheels).gain, 0.1f);
}

TEST(Mix, SoundsTheStallHornInTheAirAlone) {
    AudioState state = cruise();
    EXPECT_EQ(of(mixFrom(state, {}), Loop::stall).gain, 0.0f);
    state.stalled = true;
    EXPECT_GT(of(mixFrom(state, {}), Loop::stall).gain, 0.1f);
    state.onGround = true;
    EXPECT_EQ(of(mixFrom(state, {}), Loop::stall).gain, 0.0f);
}

TEST(Mix, IsSilentWhilePausedOrTurnedDown) {
    AudioState state = cruise();
    state.rain = 1.0e-3;
    state.paused = true;
    for (LoopMix const& loop : mixFrom(state, {})) EXPECT_EQ(loop.gain, 0.0f);
    state.paused = false;
    AudioSettings off;
    off.master = 0.0;
    for (LoopMix const& loop : mixFrom(state, off)) EXPECT_EQ(loop.gain, 0.0f);
    EXPECT_EQ(eventGain({Event::delivery}, off), 0.0f);
}

TEST(Mix, StaysWithinWhatADeviceCanPlay) {
    for (double rpm : {0.0, 500.0, 2700.0, 9000.0})
        for (double speed : {0.0, 30.0, 90.0, 300.0}) {
            AudioState state = cruise();
            state.rpm = rpm, state.airspeed = speed, state.rain = 0.1, state.stalled = true, state.turbulence = 20.0, state.slip = 3.0;
            for (LoopMix const& loop : mixFrom(state, {})) {
                EXPECT_GE(loop.gain, 0.0f);
                EXPECT_LE(loop.gain, 1.0f);
                EXPECT_GE(loop.pitch, 0.25f);
                EXPECT_LE(loop.pitch, 4.0f);
            }
        }
}

/// Whether the mixer found a device, after half a second of play; OpenAL Soft reads the variable once a process.
bool playedSilently(char const* driver) {
    setenv("ALSOFT_DRIVERS", driver, 1);
    Mixer mixer;
    Clip const clip{std::vector<std::int16_t>(2205, 1000), 22050};
    mixer.load(Loop::engine, clip);
    mixer.load(Event::thunder, clip);
    AudioState state = cruise();
    state.events = {{Event::thunder, {900.0, 300.0, 0.0}, false, 1.0f}};
    for (int i = 0; i < 30; ++i) mixer.play(state, {}, 1.0 / 60.0);
    return mixer.silent();
}

TEST(Mix, LowersAnAircraftThatGoesAwayAndRaisesOneThatComes) {
    AudioState comes = cruise(), goes = cruise();
    comes.recession = -50.0, goes.recession = 50.0;
    for (Loop loop : {Loop::engine, Loop::propeller}) {
        float const near = of(mixFrom(cruise(), {}), loop).pitch;
        EXPECT_NEAR(of(mixFrom(comes, {}), loop).pitch, near * 340.0f / 290.0f, 1.0e-5f);
        EXPECT_NEAR(of(mixFrom(goes, {}), loop).pitch, near * 340.0f / 390.0f, 1.0e-5f);
    }
}

TEST(Mix, BuffetsAsFarAsTheFlowHasLeftTheWing) {
    AudioState state = cruise();
    EXPECT_EQ(of(mixFrom(state, {}), Loop::buffet).gain, 0.0f);
    state.separated = 0.2;
    float const some = of(mixFrom(state, {}), Loop::buffet).gain;
    EXPECT_GT(some, 0.05f);
    state.separated = 0.6;
    EXPECT_GT(of(mixFrom(state, {}), Loop::buffet).gain, some);
    state.onGround = true;
    EXPECT_EQ(of(mixFrom(state, {}), Loop::buffet).gain, 0.0f);
}

TEST(Mix, TellsClimbByATonePlayersAskFor) {
    AudioState state = cruise();
    AudioSettings asked;
    asked.climb = 1.0;
    state.climb = 2.0;
    EXPECT_EQ(of(mixFrom(state, {}), Loop::climb).gain, 0.0f) << "not asked for";
    LoopMix const two = of(mixFrom(state, asked), Loop::climb);
    EXPECT_GT(two.gain, 0.1f);
    state.climbBeat = 0.6;
    EXPECT_EQ(of(mixFrom(state, asked), Loop::climb).gain, 0.0f) << "between two beats";
    state.climbBeat = 1.2, state.climb = 5.0;
    EXPECT_GT(of(mixFrom(state, asked), Loop::climb).pitch, two.pitch);
    EXPECT_GT(climbBeats(5.0), climbBeats(2.0));
    state.climbBeat = 0.6, state.climb = -4.0;
    EXPECT_GT(of(mixFrom(state, asked), Loop::climb).gain, 0.1f) << "sink sounds on";
    EXPECT_LT(of(mixFrom(state, asked), Loop::climb).pitch, 1.0f);
    state.climb = 0.1;
    EXPECT_EQ(of(mixFrom(state, asked), Loop::climb).gain, 0.0f);
}

TEST(MixerDeathTest, PlaysOnADeviceAndIsSilentWithoutOne) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";  // a process of its own: libraries here have threads
    EXPECT_EXIT(std::_Exit(playedSilently("none-such") ? 0 : 1), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(std::_Exit(playedSilently("null") ? 1 : 0), testing::ExitedWithCode(0), "");  // OpenAL's own mute device
}
}  // namespace
