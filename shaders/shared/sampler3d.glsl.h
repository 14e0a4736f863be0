// In C++ a sampler3D is a view of 8-bit volumes of one channel that somebody else owns (weather/noise_volume.h), read as GLSL
// reads a texture with linear filtering, the nearest mipmap and repetition; a planeSampler is the same of RGBA volumes one texel
// high. In GLSL they are the built-in ones.
#ifndef LUFTPOST_SAMPLER3D_GLSL_H
#define LUFTPOST_SAMPLER3D_GLSL_H
#include "shaders/shared/language.glsl.h"
#ifdef __cplusplus
#include <cstdint>
#include <cstring>
#ifdef __SSE2__
#include <emmintrin.h>
#endif
namespace luftpost::glsl {
using namespace glm;
struct VolumeLevel {
    std::uint8_t const* texels = nullptr;  // R, of a planeSampler RGBA; x fastest, then y, then z
    ivec3 size{0};                         // powers of two
};

struct sampler3D {
    VolumeLevel const* levels = nullptr;
    int levelCount = 0;
};

#ifdef __SSE2__
// Four channels at once; the same operations in the same order as below, so the same bits.
using Texel = __m128;
inline Texel texelAt(std::uint8_t const* t) {
    int packed = 0;
    std::memcpy(&packed, t, sizeof packed);
    __m128i const zero = _mm_setzero_si128();
    return _mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_unpacklo_epi8(_mm_cvtsi32_si128(packed), zero), zero));
}
inline Texel between(Texel a, Texel b, float f) {
    return _mm_add_ps(_mm_mul_ps(a, _mm_set1_ps(1.0f - f)), _mm_mul_ps(b, _mm_set1_ps(f)));
}
inline vec4 channelsOf(Texel t) {
    vec4 result;
    _mm_storeu_ps(&result.x, t);
    return result;
}
#else
using Texel = vec4;
inline Texel texelAt(std::uint8_t const* t) { return vec4{t[0], t[1], t[2], t[3]}; }
inline Texel between(Texel const& a, Texel const& b, float f) { return a * (1.0f - f) + b * f; }
inline vec4 channelsOf(Texel const& t) { return t; }
#endif

/// Eight texels of one level, weighted; 0..255.
inline float volumeLinear(VolumeLevel const& level, vec3 const& unit) {
    vec3 const p = unit * vec3{level.size} - 0.5f;
    vec3 const corner = floor(p);
    vec3 const f = p - corner;
    ivec3 const low = ivec3{corner} & (level.size - 1);
    ivec3 const high = (low + 1) & (level.size - 1);
    auto const row = [&](int y, int z) {
        std::uint8_t const* const texels = level.texels + (z * level.size.y + y) * level.size.x;
        return static_cast<float>(texels[low.x]) * (1.0f - f.x) + static_cast<float>(texels[high.x]) * f.x;
    };
    float const near = row(low.y, low.z) * (1.0f - f.y) + row(high.y, low.z) * f.y;
    float const far = row(low.y, high.z) * (1.0f - f.y) + row(high.y, high.z) * f.y;
    return near * (1.0f - f.z) + far * f.z;
}

struct planeSampler {
    VolumeLevel const* levels = nullptr;
    int levelCount = 0;
};

/// Four texels of one level, weighted; values 0..255.
inline vec4 planeLinear(VolumeLevel const& level, vec2 const& unit) {
    vec2 const p = unit * vec2{ivec2{level.size}} - 0.5f;
    vec2 const corner = floor(p);
    vec2 const f = p - corner;
    int const x0 = static_cast<int>(corner.x) & (level.size.x - 1), x1 = (x0 + 1) & (level.size.x - 1);
    int const y0 = static_cast<int>(corner.y) & (level.size.y - 1), y1 = (y0 + 1) & (level.size.y - 1);
    auto const texel = [&](int x, int y) { return texelAt(level.texels + 4 * (y * level.size.x + x)); };
    auto const row = [&](int y) { return between(texel(x0, y), texel(x1, y), f.x); };
    return channelsOf(between(row(y0), row(y1), f.y));
}

/// The nearest of a volume's levels.
inline VolumeLevel const& nearestLevel(VolumeLevel const* levels, int count, float lod) {
    return levels[static_cast<int>(clamp(lod, 0.0f, static_cast<float>(count - 1)) + 0.5f)];
}

inline vec4 textureLod(sampler3D const& volume, vec3 const& unit, float lod) {
    return vec4{volumeLinear(nearestLevel(volume.levels, volume.levelCount, lod), unit) * (1.0f / 255.0f), 0.0f, 0.0f, 1.0f};
}

inline vec4 textureLod(planeSampler const& plane, vec2 const& unit, float lod) {
    return planeLinear(nearestLevel(plane.levels, plane.levelCount, lod), unit) * (1.0f / 255.0f);
}
}  // namespace luftpost::glsl
#else
#define planeSampler sampler2D
#endif
#endif
