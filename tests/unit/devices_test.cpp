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
    Bindings bindings;
    MouseSettings mouse;

    DeviceReading read(bool wantsText = false, bool wantsPointer = false) {
        Listeners const others{wantsText, wantsPointer, mouse.flight};
        DeviceReading const reading = devices.read(input, bindings, mouse, others, core::kTickSeconds, 720.0f);
        input.keys.clear(), input.mouseButtons.clear();
        input.scrolled = glm::dvec2{0.0}, input.mouseMoved = glm::dvec2{0.0};
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
        {Key::f5, Command::photo},    {Key::f6, Command::studio},  {Key::v, Command::air},        {Key::escape, Command::escape},
        {Key::n, Command::hudDensity}, {Key::m, Command::mouseFlight}};
    EXPECT_EQ(std::size(table) + 1, static_cast<std::size_t>(Command::count)) << "and one of the mouse's";
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
    CameraInput const menu = Pilot{pilot}.read(false, true).camera, free = pilot.read().camera;
    EXPECT_EQ(free.move, (glm::dvec3{1.0, 0.0, -1.0}));
    EXPECT_GT(free.look.x, 0.0);
    EXPECT_GT(free.look.y, 0.0);
    EXPECT_EQ(free.zoom, 2.0);
    EXPECT_EQ(menu.look, glm::dvec2{0.0});
    EXPECT_EQ(menu.zoom, 0.0);
}

TEST(Keys, TrimWhileTheyAreHeldAndStayUntilNeutral) {
    Pilot pilot;
    EXPECT_NEAR(pilot.hold(Key::pageDown).fly(1.0).elevatorTrim, 0.25, 1.0e-9) << "nose up";
    EXPECT_NEAR(pilot.release().fly(1.0).elevatorTrim, 0.25, 1.0e-9);
    EXPECT_NEAR(pilot.hold(Key::pageUp).fly(2.0).elevatorTrim, -0.25, 1.0e-9);
    EXPECT_NEAR(pilot.release().hold(Key::period).fly(9.0).rudderTrim, 1.0, 1.0e-9) << "and no further";
    flight::Controls const neutral = pilot.release().hold(Key::home).fly(0.1);
    EXPECT_EQ(neutral.elevatorTrim, 0.0);
    EXPECT_EQ(neutral.rudderTrim, 0.0);
}

TEST(Keys, MoveTheThrottleByATenthAPress) {
    Pilot pilot;
    EXPECT_NEAR(pilot.hold(Key::equal).fly(1.0).throttle, 0.1, 1.0e-9);
    pilot.release().fly(0.1);
    EXPECT_NEAR(pilot.hold(Key::keypadAdd).fly(0.1).throttle, 0.2, 1.0e-9);
    EXPECT_NEAR(pilot.release().hold(Key::minus).fly(0.1).throttle, 0.1, 1.0e-9);
}

TEST(Keys, ChooseACameraEach) {
    std::pair<Key, CameraMode> const table[]{{Key::digit1, CameraMode::chase}, {Key::digit2, CameraMode::cockpit}, {Key::digit3, CameraMode::wing},
                                             {Key::digit4, CameraMode::hatch}, {Key::digit5, CameraMode::tower},   {Key::digit6, CameraMode::free}};
    for (auto const& [key, mode] : table) {
        Pilot pilot;
        EXPECT_EQ(pilot.hold(key).read().mode, mode);
        EXPECT_FALSE(pilot.read().mode) << "held";
    }
}

TEST(Keys, DoWhatTheyAreBoundTo) {
    Pilot pilot;
    pilot.bindings.actions[actionOf(FlightKey::rollLeft)] = *parseTriggers("x mouse.back wheel.down joy2.button3");
    EXPECT_FALSE(pilot.hold(Key::a).read().flight.held(FlightKey::rollLeft));
    EXPECT_TRUE(pilot.release().hold(Key::x).read().flight.held(FlightKey::rollLeft));
    pilot.release().input.mouseButtons = {{platform::MouseButton::back, true}, {platform::MouseButton::back, false}};
    EXPECT_TRUE(pilot.read().flight.held(FlightKey::rollLeft)) << "clicked within one frame";
    EXPECT_FALSE(pilot.read().flight.held(FlightKey::rollLeft));
    pilot.input.scrolled = {0.0, -1.0};
    EXPECT_TRUE(pilot.read().flight.held(FlightKey::rollLeft));
    pilot.release().input.joysticks = {{0, "stick", {}, {true, true, true}}, {1, "throttle", {}, {false, false, true}}};
    EXPECT_TRUE(pilot.read().flight.held(FlightKey::rollLeft));
    pilot.input.joysticks[1].buttons[2] = false;
    EXPECT_FALSE(pilot.read().flight.held(FlightKey::rollLeft));
}

TEST(Joystick, FliesWithoutAnyMappingAndItsLeverActsWhenItMoves) {
    Pilot pilot;
    pilot.input.joysticks = {{3, "old stick", {0.0f, 1.0f, -1.0f, 1.0f}, {}}};
    pilot.stick.begin(0.6);
    flight::Controls const first = pilot.fly(0.1);
    EXPECT_NEAR(first.elevator, 1.0, 1.0e-9) << "pulled: nose up";
    EXPECT_NEAR(first.rudder, -1.0, 1.0e-9);
    EXPECT_EQ(first.throttle, 0.6) << "the lever has not been touched";
    pilot.input.joysticks[0].axes[3] = 0.995f;
    EXPECT_EQ(pilot.fly(0.1).throttle, 0.6) << "a tremble";
    pilot.input.joysticks[0].axes[3] = -0.5f;  // forward is negative
    EXPECT_NEAR(pilot.fly(0.1).throttle, 0.75, 1.0e-6);
    EXPECT_LT(pilot.hold(Key::s).fly(0.5).throttle, 0.6) << "keys act beside it";
}

TEST(Joystick, IsToldWhenItComesAndGoes) {
    Pilot pilot;
    pilot.read();
    EXPECT_TRUE(pilot.devices.takeNews().empty());
    pilot.pad().name = "Pad";
    pilot.read();
    EXPECT_EQ(pilot.devices.takeNews(), std::vector<std::string>{"Connected: Pad"});
    pilot.release().input.joysticks = {{0, "Pedals", {}, {}}};
    pilot.read();
    EXPECT_EQ(pilot.devices.takeNews(), (std::vector<std::string>{"Connected: Pedals", "Unplugged: Pad"}));
    pilot.read();
    EXPECT_TRUE(pilot.devices.takeNews().empty());
}

TEST(Mouse, MovesTheStickAndLeavesItThereWhereThePlayerWantsThat) {
    Pilot pilot;
    pilot.input.mouseMoved = {90.0, 45.0};
    EXPECT_FALSE(pilot.read().flight.mouse) << "not asked for";
    pilot.mouse.flight = true;
    pilot.input.mouseMoved = {90.0, 45.0};  // half and a quarter of a quarter of 720 pixels
    flight::Controls const pulled = pilot.fly(0.1);
    EXPECT_NEAR(pulled.aileron, 0.5, 1.0e-6);
    EXPECT_NEAR(pulled.elevator, 0.25, 1.0e-6);
    EXPECT_NEAR(pilot.fly(1.0).aileron, 0.5, 1.0e-6);
    EXPECT_NEAR(pilot.hold(Key::a).fly(1.0).aileron, -1.0, 1.0e-6) << "keys go before";
    pilot.release().input.mouseHeld[static_cast<std::size_t>(platform::MouseButton::right)] = true;
    pilot.input.mouseMoved = {90.0, 0.0};
    EXPECT_GT(pilot.read().camera.look.x, 0.0);
    EXPECT_NEAR(pilot.release().fly(0.1).aileron, 0.5, 1.0e-6) << "it looked around";
    pilot.input.mouseButtons = {{platform::MouseButton::middle, true}};
    EXPECT_EQ(pilot.read().flight.mouse, MouseStick{}) << "centred";
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
    EXPECT_EQ(pilot.devices.firstPrompts(pilot.bindings).front().cap, "L-stick \u2190\u2192");
    pilot.release().hold(Key::a).read();
    EXPECT_FALSE(pilot.devices.gamepadInHand());
    EXPECT_NE(pilot.devices.firstPrompts(pilot.bindings).front().cap, "L-stick \u2190\u2192");
}
}  // namespace
