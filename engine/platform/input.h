// What a window tells of keys, mouse and gamepads. Plain data; no GLFW names outside engine/platform.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::platform {
/// Physical keys, named after the US layout: Key::w is the key above s and left of e whatever letter is printed on
/// it. The numbers are GLFW's.
enum class Key : int {
    unknown = -1,
    space = 32, apostrophe = 39, comma = 44, minus = 45, period = 46, slash = 47,
    digit0 = 48, digit1, digit2, digit3, digit4, digit5, digit6, digit7, digit8, digit9,
    semicolon = 59, equal = 61,
    a = 65, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    leftBracket = 91, backslash = 92, rightBracket = 93, graveAccent = 96,
    world1 = 161, world2 = 162,
    escape = 256, enter, tab, backspace, insert, del, right, left, down, up, pageUp, pageDown, home, end,
    capsLock = 280, scrollLock, numLock, printScreen, pause,
    f1 = 290, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    keypad0 = 320, keypad1, keypad2, keypad3, keypad4, keypad5, keypad6, keypad7, keypad8, keypad9,
    keypadDecimal, keypadDivide, keypadMultiply, keypadSubtract, keypadAdd, keypadEnter, keypadEqual,
    leftShift = 340, leftControl, leftAlt, leftSuper, rightShift, rightControl, rightAlt, rightSuper, menu
};
inline constexpr int kKeys = 349;

/// The key's name in settings files: "w", "space", "leftShift", "f1"; "" for unknown.
std::string keyToken(Key key);
std::optional<Key> keyFromToken(std::string_view token);
/// What is printed on the key in the layout in use ("W", "Z" on a French keyboard, "Space"). Main thread; falls back
/// to the US name when no window is open.
std::string keyLabel(Key key);

enum class MouseButton : int { left, right, middle, back, forward };
inline constexpr int kMouseButtons = 5;

/// Gamepad axes and buttons in SDL's mapping: sticks -1..1 (right and down positive), triggers 0..1.
enum class PadAxis : int { leftX, leftY, rightX, rightY, leftTrigger, rightTrigger };
enum class PadButton : int {
    south, east, west, north, leftBumper, rightBumper, back, start, guide, leftThumb, rightThumb,
    dpadUp, dpadRight, dpadDown, dpadLeft
};
inline constexpr int kPadAxes = 6;
inline constexpr int kPadButtons = 15;

struct Gamepad {
    int id = 0;          // GLFW's slot; stays the same while the pad is plugged in
    std::string name;
    std::array<float, kPadAxes> axes{};
    std::array<bool, kPadButtons> buttons{};
    float axis(PadAxis which) const { return axes[static_cast<std::size_t>(which)]; }
    bool button(PadButton which) const { return buttons[static_cast<std::size_t>(which)]; }
};

/// A stick, throttle or pedals that nobody has mapped to a gamepad: axes -1..1 and buttons (hats are four more, in the
/// order up, right, down, left) as the device numbers them.
struct Joystick {
    int id = 0;  // GLFW's slot
    std::string name;
    std::vector<float> axes;
    std::vector<bool> buttons;
};

struct KeyEvent {
    Key key = Key::unknown;
    bool pressed = false;  // false: released
    bool repeat = false;   // the system's key repeat: a text box wants it, flight keys do not
    bool shift = false, control = false, alt = false, super = false;
};
struct MouseButtonEvent {
    MouseButton button = MouseButton::left;
    bool pressed = false;
};

/// All that happened since the last poll, and what is held now.
struct Input {
    std::vector<KeyEvent> keys;                // in order
    std::vector<char32_t> text;                // typed characters, layout and dead keys applied
    std::vector<MouseButtonEvent> mouseButtons;
    glm::dvec2 mouse{0.0};                     // pixels of the framebuffer, from the upper left
    glm::dvec2 mouseMoved{0.0};                // pixels since the last poll
    glm::dvec2 scrolled{0.0};                  // notches since the last poll, up positive
    std::array<bool, kKeys> held{};            // by key number
    std::array<bool, kMouseButtons> mouseHeld{};
    std::vector<Gamepad> gamepads;             // those plugged in now
    std::vector<Joystick> joysticks;           // the other ones
    bool focused = true;

    bool isHeld(Key key) const { return key != Key::unknown && held[static_cast<std::size_t>(key)]; }
};
}  // namespace luftpost::platform
