// Keys and gamepad of the key table in README.md, from what a window tells to what the pilot's hands do.
#include "game/ui/devices.h"

#include <gtest/gtest.h>

#include "engine/core/frames.h"

namespace {
using namespace luftpost;
using namespace luftpost::ui;
using platform::Key;
using platform::PadAxis;
using platform::PadButton;

/// A pilot at the devices: what is held stays held until `release`.
struct Pilot {
    platform::Input input;
    Devices devices;
    Stick stick;
    int drops = 0, respawns = 0;

    Pilot& hold(Key key) {
        input.held[static_cast<std::size_t>(key)] = true;
        input.keys.push_back({.key = key, .pressed = true});
        return *this;
    }
    Pilot& release() {
        input = {};
        return *this;
    }
    platform::Gamepad& pad() {
        if (input.gamepads.empty()) input.gamepads.emplace_back();
        return input.gamepads.front();
    }
    Pilot& push(PadAxis axis, float value) {
        pad().axes[static_cast<std::size_t>(axis)] = value;
        return *this;
    }
    Pilot& press(PadButton button) {
        pad().buttons[static_cast<std::size_t>(button)] = true;
        return *this;
    }
    DeviceReading read(bool wantsText = false, bool wantsPointer = false) {
        DeviceReading const reading = devices.read(input, wantsText, wantsPointer, core::kTickSeconds);
        input.keys.clear();
        return reading;
    }
    flight::Controls fly(double seconds, bool wantsText = false) {
        for (int tick = 0; tick < static_cast<int>(seconds * core::kTicksPerSecond + 0.5); ++tick) {
            Stick::Action const action = stick.step(read(wantsText).flight, {});
            drops += action.drop ? 1 : 0;
            respawns += action.respawn ? 1 : 0;
        }
        return stick.controls();
    }
};

unsigned bit(Command command) { return 1u << static_cast<unsigned>(command); }

TEST(Keys, ThatAreTappedWithinOneFrameAct) {
    Pilot pilot;
    for (Key key : {Key::space, Key::leftShift, Key::f}) {
        pilot.input.keys.push_back({.key = key, .pressed = true});
        pilot.input.keys.push_back({.key = key, .pressed = false});
    }
    InputSample const sample = pilot.read().flight;
    EXPECT_TRUE(sample.held(FlightKey::drop));
    EXPECT_TRUE(sample.held(FlightKey::flapsUp));
    EXPECT_EQ(pilot.read().flight.keys, 0u) << "and no longer";
}

TEST(Keys, WAndSMoveTheLeverThroughItsTravelInTwoSeconds) {
    Pilot pilot;
    EXPECT_NEAR(pilot.hold(Key::w).fly(1.0).throttle, 0.5, 1.0e-9);
    EXPECT_LT(pilot.fly(0.95).throttle, 1.0);
    EXPECT_NEAR(pilot.fly(0.05).throttle, 1.0, 1.0e-9);
    EXPECT_NEAR(pilot.release().fly(1.0).throttle, 1.0, 1.0e-9) << "the lever stays";
    EXPECT_NEAR(pilot.hold(Key::s).fly(1.5).throttle, 0.25, 1.0e-9);
    EXPECT_NEAR(pilot.fly(0.5).throttle, 0.0, 1.0e-9);
}

TEST(Keys, MoveTheStickTheWayTheyPoint) {
    auto const after = [](Key key) { return Pilot{}.hold(key).fly(0.5); };
    for (Key left : {Key::a, Key::left}) EXPECT_EQ(after(left).aileron, -1.0);
    for (Key right : {Key::d, Key::right}) EXPECT_EQ(after(right).aileron, 1.0);
    EXPECT_EQ(after(Key::up).elevator, -1.0) << "nose down";
    EXPECT_EQ(after(Key::down).elevator, 1.0) << "nose up";
    EXPECT_EQ(after(Key::q).rudder, -1.0);
    EXPECT_EQ(after(Key::e).rudder, 1.0);
    flight::Controls const rolling = after(Key::a);
    EXPECT_EQ(rolling.elevator, 0.0);
    EXPECT_EQ(rolling.rudder, 0.0);
    EXPECT_EQ(rolling.throttle, 0.0);
}

TEST(Keys, SpaceDropsOnceHoweverLongItIsHeld) {
    Pilot pilot;
    pilot.hold(Key::space).fly(1.0);
    EXPECT_EQ(pilot.drops, 1);
    pilot.release().fly(0.1);
    pilot.hold(Key::space).fly(0.1);
    EXPECT_EQ(pilot.drops, 2);
}

TEST(Keys, FLowersTheFlapsByANotchAndShiftFRaisesThem) {
    Pilot pilot;
    EXPECT_NEAR(pilot.hold(Key::f).fly(1.0).flaps, 1.0 / 3.0, 1.0e-9);
    pilot.release().fly(0.1);
    EXPECT_NEAR(pilot.hold(Key::f).fly(0.1).flaps, 2.0 / 3.0, 1.0e-9);
    for (Key shift : {Key::leftShift, Key::rightShift}) {
        double const before = pilot.release().fly(0.1).flaps;
        EXPECT_NEAR(pilot.hold(shift).hold(Key::f).fly(0.1).flaps, before - 1.0 / 3.0, 1.0e-9);
    }
}

TEST(Keys, BBrakesWhileItIsHeld) {
    Pilot pilot;
    EXPECT_EQ(pilot.hold(Key::b).fly(0.1).brakes, 1.0);
    EXPECT_EQ(pilot.release().fly(0.1).brakes, 0.0);
}

TEST(Keys, RRespawnsAfterSevenTenthsOfASecond) {
    Pilot pilot;
    pilot.hold(Key::r).fly(0.68);
    EXPECT_EQ(pilot.respawns, 0);
    pilot.release().fly(0.1);
    pilot.hold(Key::r).fly(0.68);
    EXPECT_EQ(pilot.respawns, 0) << "released in between";
    pilot.fly(0.04);
    EXPECT_EQ(pilot.respawns, 1);
    pilot.fly(2.0);
    EXPECT_EQ(pilot.respawns, 1);
}

TEST(Keys, GiveTheirCommandOnceAPress) {
    std::pair<Key, Command> const table[]{
        {Key::c, Command::camera},    {Key::p, Command::pause},      {Key::f1, Command::config},
        {Key::f2, Command::normals},  {Key::f3, Command::wireframe}, {Key::f11, Command::fullScreen},
        {Key::f12, Command::picture}, {Key::h, Command::keys},       {Key::f4, Command::weather},
        {Key::f5, Command::photo},    {Key::f6, Command::studio},     {Key::v, Command::air},
        {Key::escape, Command::escape}};
    EXPECT_EQ(std::size(table), static_cast<std::size_t>(Command::count));
    for (auto const& [key, command] : table) {
        Pilot pilot;
        DeviceReading const reading = pilot.hold(key).read();
        EXPECT_EQ(reading.commands, bit(command)) << platform::keyToken(key);
        EXPECT_EQ(reading.flight, InputSample{}) << platform::keyToken(key);
        pilot.input.keys.push_back({.key = key, .pressed = true, .repeat = true});
        EXPECT_EQ(pilot.read().commands, 0u) << "repeated " << platform::keyToken(key);
        pilot.input.keys.push_back({.key = key, .pressed = false});
        EXPECT_EQ(pilot.read().commands, 0u) << "released " << platform::keyToken(key);
    }
}

TEST(Keys, AreTextWhileATextBoxHasTheFocus) {
    Pilot pilot;
    for (Key key : {Key::w, Key::d, Key::down, Key::e, Key::b, Key::f, Key::space, Key::r}) pilot.hold(key);
    flight::Controls const still = pilot.fly(1.0, true);
    EXPECT_EQ(still.throttle, 0.0);
    EXPECT_EQ(still.aileron, 0.0);
    EXPECT_EQ(still.elevator, 0.0);
    EXPECT_EQ(still.rudder, 0.0);
    EXPECT_EQ(still.brakes, 0.0);
    EXPECT_EQ(still.flaps, 0.0);
    EXPECT_EQ(pilot.drops + pilot.respawns, 0);
    for (Key key : {Key::c, Key::p, Key::h, Key::l}) pilot.hold(key);
    DeviceReading const typed = pilot.read(true);
    EXPECT_EQ(typed.commands, 0u);
    EXPECT_EQ(typed.camera.move, glm::dvec3{0.0});
    pilot.hold(Key::escape).hold(Key::f1);
    EXPECT_EQ(pilot.read(true).commands, bit(Command::escape) | bit(Command::config));
}

TEST(Keys, FlyNothingWhileAnotherWindowHasTheFocus) {
    Pilot pilot;
    pilot.hold(Key::w).hold(Key::d).input.focused = false;
    EXPECT_EQ(pilot.read().flight, InputSample{});
}

TEST(Keys, MoveTheFreeCameraAndTheMouseLooksAroundButNotOverAMenu) {
    Pilot pilot;
    pilot.hold(Key::l).hold(Key::i);
    pilot.input.mouseHeld[static_cast<std::size_t>(platform::MouseButton::right)] = true;
    pilot.input.mouseMoved = {10.0, -5.0};
    pilot.input.scrolled = {0.0, 2.0};
    CameraInput const free = pilot.read().camera, menu = pilot.read(false, true).camera;
    EXPECT_EQ(free.move, (glm::dvec3{1.0, 0.0, -1.0}));
    EXPECT_GT(free.look.x, 0.0);
    EXPECT_GT(free.look.y, 0.0);
    EXPECT_EQ(free.zoom, 2.0);
    EXPECT_EQ(menu.look, glm::dvec2{0.0});
    EXPECT_EQ(menu.zoom, 0.0);
}

TEST(Pad, SteersWithTheLeftStickAndTheTriggers) {
    Pilot pilot;
    flight::Controls const controls =
        pilot.push(PadAxis::leftX, -1.0f).push(PadAxis::leftY, 1.0f).push(PadAxis::rightTrigger, 1.0f).fly(1.0);
    EXPECT_NEAR(controls.aileron, -1.0, 1.0e-9);
    EXPECT_NEAR(controls.elevator, 1.0, 1.0e-9) << "pulled: nose up";
    EXPECT_NEAR(controls.throttle, 0.5, 1.0e-9);
    EXPECT_NEAR(pilot.release().push(PadAxis::leftTrigger, 1.0f).fly(0.5).throttle, 0.25, 1.0e-9);
}

TEST(Pad, HasAButtonForEveryAction) {
    Pilot pilot;
    pilot.press(PadButton::south).press(PadButton::leftThumb).fly(0.71);
    EXPECT_EQ(pilot.drops, 1);
    EXPECT_EQ(pilot.respawns, 1);
    auto const after = [](PadButton button) { return Pilot{}.press(button).fly(0.5); };
    EXPECT_EQ(after(PadButton::east).brakes, 1.0);
    EXPECT_EQ(after(PadButton::leftBumper).rudder, -1.0);
    EXPECT_EQ(after(PadButton::rightBumper).rudder, 1.0);
    Pilot flaps;
    EXPECT_NEAR(flaps.press(PadButton::west).fly(0.2).flaps, 1.0 / 3.0, 1.0e-9);
    EXPECT_NEAR(flaps.release().press(PadButton::north).fly(0.2).flaps, 0.0, 1.0e-9);
}

TEST(Pad, GivesItsCommandsOnceAPress) {
    std::pair<PadButton, Command> const table[]{{PadButton::back, Command::camera},
                                                {PadButton::start, Command::escape},
                                                {PadButton::dpadUp, Command::config},
                                                {PadButton::dpadDown, Command::keys}};
    for (auto const& [button, command] : table) {
        Pilot pilot;
        EXPECT_EQ(pilot.press(button).read().commands, bit(command));
        EXPECT_EQ(pilot.read().commands, 0u) << "held";
        pilot.release().read();
        EXPECT_EQ(pilot.press(button).read().commands, bit(command)) << "pressed again";
    }
}

TEST(Pad, IsInHandFromItsFirstTouchToTheNextKey) {
    Pilot pilot;
    EXPECT_FALSE(pilot.devices.gamepadInHand());
    pilot.push(PadAxis::leftX, 0.1f).read();
    EXPECT_FALSE(pilot.devices.gamepadInHand()) << "a stick that does not quite return";
    pilot.push(PadAxis::leftX, 0.8f).read();
    EXPECT_TRUE(pilot.devices.gamepadInHand());
    EXPECT_EQ(pilot.devices.firstPrompts().front().cap, "Left stick");
    pilot.release().hold(Key::a).read();
    EXPECT_FALSE(pilot.devices.gamepadInHand());
    EXPECT_NE(pilot.devices.firstPrompts().front().cap, "Left stick");
}
}  // namespace
