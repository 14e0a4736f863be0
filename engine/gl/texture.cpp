#include "engine/gl/texture.h"

#include <algorithm>
#include <bit>

#include "engine/core/check.h"
#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace {
glm::ivec3 sizeOfLevel(unsigned target, glm::ivec3 size, int level) {
    size.x = std::max(size.x >> level, 1);
    size.y = std::max(size.y >> level, 1);
    if (target == GL_TEXTURE_3D) size.z = std::max(size.z >> level, 1);
    return size;
}

std::size_t texels(glm::ivec3 const& size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
}
}  // namespace

int fullLevels(glm::ivec3 const& size) {
    int const largest = std::max({size.x, size.y, size.z});
    return std::bit_width(static_cast<unsigned>(largest));
}

Texture::Texture(unsigned target, Format format, glm::ivec3 const& size, int levels, std::string_view label)
    : target_{target}, format_{format}, size_{size}, levels_{levels} {
    CHECK(size.x > 0 && size.y > 0 && size.z > 0 && levels > 0, "texture '{}' of {} x {} x {}", label, size.x, size.y,
          size.z);
    glCreateTextures(target, 1, &id_);
    GLenum const internal = api::info(format).internal;
    if (target == GL_TEXTURE_2D)
        glTextureStorage2D(id_, levels, internal, size.x, size.y);
    else
        glTextureStorage3D(id_, levels, internal, size.x, size.y, size.z);
    for (int level = 0; level < levels; ++level)
        bytes_ += texels(sizeOfLevel(target, size, level)) * static_cast<std::size_t>(texelBytes(format));
    api::label(GL_TEXTURE, id_, label);
    api::countBytes(static_cast<std::ptrdiff_t>(bytes_));
    bool const integer = format == Format::r32ui || format == Format::rgba32ui;
    Filter const mag = integer ? Filter::nearest : Filter::linear;
    setSampling(integer ? Filter::nearest : (levels > 1 ? Filter::linearMipLinear : Filter::linear), mag,
                Wrap::clampToEdge);
}

Texture::~Texture() {
    if (!id_) return;
    glDeleteTextures(1, &id_);
    api::countBytes(-static_cast<std::ptrdiff_t>(bytes_));
}

Texture::Texture(Texture&& other) noexcept
    : id_{std::exchange(other.id_, 0u)},
      target_{other.target_},
      format_{other.format_},
      size_{other.size_},
      levels_{other.levels_},
      bytes_{std::exchange(other.bytes_, 0u)} {}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(target_, other.target_);
    std::swap(format_, other.format_);
    std::swap(size_, other.size_);
    std::swap(levels_, other.levels_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

Texture::Data Texture::data(std::span<std::uint8_t const> t) { return {GL_UNSIGNED_BYTE, t.data(), t.size()}; }
Texture::Data Texture::data(std::span<std::uint16_t const> t) { return {GL_UNSIGNED_SHORT, t.data(), t.size()}; }
Texture::Data Texture::data(std::span<std::uint32_t const> t) { return {GL_UNSIGNED_INT, t.data(), t.size()}; }
Texture::Data Texture::data(std::span<float const> t) { return {GL_FLOAT, t.data(), t.size()}; }

glm::ivec3 Texture::levelSize(int level) const { return sizeOfLevel(target_, size_, level); }

void Texture::write(int level, glm::ivec3 const& offset, glm::ivec3 const& extent, Data const& data) {
    std::size_t const expected = texels(extent) * static_cast<std::size_t>(channels(format_));
    CHECK(data.count == expected, "{} values for {} x {} x {} texels of {} channels", data.count, extent.x, extent.y,
          extent.z, channels(format_));
    GLenum const layout = api::info(format_).layout;
    if (target_ == GL_TEXTURE_2D)
        glTextureSubImage2D(id_, level, offset.x, offset.y, extent.x, extent.y, layout, data.type, data.texels);
    else
        glTextureSubImage3D(id_, level, offset.x, offset.y, offset.z, extent.x, extent.y, extent.z, layout, data.type,
                            data.texels);
}

void Texture::bind(unsigned unit) const { glBindTextureUnit(unit, id_); }

void Texture::bindImage(unsigned unit, Access access, int level) const {
    glBindImageTexture(unit, id_, level, target_ == GL_TEXTURE_2D ? GL_FALSE : GL_TRUE, 0, api::number(access),
                       api::info(format_).internal);
}

void Texture::clear(glm::vec4 const& colour, int level) {
    if (format_ == Format::depth32f) return glClearTexImage(id_, level, GL_DEPTH_COMPONENT, GL_FLOAT, &colour.x);
    if (api::info(format_).type == GL_UNSIGNED_INT) {
        glm::uvec4 const whole{colour};
        return glClearTexImage(id_, level, GL_RGBA_INTEGER, GL_UNSIGNED_INT, &whole.x);
    }
    glClearTexImage(id_, level, GL_RGBA, GL_FLOAT, &colour.x);
}

void Texture::generateMipmaps() { glGenerateTextureMipmap(id_); }

void Texture::setSampling(Filter minFilter, Filter magFilter, Wrap wrap) {
    glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(api::number(minFilter)));
    glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(api::number(magFilter)));
    for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(id_, axis, static_cast<GLint>(api::number(wrap)));
}

std::vector<float> Texture::readFloats(int level) const {
    std::vector<float> values(texels(levelSize(level)) * static_cast<std::size_t>(channels(format_)));
    glGetTextureImage(id_, level, api::info(format_).layout, GL_FLOAT,
                      static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
    return values;
}

std::vector<std::uint8_t> Texture::readBytes(int level) const {
    std::vector<std::uint8_t> values(texels(levelSize(level)) * static_cast<std::size_t>(channels(format_)));
    glGetTextureImage(id_, level, api::info(format_).layout, GL_UNSIGNED_BYTE, static_cast<GLsizei>(values.size()),
                      values.data());
    return values;
}

Texture2D::Texture2D(Format format, glm::ivec2 const& size, int levels, std::string_view label)
    : Texture{GL_TEXTURE_2D, format, glm::ivec3{size, 1}, levels, label} {}

Texture2DArray::Texture2DArray(Format format, glm::ivec2 const& size, int layers, int levels, std::string_view label)
    : Texture{GL_TEXTURE_2D_ARRAY, format, glm::ivec3{size, layers}, levels, label} {}

Texture3D::Texture3D(Format format, glm::ivec3 const& size, int levels, std::string_view label)
    : Texture{GL_TEXTURE_3D, format, size, levels, label} {}
}  // namespace luftpost::gl
