// Keys, gamepad and input file become the stick, tick by tick.
#include "game/ui/input.h"

#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/core/frames.h"
#include "game/ui/input_csv.h"

namespace {
using namespace luftpost;
using namespace luftpost::ui;

/// Holds the keys for so many seconds; the last action.
Stick::Action hold(Stick& stick, std::initializer_list<FlightKey> keys, double seconds) {
    InputSample sample;
    for (FlightKey key : keys) sample.hold(key);
    Stick::Action action;
    for (int tick = 0; tick < static_cast<int>(seconds * core::kTicksPerSecond + 0.5); ++tick)
        action = stick.step(sample, {});
    return action;
}

TEST(Stick, MovesTheLeverInTwoSecondsAndLeavesItThere) {
    Stick stick;
    EXPECT_NEAR(hold(stick, {FlightKey::thrustUp}, 1.0).controls.throttle, 0.5, 0.01);
    EXPECT_NEAR(hold(stick, {}, 3.0).controls.throttle, 0.5, 0.01);
    EXPECT_EQ(hold(stick, {FlightKey::thrustUp}, 1.1).controls.throttle, 1.0);
    EXPECT_EQ(hold(stick, {FlightKey::thrustDown}, 2.1).controls.throttle, 0.0);
}

TEST(Stick, GoesToFullDeflectionUnderAKeyAndSpringsBack) {
    Stick stick;
    EXPECT_EQ(
        hold(stick, {FlightKey::rollRight, FlightKey::noseUp, FlightKey::yawLeft}, 0.4).controls.aileron,
        1.0);
    EXPECT_EQ(stick.controls().elevator, 1.0);
    EXPECT_EQ(stick.controls().rudder, -1.0);
    EXPECT_EQ(hold(stick, {}, 0.3).controls.aileron, 0.0);
}

TEST(Stick, CutsTheCentreOutOfAGamepadAndKeepsItsEnds) {
    Stick stick;
    InputSample sample;
    sample.pad.roll = 0.1f;
    sample.pad.pitch = 1.0f;
    EXPECT_EQ(stick.step(sample, {}).controls.aileron, 0.0);
    EXPECT_NEAR(stick.controls().elevator, 1.0, 1.0e-9);
}

TEST(Stick, TakesDeadZoneAndCurveOfEachAxis) {
    Stick stick;
    InputSample sample;
    sample.pad.roll = 0.6f, sample.pad.yaw = 0.6f, sample.pad.brakes = 0.6f;
    InputSettings settings;
    settings.rollDeadZone = 0.2, settings.rollCurve = 2.0;
    settings.yawDeadZone = 0.0, settings.yawCurve = 1.0;
    flight::Controls const controls = stick.step(sample, settings).controls;
    EXPECT_NEAR(controls.aileron, 0.25, 1.0e-6);
    EXPECT_NEAR(controls.rudder, 0.6, 1.0e-6);
    EXPECT_NEAR(controls.brakes, 0.55 / 0.95, 1.0e-6);
}

TEST(Stick, MovesFlapsByNotchesAndDropsOnceAPress) {
    Stick stick;
    EXPECT_NEAR(hold(stick, {FlightKey::flapsDown}, 0.5).controls.flaps, 1.0 / 3.0, 1.0e-9);
    hold(stick, {}, 0.1);
    EXPECT_NEAR(hold(stick, {FlightKey::flapsDown}, 0.1).controls.flaps, 2.0 / 3.0, 1.0e-9);
    hold(stick, {}, 0.1);
    EXPECT_NEAR(hold(stick, {FlightKey::flapsUp}, 0.1).controls.flaps, 1.0 / 3.0, 1.0e-9);
    InputSample sample;
    sample.hold(FlightKey::drop);
    EXPECT_TRUE(stick.step(sample, {}).drop);
    EXPECT_FALSE(stick.step(sample, {}).drop);
}

TEST(Stick, RespawnsOnceAfterTheKeyWasHeldForLongEnough) {
    Stick stick;
    InputSample sample;
    sample.hold(FlightKey::respawn);
    int asked = 0, firstTick = 0;
    for (int tick = 1; tick <= 480; ++tick)
        if (stick.step(sample, {}).respawn && ++asked == 1) firstTick = tick;
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(firstTick, 168);
}

constexpr char const* kHeader = "t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop\n";

TEST(InputFile, ActsFromTheTickAtOrAfterItsTimeAndKeepsEmptyCells) {
    auto const samples =
        parseInputCsv(std::string{kHeader} + "0,0.5,,0.25,,,,\n0.1,,-1,,,,,1\n2.0021,,,,,,,0\n", "in.csv");
    ASSERT_EQ(samples.size(), 3u);
    EXPECT_EQ(samples[0].tick, 0);
    EXPECT_EQ(samples[1].tick, 24);
    EXPECT_EQ(samples[2].tick, 481);
    EXPECT_EQ(samples[1].sample.direct->throttle, 0.5);
    EXPECT_EQ(samples[1].sample.direct->elevator, -1.0);
    EXPECT_EQ(samples[1].sample.direct->aileron, 0.25);
    EXPECT_TRUE(samples[1].sample.held(FlightKey::drop));
    EXPECT_FALSE(samples[2].sample.held(FlightKey::drop));
}

TEST(InputFile, LeavesTheLeverWhereTheStartPutItUntilAThrottleIsNamed) {
    Stick stick;
    stick.begin(0.6);
    stick.step(parseInputCsv(std::string{kHeader} + "0,,0.1,,,,,\n", "in.csv")[0].sample, {});
    EXPECT_EQ(stick.controls().throttle, 0.6);
}

TEST(InputFile, NamesFileRowColumnAndExpectation) {
    auto const complaint = [](std::string const& text) -> std::string {
        try {
            parseInputCsv(text, "in.csv");
        } catch (core::Error const& error) {
            return error.what();
        }
        return "";
    };
    std::string const header{kHeader};
    EXPECT_EQ(complaint(header + "0,0,0,0,0,0,0,0\n1,0,2,0,0,0,0,0\n"),
              "in.csv:3: elevator: expected a number -1..1, found 2");
    EXPECT_EQ(complaint(header + "0,abc,0,0,0,0,0,0\n"),
              "in.csv:2: throttle: expected a number 0..1, found abc");
    EXPECT_EQ(complaint(header + "0,0,0\n"), "in.csv:2: expected 8 columns, found 3");
    EXPECT_EQ(complaint(header + "2,,,,,,,\n1,,,,,,,\n"),
              "in.csv:3: t_s: expected a time not before 2, found 1");
    EXPECT_EQ(complaint(header + ",,,,,,,\n"), "in.csv:2: t_s: expected a number 0..1000000, found nothing");
    EXPECT_NE(complaint("t,throttle\n").find("in.csv:1: header: expected t_s,throttle"), std::string::npos);
    EXPECT_NE(complaint("").find("in.csv:1: header"), std::string::npos);
    EXPECT_NE(complaint(header + "0,nan,,,,,,\n").find("throttle"), std::string::npos);
}
}  // namespace
