// The GLFW window: context, events, gamepads, full screen.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "engine/core/error.h"
#include "engine/platform/surface.h"

namespace luftpost::platform {
namespace {
/// GLFW lives as long as some window does.
class Library {
public:
    Library() {
        if (!glfwInit()) throw core::Error{"display", "GLFW", description()};
    }
    ~Library() { glfwTerminate(); }
    Library(Library const&) = delete;
    Library& operator=(Library const&) = delete;

    static std::string description() {
        char const* text = nullptr;
        glfwGetError(&text);
        return std::string{"expected a display to open a window on"} + (text ? std::string{", found: "} + text : "");
    }
};

void setHints(WindowOptions const& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // depth lives in our own targets
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
}

class WindowSurface : public Surface {
public:
    explicit WindowSurface(WindowOptions const& options) {
        setHints(options);
        window_ = glfwCreateWindow(options.size.x, options.size.y, options.title.c_str(), nullptr, nullptr);
        if (!window_) throw core::Error{"graphics driver", "window", Library::description()};
        glfwSetWindowUserPointer(window_, this);
        listen();
        makeCurrent();
        setVerticalSync(options.verticalSync);
        setFullScreen(options.fullScreen);
        glfwGetCursorPos(window_, &lastMouse_.x, &lastMouse_.y);
    }
    WindowSurface(WindowSurface const&) = delete;
    WindowSurface& operator=(WindowSurface const&) = delete;
    ~WindowSurface() override { glfwDestroyWindow(window_); }

    void makeCurrent() override { glfwMakeContextCurrent(window_); }
    void swap() override { glfwSwapBuffers(window_); }
    glm::ivec2 size() const override {
        glm::ivec2 size{1};
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        return glm::max(size, glm::ivec2{1});
    }
    bool hasWindow() const override { return true; }
    bool closeRequested() const override { return glfwWindowShouldClose(window_) != 0; }
    void refuseClose() override { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
    float contentScale() const override {
        glm::vec2 scale{1.0f};
        glfwGetWindowContentScale(window_, &scale.x, &scale.y);
        return std::max(scale.y, 0.5f);
    }
    bool fullScreen() const override { return glfwGetWindowMonitor(window_) != nullptr; }
    void setFullScreen(bool on) override;
    void captureMouse(bool on) override {
        glfwSetInputMode(window_, GLFW_CURSOR, on ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
        glfwGetCursorPos(window_, &lastMouse_.x, &lastMouse_.y);
    }
    void setTitle(std::string const& title) override { glfwSetWindowTitle(window_, title.c_str()); }
    void setVerticalSync(bool on) override { glfwSwapInterval(on ? 1 : 0); }
    std::string clipboard() const override {
        char const* text = glfwGetClipboardString(window_);
        return text ? text : "";
    }
    void setClipboard(std::string const& text) override { glfwSetClipboardString(window_, text.c_str()); }
    Input const& poll() override;

private:
    static WindowSurface& of(GLFWwindow* window) {
        return *static_cast<WindowSurface*>(glfwGetWindowUserPointer(window));
    }
    void listen();
    void onKey(int key, int action, int modifiers);
    void onFocus(bool focused);
    void pollMouse();
    void pollDevices();

    Library library_;
    GLFWwindow* window_ = nullptr;
    Input input_;
    glm::dvec2 lastMouse_{0.0};     // screen points
    glm::ivec4 windowedBox_{0};     // x, y, width, height before full screen
};

void WindowSurface::listen() {
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
        of(window).onKey(key, action, modifiers);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned character) {
        of(window).input_.text.push_back(static_cast<char32_t>(character));
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
        if (button < 0 || button >= kMouseButtons) return;
        Input& input = of(window).input_;
        input.mouseButtons.push_back({static_cast<MouseButton>(button), action == GLFW_PRESS});
        input.mouseHeld[static_cast<std::size_t>(button)] = action == GLFW_PRESS;
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
        of(window).input_.scrolled += glm::dvec2{x, y};
    });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int focused) { of(window).onFocus(focused != 0); });
}

void WindowSurface::onKey(int key, int action, int modifiers) {
    KeyEvent event;
    event.key = key >= 0 && key < kKeys ? static_cast<Key>(key) : Key::unknown;
    event.pressed = action != GLFW_RELEASE;
    event.repeat = action == GLFW_REPEAT;
    event.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    event.control = (modifiers & GLFW_MOD_CONTROL) != 0;
    event.alt = (modifiers & GLFW_MOD_ALT) != 0;
    event.super = (modifiers & GLFW_MOD_SUPER) != 0;
    if (event.key != Key::unknown) input_.held[static_cast<std::size_t>(key)] = event.pressed;
    input_.keys.push_back(event);
}

/// A window without focus gets no releases: everything held is let go.
void WindowSurface::onFocus(bool focused) {
    input_.focused = focused;
    if (focused) return;
    for (int key = 0; key < kKeys; ++key) {
        if (!input_.held[static_cast<std::size_t>(key)]) continue;
        input_.held[static_cast<std::size_t>(key)] = false;
        KeyEvent released;
        released.key = static_cast<Key>(key);
        input_.keys.push_back(released);
    }
    input_.mouseHeld = {};
}

void WindowSurface::pollMouse() {
    glm::dvec2 now{0.0};
    glm::ivec2 points{1};
    glfwGetCursorPos(window_, &now.x, &now.y);
    glfwGetWindowSize(window_, &points.x, &points.y);
    glm::dvec2 const pixelsPerPoint = glm::dvec2{size()} / glm::dvec2{glm::max(points, glm::ivec2{1})};
    input_.mouseMoved = (now - lastMouse_) * pixelsPerPoint;
    input_.mouse = now * pixelsPerPoint;
    lastMouse_ = now;
}

/// The device in a slot in SDL's mapping; none where GLFW has no mapping for it.
std::optional<Gamepad> gamepadIn(int slot) {
    GLFWgamepadstate state{};
    if (!glfwJoystickIsGamepad(slot) || !glfwGetGamepadState(slot, &state)) return std::nullopt;
    Gamepad pad;
    pad.id = slot;
    char const* name = glfwGetGamepadName(slot);
    pad.name = name ? name : "gamepad";
    std::copy(std::begin(state.axes), std::end(state.axes), pad.axes.begin());
    for (PadAxis const trigger : {PadAxis::leftTrigger, PadAxis::rightTrigger}) {
        float& value = pad.axes[static_cast<std::size_t>(trigger)];
        value = 0.5f * (value + 1.0f);
    }
    for (std::size_t i = 0; i < pad.buttons.size(); ++i) pad.buttons[i] = state.buttons[i] == GLFW_PRESS;
    return pad;
}

std::optional<Joystick> joystickIn(int slot) {
    int axes = 0, buttons = 0;
    float const* const values = glfwGetJoystickAxes(slot, &axes);
    unsigned char const* const pressed = glfwGetJoystickButtons(slot, &buttons);
    if (!values || !pressed) return std::nullopt;
    char const* const name = glfwGetJoystickName(slot);
    Joystick stick{slot, name ? name : "joystick", {values, values + axes}, {}};
    for (int i = 0; i < buttons; ++i) stick.buttons.push_back(pressed[i] == GLFW_PRESS);
    return stick;
}

void WindowSurface::pollDevices() {
    input_.gamepads.clear();
    input_.joysticks.clear();
    for (int slot = GLFW_JOYSTICK_1; slot <= GLFW_JOYSTICK_LAST; ++slot) {
        if (!glfwJoystickPresent(slot)) continue;
        if (auto pad = gamepadIn(slot))
            input_.gamepads.push_back(std::move(*pad));
        else if (auto stick = joystickIn(slot))
            input_.joysticks.push_back(std::move(*stick));
    }
}

Input const& WindowSurface::poll() {
    input_.keys.clear();
    input_.text.clear();
    input_.mouseButtons.clear();
    input_.scrolled = glm::dvec2{0.0};
    glfwPollEvents();
    pollMouse();
    pollDevices();
    return input_;
}

void WindowSurface::setFullScreen(bool on) {
    if (on == fullScreen()) return;
    if (!on) {
        glfwSetWindowMonitor(window_, nullptr, windowedBox_.x, windowedBox_.y, windowedBox_.z, windowedBox_.w, 0);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    GLFWvidmode const* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    glfwGetWindowPos(window_, &windowedBox_.x, &windowedBox_.y);
    glfwGetWindowSize(window_, &windowedBox_.z, &windowedBox_.w);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}
}  // namespace

bool hasDisplay() {
    for (char const* variable : {"DISPLAY", "WAYLAND_DISPLAY"})
        if (char const* value = std::getenv(variable); value && *value) return true;
    return false;
}

std::unique_ptr<Surface> openWindow(WindowOptions const& options) {
    if (!hasDisplay())
        throw core::Error{"display", "", "expected a display to open a window on; --headless --seconds S plays without one"};
    return std::make_unique<WindowSurface>(options);
}
}  // namespace luftpost::platform
