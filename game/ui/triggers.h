// One key, button or axis of a device: its word in settings files, its label on screen, and what it does now.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/platform/input.h"

namespace luftpost::ui {
/// "w", "shift+f", "mouse.left", "wheel.up", "pad.south", "joy1.button3" are down or not; "pad.leftX", "joy1.axis2" have a way to go.
/// A minus before an axis turns it round.
struct Trigger {
    enum class Kind { key, mouse, wheel, padButton, padAxis, joyButton, joyAxis };
    Kind kind = Kind::key;
    int code = 0;      // the key's or button's number; wheel: 0 up, 1 down; joysticks count from 0
    int joystick = 0;  // which of those plugged in, from 0
    bool shift = false, control = false, alt = false;  // keys only
    bool reversed = false;                             // axes only

    bool isAxis() const { return kind == Kind::padAxis || kind == Kind::joyAxis; }
    bool operator==(Trigger const&) const = default;
};
using Triggers = std::vector<Trigger>;

std::optional<Trigger> parseTrigger(std::string_view word);
/// The words between the spaces; none where one of them is no trigger. Nothing at all is an empty list.
std::optional<Triggers> parseTriggers(std::string_view words);
std::string triggerWord(Trigger const& trigger);
std::string triggerWords(Triggers const& triggers);
/// What is printed on it, with the letters of the layout in use: "Shift+F", "RT", "Joystick 1 button 3". Main thread.
std::string triggerLabel(Trigger const& trigger);
/// Of the gamepad or a joystick.
bool isOnPad(Trigger const& trigger);

/// Held now, or tapped since the last poll: no frame is so slow that it loses a drop. Modifiers count as the trigger asks for them.
bool isDown(Trigger const& trigger, platform::Input const& input);
/// Pressed since the last poll (`before`: what was held then); the system's key repeat does not count.
bool wentDown(Trigger const& trigger, platform::Input const& input, platform::Input const& before);
/// Where an axis stands, -1..1 (a gamepad's triggers 0..1), turned round where the trigger says so; 0 without the device.
float axisValue(Trigger const& trigger, platform::Input const& input);
/// The same on a scale from 0, the lever back, to 1; nothing without the device.
std::optional<float> leverValue(Trigger const& trigger, platform::Input const& input);

/// What a player who is asked for a key pressed first; nothing yet. Modifiers count when they are let go alone.
std::optional<Trigger> pressedFirst(platform::Input const& input, platform::Input const& before);
/// What a player who is asked for an axis moved half way or more away from where it was at `start`.
std::optional<Trigger> movedFirst(platform::Input const& input, platform::Input const& start);
}  // namespace luftpost::ui
