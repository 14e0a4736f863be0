// Weather that enters a flight on its way, from a feed or a hand: a stamped input that carries its own recording.
#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/platform/paths.h"
#include "engine/weather/presets.h"
#include "game/app/instruments.h"
#include "game/app/session.h"

using namespace luftpost;
using namespace luftpost::app;

namespace {
core::UtcSeconds const kNow = *core::parseUtc("2024-05-01T12:00Z");
constexpr weather::PlaceWish kHere{47.0, 8.0, 430.0};

std::string presetText(char const* name) { return weather::recordingText(*weather::presetRecording(name, kHere)); }

FlightPlan planOf(char const* preset) {
    FlightPlan plan;
    plan.weather.source = std::string{"preset:"} + preset;
    plan.place = {kHere.lat_deg, kHere.lon_deg, *kHere.altitude_m};
    plan.simulation.time = kNow;
    plan.simulation.start.altitude = 900.0;
    return plan;
}

WeatherInput liveStorm() {
    return {.source = kLiveSource, .recording = presetText("storm"), .mode = weather::SourceMode::Live, .fetched = kNow, .from = kNow + 0.125, .seconds = 300.0};
}

std::filesystem::path replayFile(std::string const& text) {
    std::filesystem::path const file = std::filesystem::path{testing::TempDir()} / "luftpost_weather_input.replay";
    core::writeFileAtomically(file, text);
    return file;
}

Replay readBack(std::string const& text) {
    return readReplay(replayFile(text), loadHangar());
}

void fly(Session& session, int ticks) {
    for (int i = 0; i < ticks; ++i) session.tick();
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
    Replay replay{planOf("fair"), 480, {{100, liveStorm()}, {200, WeatherInput{.source = "preset:calm"}}}};
    replay.plan.weather = {.source = kLiveSource, .recording = presetText("broken"), .mode = weather::SourceMode::Stale, .fetched = kNow - 1.0 / 3.0};
    Replay const back = readBack(replayText(replay));
    EXPECT_EQ(back.inputs, replay.inputs);
    EXPECT_EQ(back.plan.weather, replay.plan.weather);
}

TEST(WeatherInput, IsReadStrictly) {
    std::string const good = replayText({planOf("fair"), 480, {{100, liveStorm()}}});
    auto const refusal = [&](std::string const& from, std::string const& to) {
        std::string text = good;
        auto const at = text.find(from);
        EXPECT_NE(at, text.npos) << from;
        text.replace(at, from.size(), to);
        try {
            readBack(text);
        } catch (core::Error const& error) {
            return std::string{error.what()};
        }
        return std::string{"read"};
    };
    EXPECT_NE(refusal(R"("mode":"live")", R"("mode":"lively")").find("inputs[0].weather.mode: expected one of recorded, preset, live, stale"), std::string::npos);
    EXPECT_NE(refusal(R"("seconds":300.0)", R"("seconds":-1)").find("inputs[0].weather.seconds"), std::string::npos);
    EXPECT_NE(refusal(R"("from_utc":)", R"("from":)").find("from_utc"), std::string::npos);
    EXPECT_NE(refusal(R"(\"speed_mps\":)", R"(\"speed_mps\":-)").find("inputs[0].weather.recording"), std::string::npos);
    EXPECT_NE(refusal(R"("recording":")", R"("recording":"x)").find("inputs[0].weather.recording"), std::string::npos);
}

TEST(WeatherInput, ActsFromItsTickAndFliesTheSameAgain) {
    Session flown{{planOf("calm"), {}, {}, false, false}};
    fly(flown, 100);
    EXPECT_EQ(flown.enterOffered(), std::nullopt);
    flown.offerWeather(liveStorm());
    waitForWeather(flown, kLiveSource);
    EXPECT_EQ(flown.world().field().origin().mode, weather::SourceMode::Live);
    fly(flown, 300);
    flown.offerWeather({.source = kHandSource, .recording = presetText("clear"), .mode = weather::SourceMode::Preset, .seconds = kHandSeconds});
    waitForWeather(flown, kHandSource);
    fly(flown, 300);
    Replay const replay = readBack(replayText(flown.replay()));
    ASSERT_EQ(replay.inputs.size(), 2u);
    EXPECT_EQ(replay.inputs[0].tick, 100);
    EXPECT_EQ(replay.inputs[1].tick, 400);

    Session again{{replay.plan, replay.inputs, {}, false, false}};
    fly(again, 700);
    EXPECT_EQ(again.simulation().stateHash(), flown.simulation().stateHash());
    Session other{{replay.plan, {}, {}, false, false}};
    fly(other, 700);
    EXPECT_NE(other.simulation().stateHash(), flown.simulation().stateHash()) << "the weather moves the aircraft";
}

TEST(WeatherInput, OfSeveralInARowTheLastCountsAndABrokenOneIsSaid) {
    Session session{{planOf("calm"), {}, {}, false, false}};
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
