// The words of the GL layer: formats, filters, states. The enumerators' meaning is GL's; the numbers stay in engine/gl.
#pragma once
#include <cstdint>

namespace luftpost::gl {
/// Internal formats of textures. `srgba8` is decoded to linear by the sampler.
enum class Format {
    r8, rg8, rgba8, srgba8,
    r16, rg16, rgba16,
    r16f, rg16f, rgba16f, r11g11b10f,
    r32f, rg32f, rgba32f,
    r32ui, rgba32ui,
    depth32f
};
enum class Filter { nearest, linear, nearestMipNearest, linearMipNearest, linearMipLinear };
enum class Wrap { repeat, mirror, clampToEdge, clampToBorder };
enum class Access { read, write, readWrite };
enum class Primitive { points, lines, lineStrip, triangles, triangleStrip, patches };
enum class IndexType { none, uint16, uint32 };
enum class AttributeType { float32, int32, uint32, uint16, uint8 };
enum class Compare { never, less, lessEqual, equal, greaterEqual, greater, always };
enum class Blend { none, alpha, premultiplied, add, multiply };
enum class Cull { none, back, front };
enum class Stage { vertex, geometry, fragment, compute };

/// Channels of a format; bytes of one texel of it.
int channels(Format format);
int texelBytes(Format format);
}  // namespace luftpost::gl
