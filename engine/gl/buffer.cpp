#include "engine/gl/buffer.h"

#include "engine/core/check.h"
#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace {
unsigned create(std::size_t bytes, void const* content, GLbitfield flags, std::string_view label) {
    CHECK(bytes > 0, "buffer '{}' of no bytes", label);
    GLuint id = 0;
    glCreateBuffers(1, &id);
    glNamedBufferStorage(id, api::sizeiptr(bytes), content, flags);
    api::label(GL_BUFFER, id, label);
    api::countBytes(static_cast<std::ptrdiff_t>(bytes));
    return id;
}
}  // namespace

Buffer::Buffer(std::size_t bytes, std::string_view label)
    : id_{create(bytes, nullptr, GL_DYNAMIC_STORAGE_BIT, label)}, bytes_{bytes} {}

Buffer::Buffer(std::span<std::byte const> content, std::string_view label)
    : id_{create(content.size(), content.data(), 0, label)}, bytes_{content.size()} {}

Buffer::~Buffer() {
    if (!id_) return;
    glDeleteBuffers(1, &id_);
    api::countBytes(-static_cast<std::ptrdiff_t>(bytes_));
}

void Buffer::update(std::span<std::byte const> content, std::size_t offset) {
    CHECK(offset + content.size() <= bytes_, "{} bytes at {} into a buffer of {}", content.size(), offset, bytes_);
    if (!content.empty())
        glNamedBufferSubData(id_, api::sizeiptr(offset), api::sizeiptr(content.size()), content.data());
}

void Buffer::read(std::span<std::byte> content, std::size_t offset) const {
    CHECK(offset + content.size() <= bytes_, "{} bytes at {} of a buffer of {}", content.size(), offset, bytes_);
    glGetNamedBufferSubData(id_, api::sizeiptr(offset), api::sizeiptr(content.size()), content.data());
}

void Buffer::clear() { glClearNamedBufferData(id_, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr); }
void Buffer::bindUniform(unsigned binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, id_); }
void Buffer::bindStorage(unsigned binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, id_); }
}  // namespace luftpost::gl
