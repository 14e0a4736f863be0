// A replay that is watched: any moment of it is the flight's own, to the last bit.
#include <gtest/gtest.h>

#include <thread>

#include "engine/core/time.h"
#include "engine/weather/presets.h"
#include "game/app/frame_clock.h"
#include "game/app/replay_view.h"
#include "tests/support/session.h"

using namespace luftpost;
using namespace luftpost::app;

namespace {
core::UtcSeconds const kNow = *core::parseUtc("2024-05-01T12:00Z");
constexpr weather::PlaceWish kHere{47.0, 8.0, 430.0};
constexpr long long kTicks = 30 * core::kTicksPerSecond;

ui::InputSample stick(double aileron, bool drop = false) {
    ui::InputSample sample;
    sample.direct = ui::DirectStick{0.8, 0.0, aileron, 0.0, 0.0, 0.0};
    sample.hold(ui::FlightKey::drop, drop);
    return sample;
}

/// Turns, drops, another weather, another hour, another assist.
SessionOptions flight() {
    SessionOptions options = tests::flying(tests::planOver("preset:fair"));
    WeatherInput const storm{.source = kLiveSource, .recording = weather::recordingText(*weather::presetRecording("storm", kHere)),
                             .mode = weather::SourceMode::Live, .fetched = kNow, .from = kNow + 12.0, .seconds = 300.0};
    options.script = {{0, stick(0.2)}, {1200, stick(-0.3, true)}, {2880, storm}, {4000, ClockInput{kNow + 7200.0}},
                      {5000, SettingInput{"aircraft.assist", std::string{"sim"}}}, {5040, stick(0.1)}};
    return options;
}

/// The state at every second of the flight.
std::vector<std::string> const& hashes() {
    static std::vector<std::string> const found = [] {
        Session session{flight()};
        std::vector<std::string> list{session.simulation().stateHash()};
        while (session.simulation().tick() < kTicks) {
            session.tick();
            if (session.simulation().tick() % core::kTicksPerSecond == 0) list.push_back(session.simulation().stateHash());
        }
        return list;
    }();
    return found;
}

/// Waits until the reel is flown.
void waitFor(ReplayView const& view, Session const& session) {
    for (int i = 0; i < 30000 && view.bar(session.simulation()).known < 30.0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds{1});
    ASSERT_EQ(view.bar(session.simulation()).known, 30.0);
}

TEST(ReplayView, GoesToAnySecondForwardAndBackAndOnFromThere) {
    Session session{flight()};
    ReplayView view{flight(), kTicks};
    waitFor(view, session);
    for (int second : {20, 3, 12, 13, 29, 0, 17}) {
        view.seek(second, session);
        EXPECT_EQ(session.simulation().stateHash(), hashes()[static_cast<std::size_t>(second)]) << second;
    }
    while (session.simulation().tick() < kTicks) session.tick();
    EXPECT_EQ(session.simulation().stateHash(), hashes().back()) << "flown on from 17 s, through the hour and the assist";
    view.seek(4.99, session);
    while (session.simulation().tick() < kTicks) session.tick();
    EXPECT_EQ(session.simulation().stateHash(), hashes().back()) << "and through the drop and the weather";
}

TEST(ReplayView, GoesNoFartherThanTheFlight) {
    Session session{flight()};
    ReplayView view{flight(), kTicks};
    waitFor(view, session);
    view.seek(1000.0, session);
    EXPECT_EQ(session.simulation().tick(), kTicks);
    view.seek(-5.0, session);
    EXPECT_EQ(session.simulation().tick(), 0);
}

TEST(ReplayView, MarksWhatHappenedOnTheTimeLine) {
    Session session{flight()};
    ReplayView view{flight(), kTicks};
    waitFor(view, session);
    ui::ReplayBar const bar = view.bar(session.simulation());
    EXPECT_EQ(bar.length, 30.0);
    EXPECT_EQ(bar.note, "");
    ASSERT_FALSE(bar.marks.empty());
    EXPECT_EQ(bar.marks.front().text, "Parcel released");
    EXPECT_NEAR(bar.marks.front().seconds, 5.0, 0.01);
}

TEST(ReplayView, StopsAtTheEndAndBeginsAgain) {
    Session session{flight()};
    ReplayView view{flight(), kTicks};
    waitFor(view, session);
    view.seek(30.0, session);
    view.follow(session.simulation());
    EXPECT_FALSE(view.playing());
    view.toggle(session);
    EXPECT_TRUE(view.playing());
    EXPECT_EQ(session.simulation().tick(), 0);
}

TEST(ReplayView, ObeysTheKeysThatFlyWhenTheyGoDown) {
    Session session{flight()};
    ReplayView view{flight(), kTicks};
    waitFor(view, session);
    ui::InputSample keys;
    keys.hold(ui::FlightKey::rollRight);
    EXPECT_TRUE(view.obey(keys, session));
    EXPECT_FALSE(view.obey(keys, session)) << "held is not pressed again";
    EXPECT_EQ(session.simulation().seconds(), 10.0);
    keys = {};
    keys.hold(ui::FlightKey::thrustUp);
    view.obey(keys, session);
    EXPECT_EQ(view.speed(), 2.0);
    keys = {};
    keys.hold(ui::FlightKey::drop);
    view.obey(keys, session);
    EXPECT_FALSE(view.playing());
}

TEST(FrameClock, FliesManySecondsInOneOfThePlayersWhereAskedFor) {
    FrameClock clock;
    EXPECT_EQ(clock.step(0.1, false, 16.0).ticks, 384);
    EXPECT_EQ(clock.step(0.1, false, 0.25).ticks, 6);
    EXPECT_EQ(clock.step(0.1, true, 16.0).ticks, 0);
}
}  // namespace
