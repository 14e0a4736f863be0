#include "game/ui/triggers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace luftpost::ui {
namespace {
using platform::Input;
using platform::Key;
using Kind = Trigger::Kind;

constexpr float kPressed = 0.5f;  // share of an axis' way at which it counts as a pressed button
constexpr int kMostJoysticks = 16, kMostJoyParts = 64;

/// A word in files and what is printed on the device.
struct Named {
    std::string_view word, label;
};
constexpr std::array<Named, platform::kMouseButtons> kMouse{{{"left", "Left mouse"},
                                                             {"right", "Right mouse"},
                                                             {"middle", "Middle mouse"},
                                                             {"back", "Mouse back"},
                                                             {"forward", "Mouse forward"}}};
constexpr std::array<Named, 2> kWheel{{{"up", "Wheel up"}, {"down", "Wheel down"}}};
constexpr std::array<Named, platform::kPadButtons> kPadButtons{{{"south", "A"},
                                                                {"east", "B"},
                                                                {"west", "X"},
                                                                {"north", "Y"},
                                                                {"leftBumper", "LB"},
                                                                {"rightBumper", "RB"},
                                                                {"back", "Back"},
                                                                {"start", "Start"},
                                                                {"guide", "Guide"},
                                                                {"leftThumb", "L-stick pressed"},
                                                                {"rightThumb", "R-stick pressed"},
                                                                {"dpadUp", "D-pad \u2191"},
                                                                {"dpadRight", "D-pad \u2192"},
                                                                {"dpadDown", "D-pad \u2193"},
                                                                {"dpadLeft", "D-pad \u2190"}}};
constexpr std::array<Named, platform::kPadAxes> kPadAxes{{{"leftX", "L-stick \u2190\u2192"},
                                                          {"leftY", "L-stick \u2191\u2193"},
                                                          {"rightX", "R-stick \u2190\u2192"},
                                                          {"rightY", "R-stick \u2191\u2193"},
                                                          {"leftTrigger", "LT"},
                                                          {"rightTrigger", "RT"}}};

template <std::size_t N>
std::optional<int> indexOf(std::array<Named, N> const& names, std::string_view word) {
    auto const found =
        std::find_if(names.begin(), names.end(), [&](Named const& named) { return named.word == word; });
    if (found == names.end()) return std::nullopt;
    return static_cast<int>(found - names.begin());
}

/// Takes `prefix` off the front of `text`.
bool take(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

/// Takes a number from 1 to `most` off the front and counts it from 0.
std::optional<int> takeNumber(std::string_view& text, int most) {
    int number = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || number < 1 || number > most || text.front() == '0') return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number - 1;
}

std::optional<Trigger> joystickTrigger(std::string_view word, bool reversed) {
    auto const joystick = takeNumber(word, kMostJoysticks);
    if (!joystick) return std::nullopt;
    bool const axis = take(word, ".axis");
    if (!axis && !take(word, ".button")) return std::nullopt;
    auto const part = takeNumber(word, kMostJoyParts);
    if (!part || !word.empty() || (reversed && !axis)) return std::nullopt;
    return Trigger{.kind = axis ? Kind::joyAxis : Kind::joyButton,
                   .code = *part,
                   .joystick = *joystick,
                   .reversed = reversed};
}

std::optional<Trigger> keyTrigger(std::string_view word) {
    Trigger trigger;
    while (true) {
        if (take(word, "shift+"))
            trigger.shift = true;
        else if (take(word, "control+"))
            trigger.control = true;
        else if (take(word, "alt+"))
            trigger.alt = true;
        else
            break;
    }
    auto const key = platform::keyFromToken(word);
    if (!key) return std::nullopt;
    trigger.code = static_cast<int>(*key);
    return trigger;
}

Key keyOf(Trigger const& trigger) { return static_cast<Key>(trigger.code); }

/// What a mouse's or gamepad's part is called, and what stands before its word in files; keys and joysticks have no names.
struct NamedPart {
    Named const* named = nullptr;
    std::string_view prefix{};
};
NamedPart namedPart(Trigger const& trigger) {
    auto const code = static_cast<std::size_t>(trigger.code);
    switch (trigger.kind) {
        case Kind::mouse:
            return {&kMouse[code], "mouse."};
        case Kind::wheel:
            return {&kWheel[code], "wheel."};
        case Kind::padButton:
            return {&kPadButtons[code], "pad."};
        case Kind::padAxis:
            return {&kPadAxes[code], "pad."};
        default:
            return {};
    }
}

/// What one calls the key: those of the keypad by it, since they carry the letters of others.
std::string printedOn(Key key) {
    bool const keypad = key >= Key::keypad0 && key <= Key::keypadEqual;
    std::string const label = platform::keyLabel(key);
    return keypad && label.size() <= 2 ? "Num " + label : label;
}

bool isModifier(Key key) { return key >= Key::leftShift && key <= Key::rightSuper; }

bool keyIsDown(Input const& input, Key key) {
    auto const tapped = [key](platform::KeyEvent const& event) { return event.key == key && event.pressed; };
    return input.isHeld(key) || std::any_of(input.keys.begin(), input.keys.end(), tapped);
}

bool modifiersAreDown(Trigger const& trigger, Input const& input) {
    auto const either = [&](Key left, Key right) {
        return keyIsDown(input, left) || keyIsDown(input, right);
    };
    return (!trigger.shift || either(Key::leftShift, Key::rightShift)) &&
           (!trigger.control || either(Key::leftControl, Key::rightControl)) &&
           (!trigger.alt || either(Key::leftAlt, Key::rightAlt));
}

platform::Joystick const* joystickOf(Trigger const& trigger, Input const& input) {
    auto const index = static_cast<std::size_t>(trigger.joystick);
    return index < input.joysticks.size() ? &input.joysticks[index] : nullptr;
}

/// The axis as the device gives it; of several gamepads the one that is moved farthest.
std::optional<float> rawAxis(Trigger const& trigger, Input const& input) {
    auto const code = static_cast<std::size_t>(trigger.code);
    if (trigger.kind == Kind::joyAxis) {
        platform::Joystick const* const stick = joystickOf(trigger, input);
        if (!stick || code >= stick->axes.size()) return std::nullopt;
        return stick->axes[code];
    }
    if (trigger.kind != Kind::padAxis || input.gamepads.empty()) return std::nullopt;
    float farthest = 0.0f;
    for (platform::Gamepad const& pad : input.gamepads)
        if (std::abs(pad.axes[code]) > std::abs(farthest)) farthest = pad.axes[code];
    return farthest;
}

bool isHeld(Trigger const& trigger, Input const& input) {
    auto const code = static_cast<std::size_t>(trigger.code);
    switch (trigger.kind) {
        case Kind::key:
            return input.isHeld(keyOf(trigger));
        case Kind::mouse:
            return input.mouseHeld[code];
        case Kind::wheel:
            return (trigger.code == 0 ? 1.0 : -1.0) * input.scrolled.y > 0.0;
        case Kind::padButton:
            return std::any_of(input.gamepads.begin(), input.gamepads.end(),
                               [&](platform::Gamepad const& pad) { return pad.buttons[code]; });
        case Kind::joyButton: {
            platform::Joystick const* const stick = joystickOf(trigger, input);
            return stick && code < stick->buttons.size() && stick->buttons[code];
        }
        case Kind::padAxis:
        case Kind::joyAxis:
            return axisValue(trigger, input) > kPressed;
    }
    return false;
}

std::optional<Trigger> pressedKey(Input const& input) {
    for (platform::KeyEvent const& event : input.keys) {
        if (event.key == Key::unknown || event.repeat) continue;
        bool const alone = isModifier(event.key);
        if (alone == event.pressed) continue;  // a modifier counts when it is let go
        Trigger trigger{.code = static_cast<int>(event.key)};
        if (!alone) trigger.shift = event.shift, trigger.control = event.control, trigger.alt = event.alt;
        return trigger;
    }
    return std::nullopt;
}
}  // namespace

std::optional<Trigger> parseTrigger(std::string_view word) {
    bool const reversed = take(word, "-");
    if (take(word, "joy")) return joystickTrigger(word, reversed);
    if (take(word, "pad.")) {
        if (auto const axis = indexOf(kPadAxes, word))
            return Trigger{.kind = Kind::padAxis, .code = *axis, .reversed = reversed};
        auto const button = indexOf(kPadButtons, word);
        if (button && !reversed) return Trigger{.kind = Kind::padButton, .code = *button};
        return std::nullopt;
    }
    if (reversed) return std::nullopt;
    if (take(word, "mouse.")) {
        auto const button = indexOf(kMouse, word);
        return button ? std::optional{Trigger{.kind = Kind::mouse, .code = *button}} : std::nullopt;
    }
    if (take(word, "wheel.")) {
        auto const way = indexOf(kWheel, word);
        return way ? std::optional{Trigger{.kind = Kind::wheel, .code = *way}} : std::nullopt;
    }
    return keyTrigger(word);
}

std::optional<Triggers> parseTriggers(std::string_view words) {
    Triggers triggers;
    while (!words.empty()) {
        auto const end = std::min(words.find(' '), words.size());
        if (end > 0) {
            auto const trigger = parseTrigger(words.substr(0, end));
            if (!trigger) return std::nullopt;
            if (std::find(triggers.begin(), triggers.end(), *trigger) == triggers.end())
                triggers.push_back(*trigger);
        }
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return triggers;
}

std::string triggerWord(Trigger const& t) {
    char const* const minus = t.reversed ? "-" : "";
    if (NamedPart const part = namedPart(t); part.named) return fmt::format("{}{}{}", minus, part.prefix, part.named->word);
    if (t.kind == Kind::key)
        return fmt::format("{}{}{}{}", t.shift ? "shift+" : "", t.control ? "control+" : "",
                           t.alt ? "alt+" : "", platform::keyToken(keyOf(t)));
    return fmt::format("{}joy{}.{}{}", minus, t.joystick + 1, t.isAxis() ? "axis" : "button", t.code + 1);
}

std::string triggerWords(Triggers const& triggers) {
    std::string words;
    for (Trigger const& trigger : triggers)
        words += fmt::format("{}{}", words.empty() ? "" : " ", triggerWord(trigger));
    return words;
}

std::string triggerLabel(Trigger const& t) {
    char const* const minus = t.reversed ? "\u2212" : "";
    if (NamedPart const part = namedPart(t); part.named) return fmt::format("{}{}", minus, part.named->label);
    if (t.kind == Kind::key)
        return fmt::format("{}{}{}{}", t.shift ? "Shift+" : "", t.control ? "Ctrl+" : "",
                           t.alt ? "Alt+" : "", printedOn(keyOf(t)));
    return fmt::format("{}Joystick {} {} {}", minus, t.joystick + 1, t.isAxis() ? "axis" : "button", t.code + 1);
}

bool isOnPad(Trigger const& trigger) { return trigger.kind >= Kind::padButton; }

bool isDown(Trigger const& trigger, Input const& input) {
    if (trigger.kind == Kind::key)
        return keyIsDown(input, keyOf(trigger)) && modifiersAreDown(trigger, input);
    if (trigger.kind == Kind::mouse)
        for (platform::MouseButtonEvent const& event : input.mouseButtons)
            if (event.pressed && static_cast<int>(event.button) == trigger.code) return true;
    return isHeld(trigger, input);
}

bool wentDown(Trigger const& trigger, Input const& input, Input const& before) {
    if (trigger.kind == Kind::wheel) return isHeld(trigger, input);
    if (trigger.kind == Kind::mouse)
        return std::any_of(input.mouseButtons.begin(), input.mouseButtons.end(),
                           [&](platform::MouseButtonEvent const& event) {
                               return event.pressed && static_cast<int>(event.button) == trigger.code;
                           });
    if (trigger.kind != Kind::key) return isHeld(trigger, input) && !isHeld(trigger, before);
    return modifiersAreDown(trigger, input) &&
           std::any_of(input.keys.begin(), input.keys.end(), [&](platform::KeyEvent const& event) {
               return event.pressed && !event.repeat && event.key == keyOf(trigger);
           });
}

float axisValue(Trigger const& trigger, Input const& input) {
    return rawAxis(trigger, input).value_or(0.0f) * (trigger.reversed ? -1.0f : 1.0f);
}

std::optional<float> leverValue(Trigger const& trigger, Input const& input) {
    auto const raw = rawAxis(trigger, input);
    if (!raw) return std::nullopt;
    bool const fromZero =
        trigger.kind == Kind::padAxis && trigger.code >= static_cast<int>(platform::PadAxis::leftTrigger);
    float const share = std::clamp(fromZero ? *raw : 0.5f * (*raw + 1.0f), 0.0f, 1.0f);
    return trigger.reversed ? 1.0f - share : share;
}

std::optional<Trigger> pressedFirst(Input const& input, Input const& before) {
    if (auto const key = pressedKey(input)) return key;
    for (platform::MouseButtonEvent const& event : input.mouseButtons)
        if (event.pressed) return Trigger{.kind = Kind::mouse, .code = static_cast<int>(event.button)};
    if (input.scrolled.y != 0.0) return Trigger{.kind = Kind::wheel, .code = input.scrolled.y > 0.0 ? 0 : 1};
    Triggers buttons;
    for (int code = 0; code < platform::kPadButtons; ++code)
        buttons.push_back({.kind = Kind::padButton, .code = code});
    for (std::size_t stick = 0; stick < input.joysticks.size(); ++stick)
        for (std::size_t code = 0; code < input.joysticks[stick].buttons.size(); ++code)
            buttons.push_back({.kind = Kind::joyButton,
                               .code = static_cast<int>(code),
                               .joystick = static_cast<int>(stick)});
    for (Trigger const& button : buttons)
        if (wentDown(button, input, before)) return button;
    return std::nullopt;
}

std::optional<Trigger> movedFirst(Input const& input, Input const& start) {
    Triggers axes;
    for (int code = 0; code < platform::kPadAxes; ++code)
        axes.push_back({.kind = Kind::padAxis, .code = code});
    for (std::size_t stick = 0; stick < input.joysticks.size(); ++stick)
        for (std::size_t code = 0; code < input.joysticks[stick].axes.size(); ++code)
            axes.push_back(
                {.kind = Kind::joyAxis, .code = static_cast<int>(code), .joystick = static_cast<int>(stick)});
    for (Trigger const& axis : axes)
        if (std::abs(axisValue(axis, input) - axisValue(axis, start)) > kPressed) return axis;
    return std::nullopt;
}
}  // namespace luftpost::ui
