// What belongs to the whole context: its debug output, the count of errors, the bytes its objects hold.
// All of engine/gl is for the thread in which the context is current.
#pragma once
#include <cstddef>
#include <string>

namespace luftpost::gl {
/// Readies the current context: checks for GL 4.5, hooks up the debug output, sets zero-to-one clip depth.
/// Throws core::Error when the context is older.
void prepareContext();

/// GL errors since the program started (the debug output's errors; a shader that does not compile is not one,
/// it is a core::Error of the program that asked for it).
int errorCount();
/// The latest error's text, empty when there was none.
std::string lastError();

/// Bytes of all buffers and textures alive, as the owners asked for them.
std::size_t allocatedBytes();

/// GL_RENDERER and GL_VERSION of the current context.
std::string rendererName();
std::string versionName();
/// True when the renderer runs on the processor (llvmpipe, softpipe, SwiftShader).
bool isSoftware();

/// Blocks until the GPU has done all that was asked.
void finish();
}  // namespace luftpost::gl
