// In C++ a sampler2D is a view of texels that somebody else owns, read as GLSL reads a texture with linear filtering
// that clamps to the edge. In GLSL it is the built-in one and nothing is needed.
#ifndef LUFTPOST_SAMPLER2D_GLSL_H
#define LUFTPOST_SAMPLER2D_GLSL_H
#include "shaders/shared/language.glsl.h"
#ifdef __cplusplus
namespace luftpost::glsl {
using namespace glm;
struct sampler2D {
    vec4 const* texels = nullptr;  // row by row, width * height
    int width = 0;
    int height = 0;
};

inline vec4 textureLod(sampler2D const& image, vec2 uv, float) {
    float const x = clamp(uv.x * static_cast<float>(image.width) - 0.5f, 0.0f, static_cast<float>(image.width - 1));
    float const y = clamp(uv.y * static_cast<float>(image.height) - 0.5f, 0.0f, static_cast<float>(image.height - 1));
    int const x0 = min(static_cast<int>(x), image.width - 2);
    int const y0 = min(static_cast<int>(y), image.height - 2);
    vec4 const* row = image.texels + y0 * image.width + x0;
    float const fx = x - static_cast<float>(x0);
    float const fy = y - static_cast<float>(y0);
    return mix(mix(row[0], row[1], fx), mix(row[image.width], row[image.width + 1], fx), fy);
}
}  // namespace luftpost::glsl
#endif
#endif
