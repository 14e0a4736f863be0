#include "game/ui/bindings.h"

#include <algorithm>

#include "engine/core/check.h"

namespace luftpost::ui {
namespace {
using enum FlightKey;

constexpr auto kActions = std::to_array<ActionRow>({
    {"keys.thrustUp", "Flight", "Throttle up", "w", thrustUp},
    {"keys.thrustDown", "Flight", "Throttle down", "s", thrustDown},
    {"keys.thrustStepUp", "Flight", "Throttle a tenth up", "equal keypadAdd", thrustStepUp},
    {"keys.thrustStepDown", "Flight", "Throttle a tenth down", "minus keypadSubtract", thrustStepDown},
    {"keys.rollLeft", "Flight", "Roll left", "a left", rollLeft},
    {"keys.rollRight", "Flight", "Roll right", "d right", rollRight},
    {"keys.noseUp", "Flight", "Nose up", "down", noseUp},
    {"keys.noseDown", "Flight", "Nose down", "up", noseDown},
    {"keys.yawLeft", "Flight", "Yaw left", "q pad.leftBumper", yawLeft},
    {"keys.yawRight", "Flight", "Yaw right", "e pad.rightBumper", yawRight},
    {"keys.trimNoseUp", "Flight", "Trim nose up", "pageDown pad.dpadLeft", trimNoseUp},
    {"keys.trimNoseDown", "Flight", "Trim nose down", "pageUp pad.dpadRight", trimNoseDown},
    {"keys.trimYawLeft", "Flight", "Trim yaw left", "comma", trimYawLeft},
    {"keys.trimYawRight", "Flight", "Trim yaw right", "period", trimYawRight},
    {"keys.trimNeutral", "Flight", "Trim neutral", "home", trimNeutral},
    {"keys.flapsDown", "Flight", "Flaps down", "f pad.west", flapsDown},
    {"keys.flapsUp", "Flight", "Flaps up", "shift+f pad.north", flapsUp},
    {"keys.brakes", "Flight", "Brakes", "b pad.east joy1.button2", brakes},
    {"keys.drop", "Flight", "Drop the parcel", "space pad.south joy1.button1", drop},
    {"keys.respawn", "Flight", "Respawn (hold)", "r pad.leftThumb", respawn},
    {"keys.autopilot", "Flight", "Autopilot on and off", "t pad.rightThumb", autopilot},
    {"keys.mouseFlight", "Flight", "Fly with the mouse", "m", Command::mouseFlight},
    {"keys.centreMouse", "Flight", "Centre the mouse's stick", "mouse.middle", Command::centreMouse},

    {"keys.camera", "View", "Next camera", "c pad.back", Command::camera},
    {"keys.chase", "View", "Camera: chase", "1", CameraMode::chase},
    {"keys.cockpit", "View", "Camera: cockpit", "2", CameraMode::cockpit},
    {"keys.wing", "View", "Camera: wing", "3", CameraMode::wing},
    {"keys.hatch", "View", "Camera: drop hatch", "4", CameraMode::hatch},
    {"keys.tower", "View", "Camera: tower", "5", CameraMode::tower},
    {"keys.free", "View", "Camera: free", "6", CameraMode::free},
    {"keys.look", "View", "Look around (hold)", "mouse.right", CameraKey::look},
    {"keys.nearer", "View", "Camera nearer", "wheel.up", CameraKey::nearer},
    {"keys.farther", "View", "Camera farther", "wheel.down", CameraKey::farther},
    {"keys.freeLeft", "View", "Free camera left", "j", CameraKey::left},
    {"keys.freeRight", "View", "Free camera right", "l", CameraKey::right},
    {"keys.freeDown", "View", "Free camera down", "u", CameraKey::down},
    {"keys.freeUp", "View", "Free camera up", "o", CameraKey::up},
    {"keys.freeAhead", "View", "Free camera ahead", "i", CameraKey::ahead},
    {"keys.freeBack", "View", "Free camera back", "k", CameraKey::back},
    {"keys.freeFast", "View", "Free camera fast (hold)", "leftShift", CameraKey::fast},
    {"keys.hudDensity", "View", "Instruments: full, reduced, minimal", "n", Command::hudDensity},
    {"keys.air", "View", "Show the air: wind, lift and sink", "v", Command::air},
    {"keys.photo", "View", "Photograph: over, split, beside, off", "f5", Command::photo},
    {"keys.studio", "View", "Studio: stand still, take a picture", "f6", Command::studio},
    {"keys.normals", "View", "Show normals", "f2", Command::normals},
    {"keys.wireframe", "View", "Show the wireframe", "f3", Command::wireframe},
    {"keys.fullScreen", "View", "Full screen", "f11", Command::fullScreen},
    {"keys.picture", "View", "Take a picture", "f12", Command::picture},

    {"keys.pause", "Game", "Pause", "p pause", Command::pause},
    {"keys.config", "Game", "Settings", "f1 pad.dpadUp", Command::config},
    {"keys.weather", "Game", "Weather", "f4", Command::weather},
    {"keys.keys", "Game", "All keys", "h pad.dpadDown", Command::keys},
    {"keys.escape", "Game", "Close a page, else the menu", "escape pad.start", Command::escape},
});

constexpr auto kAxes = std::to_array<AxisRow>({
    {"axes.roll", "Roll", "pad.leftX joy1.axis1"},
    {"axes.pitch", "Pitch", "pad.leftY joy1.axis2"},
    {"axes.yaw", "Yaw", "joy1.axis3"},
    {"axes.thrust", "Throttle rate", "pad.rightTrigger -pad.leftTrigger"},
    {"axes.lever", "Throttle lever", "-joy1.axis4"},
    {"axes.flaps", "Flaps lever", ""},
    {"axes.brakes", "Brakes", ""},
    {"axes.lookRight", "Look right", "pad.rightX"},
    {"axes.lookUp", "Look up", "-pad.rightY"},
});
static_assert(kAxes.size() == static_cast<std::size_t>(Axis::count));

std::optional<Triggers> parseAxes(std::string_view words) {
    auto triggers = parseTriggers(words);
    if (triggers &&
        !std::all_of(triggers->begin(), triggers->end(), [](Trigger const& t) { return t.isAxis(); }))
        return std::nullopt;
    return triggers;
}

core::Setting textSetting(std::string_view key, std::string_view help, std::string_view initial,
                          std::string_view expected, Triggers& triggers,
                          std::optional<Triggers> (*parse)(std::string_view)) {
    return {.key = key,
            .help = help,
            .words = {},
            .expected = expected,
            .accepts = [parse](std::string const& words) { return parse(words).has_value(); },
            .initial = std::string{initial},
            .get = [&triggers] { return core::SettingValue{triggerWords(triggers)}; },
            .set =
                [&triggers, parse](core::SettingValue const& value) {
                    triggers = parse(std::get<std::string>(value)).value();
                }};
}

/// Rows of the keys page: what one looks for together stands together.
struct HelpRow {
    std::string_view group, action;
    std::vector<ActionTarget> actions;
    std::vector<Axis> axes{};
};
std::vector<HelpRow> helpRows() {
    using enum Command;
    return {{"Flight", "throttle up, down", {thrustUp, thrustDown}, {Axis::thrust, Axis::lever}},
            {"Flight", "throttle by a tenth", {thrustStepUp, thrustStepDown}},
            {"Flight", "roll", {rollLeft, rollRight}, {Axis::roll}},
            {"Flight", "nose up, down", {noseUp, noseDown}, {Axis::pitch}},
            {"Flight", "yaw", {yawLeft, yawRight}, {Axis::yaw}},
            {"Flight", "trim nose up, down", {trimNoseUp, trimNoseDown}},
            {"Flight", "trim yaw, neutral", {trimYawLeft, trimYawRight, trimNeutral}},
            {"Flight", "flaps down, up", {flapsDown, flapsUp}, {Axis::flaps}},
            {"Flight", "brakes", {FlightKey::brakes}, {Axis::brakes}},
            {"Flight", "drop the parcel", {drop}},
            {"Flight", "held: in the air again", {respawn}},
            {"Flight", "autopilot; lever and trim set it", {autopilot}},
            {"Flight", "fly with the mouse", {mouseFlight}},
            {"View", "next camera", {camera}},
            {"View", "chase, cockpit, wing", {CameraMode::chase, CameraMode::cockpit, CameraMode::wing}},
            {"View", "hatch, tower, free", {CameraMode::hatch, CameraMode::tower, CameraMode::free}},
            {"View", "held: look around", {CameraKey::look}, {Axis::lookRight, Axis::lookUp}},
            {"View",
             "move the free camera",
             {CameraKey::ahead, CameraKey::left, CameraKey::back, CameraKey::right, CameraKey::down,
              CameraKey::up}},
            {"View", "instruments: how many", {hudDensity}},
            {"View", "the air: wind, lift", {air}},
            {"View", "photograph; studio", {photo, studio}},
            {"View", "normals, wireframe", {normals, wireframe}},
            {"View", "full screen, picture", {fullScreen, picture}},
            {"Game", "pause", {pause}},
            {"Game", "settings, weather", {config, weather}},
            {"Game", "this page", {keys}},
            {"Game", "close, else the menu", {escape}}};
}
}  // namespace

std::span<ActionRow const> actionRows() { return kActions; }
std::span<AxisRow const> axisRows() { return kAxes; }

std::size_t actionOf(ActionTarget const& target) {
    auto const found = std::find_if(kActions.begin(), kActions.end(),
                                    [&](ActionRow const& row) { return row.target == target; });
    CHECK(found != kActions.end(), "no action for target {}", target.index());
    return static_cast<std::size_t>(found - kActions.begin());
}

Bindings::Bindings() {
    for (ActionRow const& row : kActions) actions.push_back(parseTriggers(row.initial).value());
    for (AxisRow const& row : kAxes) axes.push_back(parseAxes(row.initial).value());
}

void appendBindingSettings(core::SettingList& list, Bindings& bindings) {
    for (std::size_t i = 0; i < kActions.size(); ++i)
        list.push_back(textSetting(kActions[i].key, kActions[i].label, kActions[i].initial,
                                   "keys and buttons", bindings.actions[i], parseTriggers));
    for (std::size_t i = 0; i < kAxes.size(); ++i)
        list.push_back(
            textSetting(kAxes[i].key, kAxes[i].label, kAxes[i].initial, "axes", bindings.axes[i], parseAxes));
}

std::vector<std::size_t> sharedWith(Bindings const& bindings, std::size_t action, Trigger const& trigger) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < bindings.actions.size(); ++i)
        if (i != action && std::find(bindings.actions[i].begin(), bindings.actions[i].end(), trigger) !=
                               bindings.actions[i].end())
            others.push_back(i);
    return others;
}

std::vector<KeyHelp> keyHelp(Bindings const& bindings) {
    std::vector<KeyHelp> help;
    for (HelpRow const& row : helpRows()) {
        KeyHelp shown{std::string{row.group}, {}, {}, std::string{row.action}};
        auto const add = [&](Trigger t) {
            t.reversed = false;  // which way round an axis is says the page of bindings
            std::vector<std::string>& to = isOnPad(t) ? shown.pad : shown.caps;
            if (t.kind < Trigger::Kind::joyButton)
                to.push_back(triggerLabel(t));  // a joystick's numbers say little
        };
        for (ActionTarget const& target : row.actions)
            for (Trigger const& trigger : bindings.of(target)) add(trigger);
        for (Axis axis : row.axes)
            for (Trigger const& trigger : bindings.of(axis)) add(trigger);
        if (!shown.caps.empty() || !shown.pad.empty()) help.push_back(std::move(shown));
    }
    return help;
}
}  // namespace luftpost::ui
