// In C++ a sampler3D is a view of 8-bit RGBA volumes that somebody else owns (weather/noise_volume.h), read as GLSL
// reads a texture with linear filtering, the nearest mipmap and repetition; a billowSampler is the same of volumes of one channel, a planeSampler
// of volumes one texel high. In GLSL they are the built-in ones.
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
    std::uint8_t const* texels = nullptr;  // RGBA, of a billowSampler R alone; x fastest, then y, then z
    ivec3 size{0};                         // powers of two
};

struct sampler3D {
    VolumeLevel const* levels = nullptr;
    int levelCount = 0;
};

inline std::uint8_t const* volumeTexel(VolumeLevel const& level, int x, int y, int z) {
    return level.texels + 4 * ((z * level.size.y + y) * level.size.x + x);
}

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

/// The eight texels around a place, and how far it lies from the lowest to the highest of them, 0..1.
struct Corners {
    ivec3 low, high;
    vec3 share;
};
inline Corners cornersAround(VolumeLevel const& level, vec3 const& unit) {
    vec3 const p = unit * vec3{level.size} - 0.5f;
    vec3 const corner = floor(p);
    ivec3 const low = ivec3{corner} & (level.size - 1);
    return {low, (low + 1) & (level.size - 1), p - corner};
}

/// Eight texels of one level, weighted; values 0..255.
inline vec4 volumeLinear(VolumeLevel const& level, vec3 const& unit) {
    Corners const c = cornersAround(level, unit);
    auto const row = [&](int y, int z) {
        return between(texelAt(volumeTexel(level, c.low.x, y, z)), texelAt(volumeTexel(level, c.high.x, y, z)), c.share.x);
    };
    return channelsOf(between(between(row(c.low.y, c.low.z), row(c.high.y, c.low.z), c.share.y), between(row(c.low.y, c.high.z), row(c.high.y, c.high.z), c.share.y), c.share.z));
}

struct billowSampler {
    VolumeLevel const* levels = nullptr;
    int levelCount = 0;
};

/// Eight texels of one channel, weighted; 0..255.
inline float billowLinear(VolumeLevel const& level, vec3 const& unit) {
    Corners const c = cornersAround(level, unit);
    auto const row = [&](int y, int z) {
        std::uint8_t const* const texels = level.texels + (z * level.size.y + y) * level.size.x;
        return static_cast<float>(texels[c.low.x]) * (1.0f - c.share.x) + static_cast<float>(texels[c.high.x]) * c.share.x;
    };
    float const low = row(c.low.y, c.low.z) * (1.0f - c.share.y) + row(c.high.y, c.low.z) * c.share.y;
    float const high = row(c.low.y, c.high.z) * (1.0f - c.share.y) + row(c.high.y, c.high.z) * c.share.y;
    return low * (1.0f - c.share.z) + high * c.share.z;
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
    auto const row = [&](int y) { return between(texelAt(volumeTexel(level, x0, y, 0)), texelAt(volumeTexel(level, x1, y, 0)), f.x); };
    return channelsOf(between(row(y0), row(y1), f.y));
}

/// The nearest of a volume's levels.
inline VolumeLevel const& nearestLevel(VolumeLevel const* levels, int count, float lod) {
    return levels[static_cast<int>(clamp(lod, 0.0f, static_cast<float>(count - 1)) + 0.5f)];
}

inline vec4 textureLod(sampler3D const& volume, vec3 const& unit, float lod) {
    return volumeLinear(nearestLevel(volume.levels, volume.levelCount, lod), unit) * (1.0f / 255.0f);
}

inline vec4 textureLod(billowSampler const& volume, vec3 const& unit, float lod) {
    return vec4{billowLinear(nearestLevel(volume.levels, volume.levelCount, lod), unit) * (1.0f / 255.0f), 0.0f, 0.0f, 1.0f};
}

inline vec4 textureLod(planeSampler const& plane, vec2 const& unit, float lod) {
    return planeLinear(nearestLevel(plane.levels, plane.levelCount, lod), unit) * (1.0f / 255.0f);
}
}  // namespace luftpost::glsl
#else
#define planeSampler sampler2D
#define billowSampler sampler3D
#endif
#endif
