// What the hands do comes back from a replay to the last bit, and flies the same flight again.
#include <gtest/gtest.h>

#include "tests/support/session.h"

namespace {
using namespace luftpost;
using namespace luftpost::app;
using tests::planOver, tests::readBack, tests::refusal;

FlightPlan calmPlan() {
    FlightPlan plan = planOver("preset:calm");
    plan.simulation.settings.pilot.assist = flight::AssistLevel::light;
    return plan;
}

/// A pilot with a lever, a mouse and a hand on the trim.
std::vector<StampedInput> hands() {
    ui::InputSample rest, moved, trimming;
    rest.pad.lever = 0.25f, rest.pad.flaps = 0.0f;
    moved.pad.lever = 0.8f, moved.pad.flaps = 1.0f / 3.0f;
    moved.mouse = ui::MouseStick{0.3f, -0.1f};
    trimming.hold(ui::FlightKey::trimNoseUp);
    trimming.hold(ui::FlightKey::trimYawLeft);
    return {{0, rest}, {10, moved}, {200, trimming}};
}

TEST(PilotInput, ComesBackFromAReplay) {
    Replay const replay{calmPlan(), 480, hands()};
    EXPECT_EQ(readBack(replayText(replay)).inputs, replay.inputs);
}

TEST(PilotInput, IsReadStrictly) {
    std::string const good = replayText({calmPlan(), 480, hands()});
    EXPECT_NE(refusal(good, "\"lever\":0.25", "\"lever\":2").find("inputs[0].lever: expected a number 0..1, found 2"),
              std::string::npos);
    EXPECT_NE(refusal(good, "\"mouse\":[", "\"mouse\":[0.1,").find("inputs[1].mouse: expected a list of 2"),
              std::string::npos);
}

TEST(PilotInput, FliesTheSameFlightAgainAndTrimActsInLight) {
    auto const flown = [](std::vector<StampedInput> script) {
        SessionOptions options = tests::flying(calmPlan(), std::move(script));
        options.plan.weatherSha256 =
            World{options.plan.weather, options.plan.place, 1, 0.0}.field().origin().sha256;
        Session session{options};
        tests::fly(session, 4.0);
        return std::pair{session.report().stateHashes,
                         session.simulation().aircraft().state().commands.elevator};
    };
    auto const once = flown(hands()), again = flown(hands());
    EXPECT_EQ(once.first, again.first);
    std::vector<StampedInput> untrimmed = hands();
    untrimmed.back().what = ui::InputSample{};
    auto const other = flown(untrimmed);
    EXPECT_GT(once.second, other.second + 0.2) << "nose up by the wheel";
    EXPECT_NE(once.first.back(), other.first.back());
}
}  // namespace
