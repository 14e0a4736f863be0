// Keyboard, mouse, gamepad and joystick of a window as what the game asks for: the flight's sample, the camera's wish, and the
// commands that were pressed. What is bound to what is ui/bindings.h.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/platform/input.h"
#include "game/ui/bindings.h"
#include "game/ui/camera.h"
#include "game/ui/hud.h"
#include "game/ui/input.h"
#include "game/ui/input_settings.h"

namespace luftpost::ui {
struct DeviceReading {
    InputSample flight;
    CameraInput camera;
    std::optional<CameraMode> mode;  // a camera's own key went down
    unsigned commands = 0;           // bit i: Command i went down since the last reading
    bool pressed(Command command) const { return (commands >> static_cast<unsigned>(command) & 1u) != 0; }
};

/// Who else listens to the devices.
struct Listeners {
    bool text = false;     // a text box has the focus: keys are text
    bool pointer = false;  // the pointer is over a menu
    bool mouseFlies = false;  // the mouse moves the stick in this frame
};

class Devices {
public:
    /// `seconds` since the last reading; `height_px` of the window.
    DeviceReading read(platform::Input const& input, Bindings const& bindings, MouseSettings const& mouse, Listeners const& others, double seconds, float height_px);
    /// A gamepad or joystick was touched after the keyboard.
    bool gamepadInHand() const { return gamepadInHand_; }
    /// Where the mouse holds the stick; nothing while it does not.
    std::optional<MouseStick> const& mouseStick() const { return mouseStick_; }
    /// What a beginner needs first, with the caps of the device in hand and its layout.
    std::vector<HudPrompt> firstPrompts(Bindings const& bindings) const;
    /// The same of a replay that is watched.
    std::vector<HudPrompt> replayPrompts(Bindings const& bindings) const;
    /// The cap of an action on the device in hand, else on the other one.
    std::string capOf(ActionTarget const& target, Bindings const& bindings) const;
    /// "Connected: NAME", "Unplugged: NAME" since the last call.
    std::vector<std::string> takeNews();

private:
    void readActions(platform::Input const& input, Bindings const& bindings, Listeners const& others, DeviceReading& reading) const;
    void readAxes(platform::Input const& input, Bindings const& bindings, double seconds, DeviceReading& reading);
    void readMouse(platform::Input const& input, MouseSettings const& mouse, Listeners const& others, float height_px, DeviceReading& reading);
    void noteDevices(platform::Input const& input);

    bool gamepadInHand_ = false;
    platform::Input before_;
    std::optional<MouseStick> mouseStick_;
    std::optional<float> lever_, flaps_;  // as last told: a lever that trembles does not move
    std::optional<std::vector<std::string>> names_;
    std::vector<std::string> news_;
};
}  // namespace luftpost::ui
