#include "game/ui/devices.h"

#include <algorithm>
#include <cmath>

namespace luftpost::ui {
namespace {
using platform::Key;
using platform::PadAxis;
using platform::PadButton;

struct FlightBinding {
    Key key;
    FlightKey action;
};
constexpr FlightBinding kFlightKeys[]{
    {Key::w, FlightKey::thrustUp},  {Key::s, FlightKey::thrustDown},  {Key::a, FlightKey::rollLeft},
    {Key::d, FlightKey::rollRight}, {Key::left, FlightKey::rollLeft}, {Key::right, FlightKey::rollRight},
    {Key::up, FlightKey::noseDown}, {Key::down, FlightKey::noseUp},   {Key::q, FlightKey::yawLeft},
    {Key::e, FlightKey::yawRight},  {Key::b, FlightKey::brakes},      {Key::space, FlightKey::drop},
    {Key::r, FlightKey::respawn},   {Key::t, FlightKey::autopilot}};

struct PadBinding {
    PadButton button;
    FlightKey action;
};
constexpr PadBinding kFlightButtons[]{
    {PadButton::south, FlightKey::drop},         {PadButton::east, FlightKey::brakes},
    {PadButton::west, FlightKey::flapsDown},     {PadButton::north, FlightKey::flapsUp},
    {PadButton::leftBumper, FlightKey::yawLeft}, {PadButton::rightBumper, FlightKey::yawRight},
    {PadButton::leftThumb, FlightKey::respawn}};

struct CommandBinding {
    Key key;
    Command command;
};
constexpr CommandBinding kCommandKeys[]{
    {Key::c, Command::camera},    {Key::p, Command::pause},      {Key::f1, Command::config},
    {Key::f2, Command::normals},  {Key::f3, Command::wireframe}, {Key::f11, Command::fullScreen},
    {Key::f12, Command::picture}, {Key::h, Command::keys},       {Key::f4, Command::weather},
    {Key::f5, Command::photo},    {Key::v, Command::air},        {Key::escape, Command::escape}};
/// These work while a text box has the focus, too.
bool isFunctionKey(Key key) { return key == Key::escape || (key >= Key::f1 && key <= Key::f12); }

void press(DeviceReading& reading, Command command) {
    reading.commands |= 1u << static_cast<unsigned>(command);
}

/// Held, or tapped between this frame and the last: no frame is so slow that it loses a drop.
bool isDown(platform::Input const& input, Key key) {
    auto const tapped = [key](platform::KeyEvent const& event) { return event.key == key && event.pressed; };
    return input.isHeld(key) || std::any_of(input.keys.begin(), input.keys.end(), tapped);
}

void readFlightKeys(platform::Input const& input, InputSample& sample) {
    for (FlightBinding const& binding : kFlightKeys)
        if (isDown(input, binding.key)) sample.hold(binding.action);
    bool const shift = isDown(input, Key::leftShift) || isDown(input, Key::rightShift);
    if (isDown(input, Key::f)) sample.hold(shift ? FlightKey::flapsUp : FlightKey::flapsDown);
}

void readCommands(platform::Input const& input, bool wantsText, DeviceReading& reading) {
    for (platform::KeyEvent const& event : input.keys) {
        if (!event.pressed || event.repeat || (wantsText && !isFunctionKey(event.key))) continue;
        for (CommandBinding const& binding : kCommandKeys)
            if (binding.key == event.key) press(reading, binding.command);
    }
}

/// The free camera moves with I J K L U O; the right button looks around; the wheel comes nearer.
void readCamera(platform::Input const& input, bool wantsText, bool wantsPointer, CameraInput& camera) {
    constexpr double kRadiansPerPixel = 0.004;
    auto const pair = [&](Key less, Key more) {
        return (input.isHeld(more) ? 1.0 : 0.0) - (input.isHeld(less) ? 1.0 : 0.0);
    };
    if (!wantsText) camera.move = {pair(Key::j, Key::l), pair(Key::u, Key::o), pair(Key::i, Key::k)};
    camera.fast = input.isHeld(Key::leftShift);
    if (wantsPointer) return;
    if (input.mouseHeld[static_cast<std::size_t>(platform::MouseButton::right)])
        camera.look = glm::dvec2{input.mouseMoved.x, -input.mouseMoved.y} * kRadiansPerPixel;
    camera.zoom = input.scrolled.y;
}

void larger(float& value, float other) {
    if (std::abs(other) > std::abs(value)) value = other;
}
}  // namespace

DeviceReading Devices::read(platform::Input const& input, bool wantsText, bool wantsPointer, double seconds) {
    DeviceReading reading;
    if (!input.keys.empty()) gamepadInHand_ = false;
    if (!wantsText && input.focused) readFlightKeys(input, reading.flight);
    readCommands(input, wantsText, reading);
    readCamera(input, wantsText, wantsPointer, reading.camera);
    readPads(input, reading, seconds);
    return reading;
}

void Devices::readPads(platform::Input const& input, DeviceReading& reading, double seconds) {
    constexpr double kLookRate = 2.0;  // rad/s
    constexpr float kTouched = 0.35f;
    std::array<bool, platform::kPadButtons> now{};
    for (platform::Gamepad const& pad : input.gamepads) {
        PadAxes& axes = reading.flight.pad;
        larger(axes.roll, pad.axis(PadAxis::leftX));
        larger(axes.pitch, pad.axis(PadAxis::leftY));  // pulled toward the player: nose up
        larger(axes.thrust, pad.axis(PadAxis::rightTrigger) - pad.axis(PadAxis::leftTrigger));
        glm::dvec2 const look{pad.axis(PadAxis::rightX), -pad.axis(PadAxis::rightY)};
        if (std::max(std::abs(look.x), std::abs(look.y)) > 0.15)
            reading.camera.look += look * kLookRate * seconds;
        for (PadBinding const& binding : kFlightButtons)
            if (pad.button(binding.button)) reading.flight.hold(binding.action);
        for (std::size_t i = 0; i < now.size(); ++i) now[i] = now[i] || pad.buttons[i];
        if (std::max({std::abs(axes.roll), std::abs(axes.pitch), std::abs(axes.thrust)}) > kTouched)
            gamepadInHand_ = true;
    }
    auto const went = [&](PadButton button) {
        return now[static_cast<std::size_t>(button)] && !padBefore_[static_cast<std::size_t>(button)];
    };
    if (went(PadButton::back)) press(reading, Command::camera);
    if (went(PadButton::start)) press(reading, Command::escape);
    if (went(PadButton::dpadUp)) press(reading, Command::config);
    if (went(PadButton::dpadDown)) press(reading, Command::keys);
    padBefore_ = now;
}

std::vector<HudPrompt> Devices::firstPrompts() const {
    using platform::keyLabel;
    if (gamepadInHand_)
        return {{"Left stick", "steer"}, {"RT LT", "thrust"}, {"A", "drop the parcel"}, {"Start", "menu"}};
    return {{keyLabel(Key::a) + " " + keyLabel(Key::d), "roll"},
            {keyLabel(Key::down) + " " + keyLabel(Key::up), "nose up, down"},
            {keyLabel(Key::w) + " " + keyLabel(Key::s), "thrust"},
            {keyLabel(Key::space), "drop the parcel"},
            {keyLabel(Key::h), "all keys"}};
}

std::vector<KeyHelp> keyHelp() {
    auto const k = [](Key key) { return platform::keyLabel(key); };
    return {
        {"Flight", k(Key::w) + " " + k(Key::s), "RT LT", "thrust more, less"},
        {"Flight", k(Key::a) + " " + k(Key::d) + " " + k(Key::left) + " " + k(Key::right), "left stick",
         "roll"},
        {"Flight", k(Key::down) + " " + k(Key::up), "left stick", "nose up, down"},
        {"Flight", k(Key::q) + " " + k(Key::e), "LB RB", "yaw"},
        {"Flight", k(Key::space), "A", "drop the parcel"},
        {"Flight", k(Key::f) + " Shift+" + k(Key::f), "X, Y", "flaps down, up"},
        {"Flight", k(Key::b), "B", "brakes"},
        {"Flight", k(Key::t), "", "autopilot: on; the stick takes over"},
        {"Flight", k(Key::r) + " held", "left stick down", "start again in the air here"},
        {"View", k(Key::c), "Back", "camera: chase, cockpit, free"},
        {"View", "", "", "and the parcel's, while it falls"},
        {"View", "right mouse", "right stick", "look around"},
        {"View",
         k(Key::i) + " " + k(Key::j) + " " + k(Key::k) + " " + k(Key::l) + " " + k(Key::u) + " " + k(Key::o),
         "", "move the free camera"},
        {"View", k(Key::v), "", "show the air: wind, lift and sink"},
        {"View", k(Key::f5), "", "photograph: over, split, beside, off"},
        {"View", k(Key::f2), "", "show normals"},
        {"View", k(Key::f3), "", "show the wireframe"},
        {"View", k(Key::f11), "", "full screen"},
        {"View", k(Key::f12), "", "take a picture"},
        {"Game", k(Key::p), "", "pause"},
        {"Game", k(Key::f1), "D-pad up", "settings"},
        {"Game", k(Key::f4), "", "weather"},
        {"Game", k(Key::h), "D-pad down", "this page"},
        {"Game", k(Key::escape), "Start", "close a page, else the menu"}};
}
}  // namespace luftpost::ui
