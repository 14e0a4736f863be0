#include "engine/gl/context.h"

#include <spdlog/spdlog.h>

#include <atomic>

#include "engine/core/error.h"
#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace {
std::atomic<int> errors{0};
std::atomic<std::ptrdiff_t> bytes{0};
std::string latestError;

void onMessage(GLenum source, GLenum type, GLuint, GLenum, GLsizei length, GLchar const* message, void const*) {
    if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    ++errors;
    latestError.assign(message, length > 0 ? static_cast<std::size_t>(length) : 0u);
    spdlog::error("GL: {}", latestError);
}

std::string text(GLenum what) {
    auto const* found = reinterpret_cast<char const*>(glGetString(what));
    return found ? found : "";
}
}  // namespace

namespace api {
void label(GLenum kind, GLuint id, std::string_view name) {
    if (!name.empty()) glObjectLabel(kind, id, static_cast<GLsizei>(name.size()), name.data());
}
void countBytes(std::ptrdiff_t change) { bytes += change; }
}  // namespace api

void prepareContext() {
    if (int const version = epoxy_gl_version(); version < 45)
        throw core::Error{"graphics driver", rendererName(),
                          fmt::format("expected OpenGL 4.5, found {}.{}", version / 10, version % 10)};
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    if (epoxy_has_gl_extension("GL_KHR_parallel_shader_compile")) glMaxShaderCompilerThreadsKHR(~0u);  // as many as the driver likes
}

int errorCount() { return errors; }
std::string lastError() { return latestError; }
std::size_t allocatedBytes() { return static_cast<std::size_t>(bytes.load()); }
std::string rendererName() { return text(GL_RENDERER); }
std::string versionName() { return text(GL_VERSION); }

bool isSoftware() {
    std::string const name = rendererName();
    for (char const* known : {"llvmpipe", "softpipe", "SwiftShader", "swrast"})
        if (name.find(known) != std::string::npos) return true;
    return false;
}

void finish() { glFinish(); }
}  // namespace luftpost::gl
