// A GL 4.5 core debug context with or without a window, behind one interface. Main thread only.
#pragma once
#include <memory>
#include <string>

#include <glm/glm.hpp>

#include "engine/platform/input.h"

namespace luftpost::platform {
class Surface {
public:
    virtual ~Surface() = default;
    virtual void makeCurrent() = 0;
    /// Shows what was drawn into framebuffer 0; nothing without a window.
    virtual void swap() = 0;
    /// Size in pixels (not screen points); at least 1 x 1.
    virtual glm::ivec2 size() const = 0;
    /// True when there is a framebuffer 0 to draw into.
    virtual bool hasWindow() const = 0;

    /// Collects the system's events and the gamepads; the reference holds until the next poll.
    virtual Input const& poll() = 0;
    virtual bool closeRequested() const { return false; }
    /// Takes back a request to close (the game asks first).
    virtual void refuseClose() {}
    /// Pixels per screen point of the monitor: 1 usual, 2 on a dense screen.
    virtual float contentScale() const { return 1.0f; }
    virtual bool fullScreen() const { return false; }
    virtual void setFullScreen(bool) {}
    /// Hides the mouse pointer and holds it in the window (cameras), or sets it free.
    virtual void captureMouse(bool) {}
    virtual void setTitle(std::string const&) {}
    virtual void setVerticalSync(bool) {}
    virtual std::string clipboard() const { return {}; }
    virtual void setClipboard(std::string const&) {}
};

struct WindowOptions {
    glm::ivec2 size{1280, 720};
    std::string title = "Luftpost";
    bool fullScreen = false;
    bool verticalSync = true;
    bool visible = true;
};

/// True when there is a display server to open a window on (X11 or Wayland).
bool hasDisplay();

/// A window with its context, current. Throws core::Error when there is no display or no GL 4.5.
std::unique_ptr<Surface> openWindow(WindowOptions const& options);

/// A context without any window, current: EGL's surfaceless platform, else its device platform. Throws core::Error.
std::unique_ptr<Surface> openHeadless(glm::ivec2 const& size);
}  // namespace luftpost::platform
