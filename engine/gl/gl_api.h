// Inside engine/gl only: the GL functions, the numbers behind types.h, the books of allocated bytes.
#pragma once
#include <epoxy/gl.h>

#include <cstddef>
#include <string_view>

#include "engine/gl/types.h"

namespace luftpost::gl::api {
struct FormatInfo {
    GLenum internal, layout, type;
    int channels, bytes;
};
FormatInfo const& info(Format format);
GLenum number(Filter filter);
GLenum number(Wrap wrap);
GLenum number(Access access);
GLenum number(Primitive primitive);
GLenum number(IndexType type);
GLenum number(AttributeType type);
GLenum number(Compare compare);
GLenum number(Stage stage);

void label(GLenum kind, GLuint id, std::string_view text);
void countBytes(std::ptrdiff_t change);

constexpr GLsizeiptr sizeiptr(std::size_t bytes) { return static_cast<GLsizeiptr>(bytes); }
}  // namespace luftpost::gl::api
