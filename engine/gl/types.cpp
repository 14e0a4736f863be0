#include "engine/gl/types.h"

#include <array>

#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace api {
namespace {
template <class T, std::size_t N>
GLenum pick(std::array<GLenum, N> const& numbers, T value) {
    return numbers[static_cast<std::size_t>(value)];
}
}  // namespace

FormatInfo const& info(Format format) {
    static constexpr std::array<FormatInfo, 17> kInfos{{
        {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1, 1},
        {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2, 2},
        {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, 4},
        {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, 4},
        {GL_R16, GL_RED, GL_UNSIGNED_SHORT, 1, 2},
        {GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 2, 4},
        {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, 4, 8},
        {GL_R16F, GL_RED, GL_HALF_FLOAT, 1, 2},
        {GL_RG16F, GL_RG, GL_HALF_FLOAT, 2, 4},
        {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 4, 8},
        {GL_R11F_G11F_B10F, GL_RGB, GL_FLOAT, 3, 4},
        {GL_R32F, GL_RED, GL_FLOAT, 1, 4},
        {GL_RG32F, GL_RG, GL_FLOAT, 2, 8},
        {GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, 16},
        {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1, 4},
        {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4, 16},
        {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4},
    }};
    return kInfos[static_cast<std::size_t>(format)];
}

GLenum number(Filter filter) {
    return pick(std::array<GLenum, 5>{GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                      GL_LINEAR_MIPMAP_LINEAR},
                filter);
}
GLenum number(Wrap wrap) {
    return pick(std::array<GLenum, 4>{GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER}, wrap);
}
GLenum number(Access access) {
    return pick(std::array<GLenum, 3>{GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE}, access);
}
GLenum number(Primitive primitive) {
    return pick(
        std::array<GLenum, 6>{GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_PATCHES},
        primitive);
}
GLenum number(IndexType type) {
    return pick(std::array<GLenum, 3>{GL_NONE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT}, type);
}
GLenum number(AttributeType type) {
    return pick(std::array<GLenum, 5>{GL_FLOAT, GL_INT, GL_UNSIGNED_INT, GL_UNSIGNED_SHORT, GL_UNSIGNED_BYTE}, type);
}
GLenum number(Compare compare) {
    return pick(
        std::array<GLenum, 7>{GL_NEVER, GL_LESS, GL_LEQUAL, GL_EQUAL, GL_GEQUAL, GL_GREATER, GL_ALWAYS}, compare);
}
GLenum number(Stage stage) {
    return pick(std::array<GLenum, 4>{GL_VERTEX_SHADER, GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER, GL_COMPUTE_SHADER},
                stage);
}
}  // namespace api

int channels(Format format) { return api::info(format).channels; }
int texelBytes(Format format) { return api::info(format).bytes; }
}  // namespace luftpost::gl
