// EGL without a window: first Mesa's surfaceless platform, then any device.
#include <epoxy/egl.h>

#include <array>
#include <cstring>
#include <vector>

#include "engine/core/error.h"
#include "engine/platform/surface.h"

namespace luftpost::platform {
namespace {
bool clientHas(char const* extension) {
    char const* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return all && std::strstr(all, extension);
}

/// An initialised display, or EGL_NO_DISPLAY.
EGLDisplay initialised(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_DISPLAY;
    return display;
}

std::vector<EGLDisplay> candidates() {
    std::vector<EGLDisplay> displays;
    if (clientHas("EGL_MESA_platform_surfaceless"))
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    if (clientHas("EGL_EXT_platform_device") && clientHas("EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count))
            for (EGLint i = 0; i < count; ++i)
                displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                            devices[static_cast<std::size_t>(i)], nullptr));
    }
    return displays;
}

EGLContext coreContext(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    EGLint const attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4,
                                 EGL_CONTEXT_MINOR_VERSION, 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE,
                                 EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

class HeadlessSurface : public Surface {
public:
    HeadlessSurface(EGLDisplay display, EGLContext context, glm::ivec2 const& size)
        : display_{display}, context_{context}, size_{size} {}
    HeadlessSurface(HeadlessSurface const&) = delete;
    HeadlessSurface& operator=(HeadlessSurface const&) = delete;
    ~HeadlessSurface() override {
        if (eglGetCurrentContext() == context_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    void makeCurrent() override {
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw core::Error{"graphics driver", "EGL", "expected a context that can be made current without a surface"};
    }
    void swap() override {}
    glm::ivec2 size() const override { return size_; }
    bool hasWindow() const override { return false; }
    Input const& poll() override { return input_; }

private:
    EGLDisplay display_;
    EGLContext context_;
    glm::ivec2 size_;
    Input input_;
};
}  // namespace

std::unique_ptr<Surface> openHeadless(glm::ivec2 const& size) {
    for (EGLDisplay const candidate : candidates()) {
        EGLDisplay const display = initialised(candidate);
        if (display == EGL_NO_DISPLAY) continue;
        EGLContext const context = coreContext(display);
        if (context == EGL_NO_CONTEXT) continue;
        auto surface = std::make_unique<HeadlessSurface>(display, context, size);
        surface->makeCurrent();
        return surface;
    }
    throw core::Error{"graphics driver", "EGL", "expected an OpenGL 4.5 core context without a window, found none"};
}
}  // namespace luftpost::platform
