// Shader text with its includes resolved: pure string code, no GL.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luftpost::assets {
/// A shader ready for the compiler. `#line L F` directives in `text` mean line L of `files[F]`.
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  // relative to the shaders folder: "pass/sky.comp", "lib/noise.glsl"
};

/// Gives the text of a file named relative to the shaders folder; throws core::Error when there is none.
using ReadShader = std::function<std::string(std::string const& relative)>;

/// Resolves `#include "lib/x.glsl"` (relative to the shaders folder; "shaders/lib/x.glsl" means the same, for files
/// that C++ includes as well; "../lib/x.glsl" is relative to the file that includes) in `file`. A file is included once; a file that includes itself, however far round, is
/// a core::Error that names the chain. `#pragma once` and `#include <...>` (C++'s) become empty lines. Each of
/// `defines` ("NAME VALUE") becomes a #define after the #version line.
ShaderSource resolveShader(std::string const& file, ReadShader const& read, std::span<std::string const> defines = {});

/// A driver's messages with its "FILE:LINE" or "FILE(LINE)" numbers replaced by our file names and lines.
std::string namedMessages(std::string_view messages, std::span<std::string const> files);
}  // namespace luftpost::assets
