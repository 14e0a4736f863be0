// Weather that enters a flight on its way, from a feed or a hand: a stamped input that carries its own recording.
#include <gtest/gtest.h>

#include <thread>

#include "engine/core/time.h"
#include "engine/weather/presets.h"
#include "tests/support/session.h"

using namespace luftpost;
using namespace luftpost::app;
using tests::fly, tests::planOver, tests::readBack, tests::refusal;

namespace {
core::UtcSeconds const kNow = *core::parseUtc("2024-05-01T12:00Z");
constexpr weather::PlaceWish kHere{47.0, 8.0, 430.0};

std::string presetText(char const* name) { return weather::recordingText(*weather::presetRecording(name, kHere)); }

WeatherInput liveStorm() {
    return {.source = kLiveSource, .recording = presetText("storm"), .mode = weather::SourceMode::Live, .fetched = kNow, .from = kNow + 0.125, .seconds = 300.0};
}

/// Frames without ticks until the offered weather acts.
void waitForWeather(Session& session, std::string const& source) {
    for (int i = 0; i < 2000 && session.world().source() != source; ++i) {
        EXPECT_EQ(session.enterOffered().value_or(""), "");
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    ASSERT_EQ(session.world().source(), source);
}

TEST(WeatherInput, IsKeptInAReplayWithItsRecordingToTheLastBit) {
    Replay replay{planOver("preset:fair"), 480, {{100, liveStorm()}, {200, WeatherInput{.source = "preset:calm"}}}};
    replay.plan.weather = {.source = kLiveSource, .recording = presetText("broken"), .mode = weather::SourceMode::Stale, .fetched = kNow - 1.0 / 3.0};
    Replay const back = readBack(replayText(replay));
    EXPECT_EQ(back.inputs, replay.inputs);
    EXPECT_EQ(back.plan.weather, replay.plan.weather);
}

TEST(WeatherInput, IsReadStrictly) {
    std::string const good = replayText({planOver("preset:fair"), 480, {{100, liveStorm()}}});
    EXPECT_NE(refusal(good, R"("mode":"live")", R"("mode":"lively")").find("inputs[0].weather.mode: expected one of recorded, preset, live, stale"), std::string::npos);
    EXPECT_NE(refusal(good, R"("seconds":300.0)", R"("seconds":-1)").find("inputs[0].weather.seconds"), std::string::npos);
    EXPECT_NE(refusal(good, R"("from_utc":)", R"("from":)").find("from_utc"), std::string::npos);
    EXPECT_NE(refusal(good, R"(\"speed_mps\":)", R"(\"speed_mps\":-)").find("inputs[0].weather.recording"), std::string::npos);
    EXPECT_NE(refusal(good, R"("recording":")", R"("recording":"x)").find("inputs[0].weather.recording"), std::string::npos);
}

TEST(WeatherInput, ActsFromItsTickAndFliesTheSameAgain) {
    Session flown{{planOver("preset:calm"), {}, {}, false, false}};
    fly(flown, 0.5);
    EXPECT_EQ(flown.enterOffered(), std::nullopt);
    flown.offerWeather(liveStorm());
    waitForWeather(flown, kLiveSource);
    EXPECT_EQ(flown.world().field().origin().mode, weather::SourceMode::Live);
    fly(flown, 1.25);
    flown.offerWeather({.source = kHandSource, .recording = presetText("clear"), .mode = weather::SourceMode::Preset, .seconds = kHandSeconds});
    waitForWeather(flown, kHandSource);
    fly(flown, 1.25);
    Replay const replay = readBack(replayText(flown.replay()));
    ASSERT_EQ(replay.inputs.size(), 2u);
    EXPECT_EQ(replay.inputs[0].tick, 120);
    EXPECT_EQ(replay.inputs[1].tick, 420);

    Session again{{replay.plan, replay.inputs, {}, false, false}};
    fly(again, 3.0);
    EXPECT_EQ(again.simulation().stateHash(), flown.simulation().stateHash());
    Session other{{replay.plan, {}, {}, false, false}};
    fly(other, 3.0);
    EXPECT_NE(other.simulation().stateHash(), flown.simulation().stateHash()) << "the weather moves the aircraft";
}

TEST(WeatherInput, OfSeveralInARowTheLastCountsAndABrokenOneIsSaid) {
    Session session{{planOver("preset:calm"), {}, {}, false, false}};
    for (char const* preset : {"fair", "broken", "overcast", "storm"})
        session.offerWeather({.source = preset, .recording = presetText(preset), .mode = weather::SourceMode::Preset, .seconds = kHandSeconds});
    waitForWeather(session, "storm");
    EXPECT_EQ(session.replay().inputs.size(), 1u) << "nothing was entered that nobody waited for";
    session.offerWeather({.source = kLiveSource, .recording = "{}", .mode = weather::SourceMode::Live, .seconds = kFeedSeconds});
    std::optional<std::string> said;
    for (int i = 0; i < 2000 && !said; ++i) {
        said = session.enterOffered();
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    EXPECT_NE(said.value_or("").find("luftpost-weather-1"), std::string::npos) << said.value_or("nothing");
    EXPECT_EQ(session.world().source(), "storm") << "the weather before goes on";
}
}  // namespace
