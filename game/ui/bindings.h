// What each key, button and axis is for. Actions and axes are two tables; settings file, --set, the page of bindings, the keys page,
// the prompts and the devices are loops over them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/settings.h"
#include "game/ui/camera.h"
#include "game/ui/input.h"
#include "game/ui/triggers.h"

namespace luftpost::ui {
/// What is not part of the flight: acts once a press.
enum class Command : unsigned {
    camera,
    pause,
    config,
    normals,
    wireframe,
    fullScreen,
    picture,
    keys,
    weather,
    photo,
    studio,
    air,
    hudDensity,
    mouseFlight,
    centreMouse,
    escape,
    count
};

/// What the camera does while it is held.
enum class CameraKey { left, right, down, up, ahead, back, fast, look, nearer, farther };

/// What an action does: an act of flight, a command, a camera of its own, or a move of the camera.
using ActionTarget = std::variant<FlightKey, Command, CameraMode, CameraKey>;

struct ActionRow {
    std::string_view key;    // of the setting
    std::string_view group;  // on the page of bindings
    std::string_view label;
    std::string_view initial;  // words of triggers
    ActionTarget target;
};
std::span<ActionRow const> actionRows();
/// The row with this target; it must have one.
std::size_t actionOf(ActionTarget const& target);

enum class Axis : unsigned { roll, pitch, yaw, thrust, lever, flaps, brakes, lookRight, lookUp, count };
struct AxisRow {
    std::string_view key;
    std::string_view label;
    std::string_view initial;  // words of triggers that are axes
};
std::span<AxisRow const> axisRows();

struct Bindings {
    Bindings();
    std::vector<Triggers> actions;  // as actionRows
    std::vector<Triggers> axes;     // as axisRows

    Triggers const& of(ActionTarget const& target) const { return actions[actionOf(target)]; }
    Triggers const& of(Axis axis) const { return axes[static_cast<std::size_t>(axis)]; }
};

/// Appends a setting for each row, its value the words of its triggers.
void appendBindingSettings(core::SettingList& list, Bindings& bindings);

/// The other actions that this trigger belongs to, too: both act.
std::vector<std::size_t> sharedWith(Bindings const& bindings, std::size_t action, Trigger const& trigger);

/// One row of the key help: what an action's caps are in the layout in use and on the gamepad.
struct KeyHelp {
    std::string group;               // "Flight", "View", "Game"
    std::vector<std::string> caps;   // "A", "D"
    std::vector<std::string> pad;    // "LB", "RB"; empty: none
    std::string action;              // "yaw"
};
/// All that is bound, for the keys page. Main thread.
std::vector<KeyHelp> keyHelp(Bindings const& bindings);
}  // namespace luftpost::ui
