#include "game/ui/devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace luftpost::ui {
namespace {
using platform::Input;
using platform::Key;

bool isFunctionKey(Trigger const& trigger) {
    auto const key = static_cast<Key>(trigger.code);
    return key == Key::escape || (key >= Key::f1 && key <= Key::f12);
}

/// Whoever writes or points in a menu does not fly with the same keys and buttons.
bool isTakenElsewhere(Trigger const& trigger, Listeners const& others) {
    bool const mouse = trigger.kind == Trigger::Kind::mouse || trigger.kind == Trigger::Kind::wheel;
    return (others.text && trigger.kind == Trigger::Kind::key && !isFunctionKey(trigger)) ||
           (others.pointer && mouse);
}

/// A key with Shift held is not the plain key where both are bound: Shift+F raises the flaps and does not
/// lower them.
bool isMeantOtherwise(Trigger const& plain, Bindings const& bindings, Input const& input) {
    if (plain.kind != Trigger::Kind::key || plain.shift || plain.control || plain.alt) return false;
    auto const chordIsDown = [&](Trigger const& t) {
        return t.kind == Trigger::Kind::key && t.code == plain.code && t != plain && isDown(t, input);
    };
    return std::any_of(bindings.actions.begin(), bindings.actions.end(), [&](Triggers const& triggers) {
        return std::any_of(triggers.begin(), triggers.end(), chordIsDown);
    });
}

/// A hand's way on several devices adds up.
float axisSum(Triggers const& triggers, Input const& input) {
    float sum = 0.0f;
    for (Trigger const& trigger : triggers) sum += axisValue(trigger, input);
    return std::clamp(sum, -1.0f, 1.0f);
}

std::optional<float> leverOf(Triggers const& triggers, Input const& input) {
    for (Trigger const& trigger : triggers)
        if (auto const value = leverValue(trigger, input)) return value;
    return std::nullopt;
}

/// Tells a lever's move, not its tremble.
void follow(std::optional<float>& told, std::optional<float> now) {
    constexpr float kTremble = 0.01f;
    if (!told || !now || std::abs(*now - *told) > kTremble) told = now;
}

void moveCamera(CameraKey key, Input const& input, CameraInput& camera) {
    switch (key) {
        case CameraKey::left:
            camera.move.x -= 1.0;
            break;
        case CameraKey::right:
            camera.move.x += 1.0;
            break;
        case CameraKey::down:
            camera.move.y -= 1.0;
            break;
        case CameraKey::up:
            camera.move.y += 1.0;
            break;
        case CameraKey::ahead:
            camera.move.z -= 1.0;
            break;
        case CameraKey::back:
            camera.move.z += 1.0;
            break;
        case CameraKey::fast:
            camera.fast = true;
            break;
        case CameraKey::look:
            camera.looking = true;
            break;
        case CameraKey::nearer:
            camera.zoom += std::max(std::abs(input.scrolled.y), 0.25);
            break;
        case CameraKey::farther:
            camera.zoom -= std::max(std::abs(input.scrolled.y), 0.25);
            break;
    }
}

std::vector<std::string> deviceNames(Input const& input) {
    std::vector<std::string> names;
    for (platform::Gamepad const& pad : input.gamepads) names.push_back(pad.name);
    for (platform::Joystick const& stick : input.joysticks) names.push_back(stick.name);
    std::sort(names.begin(), names.end());
    return names;
}

std::string firstLabel(Triggers const& triggers, bool onPad) {
    for (Trigger const& trigger : triggers)
        if (isOnPad(trigger) == onPad) return triggerLabel(trigger);
    return {};
}
}  // namespace

DeviceReading Devices::read(Input const& input, Bindings const& bindings, MouseSettings const& mouse,
                            Listeners const& others, double seconds, float height_px) {
    DeviceReading reading;
    if (!input.keys.empty()) gamepadInHand_ = false;
    noteDevices(input);
    if (input.focused) readActions(input, bindings, others, reading);
    readAxes(input, bindings, seconds, reading);
    readMouse(input, mouse, others, height_px, reading);
    before_ = input;
    return reading;
}

void Devices::readActions(Input const& input, Bindings const& bindings, Listeners const& others,
                          DeviceReading& reading) const {
    std::span<ActionRow const> const rows = actionRows();
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (Trigger const& trigger : bindings.actions[i]) {
            if (isTakenElsewhere(trigger, others) || !isDown(trigger, input) ||
                isMeantOtherwise(trigger, bindings, input))
                continue;
            if (auto const* key = std::get_if<FlightKey>(&rows[i].target)) reading.flight.hold(*key);
            if (auto const* key = std::get_if<CameraKey>(&rows[i].target))
                moveCamera(*key, input, reading.camera);
            if (!wentDown(trigger, input, before_)) continue;
            if (auto const* command = std::get_if<Command>(&rows[i].target))
                reading.commands |= 1u << static_cast<unsigned>(*command);
            if (auto const* mode = std::get_if<CameraMode>(&rows[i].target)) reading.mode = *mode;
        }
}

void Devices::readAxes(Input const& input, Bindings const& bindings, double seconds, DeviceReading& reading) {
    constexpr double kLookRate = 2.0;  // rad/s
    constexpr double kLookDeadZone = 0.15;
    constexpr float kTouched = 0.35f;
    auto const sum = [&](Axis axis) { return axisSum(bindings.of(axis), input); };
    PadAxes& pad = reading.flight.pad;
    pad.roll = sum(Axis::roll), pad.pitch = sum(Axis::pitch), pad.yaw = sum(Axis::yaw),
    pad.thrust = sum(Axis::thrust);
    pad.brakes = leverOf(bindings.of(Axis::brakes), input).value_or(0.0f);
    follow(lever_, leverOf(bindings.of(Axis::lever), input));
    follow(flaps_, leverOf(bindings.of(Axis::flaps), input));
    pad.lever = lever_, pad.flaps = flaps_;
    glm::dvec2 const look{sum(Axis::lookRight), sum(Axis::lookUp)};
    if (std::max(std::abs(look.x), std::abs(look.y)) > kLookDeadZone)
        reading.camera.look += look * kLookRate * seconds;
    if (std::max({std::abs(pad.roll), std::abs(pad.pitch), std::abs(pad.thrust)}) > kTouched)
        gamepadInHand_ = true;
}

/// The mouse looks around while its key is held, else it moves the stick where the player wants that.
void Devices::readMouse(Input const& input, MouseSettings const& mouse, Listeners const& others,
                        float height_px, DeviceReading& reading) {
    constexpr double kRadiansPerPixel = 0.004;
    if (!mouse.flight) mouseStick_.reset();
    if (mouse.flight && (!mouseStick_ || reading.pressed(Command::centreMouse))) mouseStick_ = MouseStick{};
    reading.flight.mouse = mouseStick_;
    if (others.pointer) return;
    if (reading.camera.looking) {
        reading.camera.look += glm::dvec2{input.mouseMoved.x, -input.mouseMoved.y} * kRadiansPerPixel;
    } else if (mouseStick_ && others.mouseFlies) {
        float const share = 1.0f / (mouse.travel * std::max(height_px, 1.0f));
        float const pulled = static_cast<float>(input.mouseMoved.y) * (mouse.invertPitch ? -1.0f : 1.0f);
        mouseStick_->roll =
            std::clamp(mouseStick_->roll + static_cast<float>(input.mouseMoved.x) * share, -1.0f, 1.0f);
        mouseStick_->pitch = std::clamp(mouseStick_->pitch + pulled * share, -1.0f, 1.0f);
    }
    reading.flight.mouse = mouseStick_;
}

void Devices::noteDevices(Input const& input) {
    std::vector<std::string> now = deviceNames(input);
    if (names_ && *names_ == now) return;
    std::vector<std::string> const before = std::exchange(names_, now).value_or(std::vector<std::string>{});
    auto const say = [&](char const* what, std::vector<std::string> const& of,
                         std::vector<std::string> const& without) {
        std::vector<std::string> names;
        std::set_difference(of.begin(), of.end(), without.begin(), without.end(), std::back_inserter(names));
        for (std::string const& name : names) news_.push_back(what + name);
    };
    say("Connected: ", now, before);
    say("Unplugged: ", before, now);
}

std::vector<std::string> Devices::takeNews() { return std::exchange(news_, {}); }

std::string Devices::capOf(ActionTarget const& target, Bindings const& bindings) const {
    std::string const cap = firstLabel(bindings.of(target), gamepadInHand_);
    return cap.empty() ? firstLabel(bindings.of(target), !gamepadInHand_) : cap;
}

std::vector<HudPrompt> Devices::firstPrompts(Bindings const& bindings) const {
    std::vector<HudPrompt> prompts;
    auto const add = [&](std::string const& a, std::string const& b, char const* action) {
        if (!a.empty() || !b.empty())
            prompts.push_back({fmt::format("{}{}{}", a, a.empty() || b.empty() ? "" : " ", b), action});
    };
    auto const axis = [&](Axis which) { return firstLabel(bindings.of(which), true); };
    auto const action = [&](ActionTarget const& target) {
        return firstLabel(bindings.of(target), gamepadInHand_);
    };
    if (gamepadInHand_) {
        add(axis(Axis::roll), "", "roll");
        add(axis(Axis::pitch), "", "nose up, down");
        add(axis(Axis::thrust), "", "thrust");
    } else {
        add(action(FlightKey::rollLeft), action(FlightKey::rollRight), "roll");
        add(action(FlightKey::noseUp), action(FlightKey::noseDown), "nose up, down");
        add(action(FlightKey::thrustUp), action(FlightKey::thrustDown), "thrust");
    }
    add(action(FlightKey::drop), "", "drop the parcel");
    if (gamepadInHand_)
        add(action(Command::escape), "", "menu");
    else
        add(action(Command::keys), "", "all keys");
    return prompts;
}

std::vector<HudPrompt> Devices::replayPrompts(Bindings const& bindings) const {
    auto const pair = [&](ActionTarget const& a, ActionTarget const& b) {
        std::string const first = capOf(a, bindings), second = capOf(b, bindings);
        return first.empty() || second.empty() ? first + second : first + " " + second;
    };
    return {{capOf(FlightKey::drop, bindings), "pause, play"},
            {pair(FlightKey::rollLeft, FlightKey::rollRight), "10 s back, on"},
            {pair(FlightKey::thrustUp, FlightKey::thrustDown), "faster, slower"},
            {capOf(Command::camera, bindings), "camera"},
            {capOf(Command::escape, bindings), "leave"}};
}
}  // namespace luftpost::ui
