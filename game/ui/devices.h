// Keyboard, mouse and gamepad of a window as what the game asks for: the flight's sample, the camera's wish,
// the screen's pointer and text, and the commands that were pressed. The bindings are one table; the keys
// page is made from it.
#pragma once
#include <vector>

#include "engine/platform/input.h"
#include "game/ui/camera.h"
#include "game/ui/hud.h"
#include "game/ui/input.h"
#include "game/ui/menu.h"

namespace luftpost::ui {
/// What is not part of the flight: pressed in this frame.
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
    escape,
    count
};

struct DeviceReading {
    InputSample flight;
    CameraInput camera;
    unsigned commands = 0;  // bit i: Command i went down since the last reading
    bool pressed(Command command) const { return (commands >> static_cast<unsigned>(command) & 1u) != 0; }
};

class Devices {
public:
    /// `wantsText`: a text box has the focus, so keys are text; `wantsPointer`: the pointer is over a menu.
    /// `seconds` since the last reading.
    DeviceReading read(platform::Input const& input, bool wantsText, bool wantsPointer, double seconds);
    /// A gamepad was touched after the keyboard.
    bool gamepadInHand() const { return gamepadInHand_; }
    /// What a beginner needs first, with the caps of the device in hand and its layout.
    std::vector<HudPrompt> firstPrompts() const;
    /// The same of a replay that is watched.
    std::vector<HudPrompt> replayPrompts() const;

private:
    void readPads(platform::Input const& input, DeviceReading& reading, double seconds);
    bool gamepadInHand_ = false;
    std::array<bool, platform::kPadButtons> padBefore_{};
};

/// All keys and buttons, for the keys page, with the letters of the layout in use. Main thread.
std::vector<KeyHelp> keyHelp();
}  // namespace luftpost::ui
