// In C++ a sampler3D is a view of 8-bit RGBA volumes that somebody else owns (weather/noise_volume.h), read as GLSL
// reads a texture with linear filtering, the nearest mipmap and repetition. In GLSL it is the built-in one.
#ifndef LUFTPOST_SAMPLER3D_GLSL_H
#define LUFTPOST_SAMPLER3D_GLSL_H
#include "shaders/shared/language.glsl.h"
#ifdef __cplusplus
namespace luftpost::glsl {
using namespace glm;
struct VolumeLevel {
    std::uint8_t const* texels = nullptr;  // RGBA, x fastest, then y, then z
    ivec3 size{0};                         // powers of two
};

struct sampler3D {
    VolumeLevel const* levels = nullptr;
    int levelCount = 0;
};

inline vec4 volumeTexel(VolumeLevel const& level, int x, int y, int z) {
    std::uint8_t const* t = level.texels + 4 * ((z * level.size.y + y) * level.size.x + x);
    return vec4{t[0], t[1], t[2], t[3]};
}

/// Eight texels of one level, weighted; values 0..255.
inline vec4 volumeLinear(VolumeLevel const& level, vec3 const& unit) {
    vec3 const p = unit * vec3{level.size} - 0.5f;
    vec3 const corner = floor(p);
    vec3 const f = p - corner;
    int const x0 = static_cast<int>(corner.x) & (level.size.x - 1), x1 = (x0 + 1) & (level.size.x - 1);
    int const y0 = static_cast<int>(corner.y) & (level.size.y - 1), y1 = (y0 + 1) & (level.size.y - 1);
    int const z0 = static_cast<int>(corner.z) & (level.size.z - 1), z1 = (z0 + 1) & (level.size.z - 1);
    auto const row = [&](int y, int z) {
        return mix(volumeTexel(level, x0, y, z), volumeTexel(level, x1, y, z), f.x);
    };
    return mix(mix(row(y0, z0), row(y1, z0), f.y), mix(row(y0, z1), row(y1, z1), f.y), f.z);
}

inline vec4 textureLod(sampler3D const& volume, vec3 const& unit, float lod) {
    int const level = static_cast<int>(clamp(lod, 0.0f, static_cast<float>(volume.levelCount - 1)) + 0.5f);
    return volumeLinear(volume.levels[level], unit) * (1.0f / 255.0f);
}
}  // namespace luftpost::glsl
#endif
#endif
