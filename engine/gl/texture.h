// Owners of textures of immutable size: 2D, 3D, and arrays of 2D layers.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "engine/gl/types.h"

namespace luftpost::gl {
/// What the three kinds share. Texel data is tightly packed rows, first row at texture coordinate 0, with the
/// format's channels; the element type of the span says the data's type (8 or 16 bit normalised, 32-bit float or
/// unsigned; halves are handed over as floats and converted by the driver).
class Texture {
public:
    unsigned id() const { return id_; }
    Format format() const { return format_; }
    int levels() const { return levels_; }
    std::size_t bytes() const { return bytes_; }

    /// Makes the texture visible to samplers of texture unit `unit` (layout(binding = unit)). The filter is that of
    /// the Sampler bound to the unit, else: linear with mipmaps if it has them, clamped to the edge.
    void bind(unsigned unit) const;
    /// Binds one level, all its layers, as image of `unit`.
    void bindImage(unsigned unit, Access access, int level = 0) const;
    /// Fills level `level` with one colour.
    void clear(glm::vec4 const& colour = glm::vec4{0.0f}, int level = 0);
    void generateMipmaps();
    /// The filter and wrap used where no Sampler is bound.
    void setSampling(Filter minFilter, Filter magFilter, Wrap wrap);
    /// All texels of a level as floats, channels interleaved.
    std::vector<float> readFloats(int level = 0) const;
    /// All texels of a level as 8-bit normalised values, channels interleaved.
    std::vector<std::uint8_t> readBytes(int level = 0) const;

protected:
    Texture() = default;
    Texture(unsigned target, Format format, glm::ivec3 const& size, int levels, std::string_view label);
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    struct Data {
        unsigned type;
        void const* texels;
        std::size_t count;
    };
    static Data data(std::span<std::uint8_t const> texels);
    static Data data(std::span<std::uint16_t const> texels);
    static Data data(std::span<std::uint32_t const> texels);
    static Data data(std::span<float const> texels);
    void write(int level, glm::ivec3 const& offset, glm::ivec3 const& extent, Data const& data);
    glm::ivec3 levelSize(int level) const;

    unsigned id_ = 0;
    unsigned target_ = 0;
    Format format_ = Format::rgba8;
    glm::ivec3 size_{0};
    int levels_ = 0;
    std::size_t bytes_ = 0;
};

/// Number of levels down to 1 x 1 (x 1).
int fullLevels(glm::ivec3 const& size);

class Texture2D : public Texture {
public:
    Texture2D() = default;
    Texture2D(Format format, glm::ivec2 const& size, int levels = 1, std::string_view label = {});
    glm::ivec2 size() const { return {size_.x, size_.y}; }
    template <class T>
    void upload(std::span<T const> texels, int level = 0) {
        glm::ivec3 const whole = levelSize(level);
        write(level, glm::ivec3{0}, whole, data(texels));
    }
    template <class T>
    void uploadRegion(glm::ivec2 const& offset, glm::ivec2 const& extent, std::span<T const> texels, int level = 0) {
        write(level, glm::ivec3{offset, 0}, glm::ivec3{extent, 1}, data(texels));
    }
};

class Texture2DArray : public Texture {
public:
    Texture2DArray() = default;
    Texture2DArray(Format format, glm::ivec2 const& size, int layers, int levels = 1, std::string_view label = {});
    glm::ivec2 size() const { return {size_.x, size_.y}; }
    int layers() const { return size_.z; }
    template <class T>
    void uploadLayer(int layer, std::span<T const> texels, int level = 0) {
        glm::ivec3 const whole = levelSize(level);
        write(level, glm::ivec3{0, 0, layer}, glm::ivec3{whole.x, whole.y, 1}, data(texels));
    }
};

class Texture3D : public Texture {
public:
    Texture3D() = default;
    Texture3D(Format format, glm::ivec3 const& size, int levels = 1, std::string_view label = {});
    glm::ivec3 size() const { return size_; }
    template <class T>
    void upload(std::span<T const> texels, int level = 0) {
        write(level, glm::ivec3{0}, levelSize(level), data(texels));
    }
};
}  // namespace luftpost::gl
