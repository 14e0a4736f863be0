// Owner of a GL buffer of immutable size.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace luftpost::gl {
/// Any buffer: vertices, indices, uniform or storage block. Id 0 is empty.
class Buffer {
public:
    Buffer() = default;
    /// `bytes` of undefined content, writable by update().
    explicit Buffer(std::size_t bytes, std::string_view label = {});
    /// Holds a copy of `content` that does not change (update() is an error).
    explicit Buffer(std::span<std::byte const> content, std::string_view label = {});
    ~Buffer();
    Buffer(Buffer&& other) noexcept : id_{std::exchange(other.id_, 0u)}, bytes_{std::exchange(other.bytes_, 0u)} {}
    Buffer& operator=(Buffer&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }

    unsigned id() const { return id_; }
    std::size_t bytes() const { return bytes_; }

    void update(std::span<std::byte const> content, std::size_t offset = 0);
    void read(std::span<std::byte> content, std::size_t offset = 0) const;
    /// Fills the buffer with zero bytes.
    void clear();
    void bindUniform(unsigned binding) const;
    void bindStorage(unsigned binding) const;

private:
    unsigned id_ = 0;
    std::size_t bytes_ = 0;
};

/// The bytes of a trivially copyable object or of a contiguous range, for Buffer and Texture.
template <class T>
std::span<std::byte const> bytesOf(T const& object) {
    return std::as_bytes(std::span{&object, 1});
}
template <class T>
std::span<std::byte const> bytesOfRange(T const& range) {
    return std::as_bytes(std::span{std::data(range), std::size(range)});
}
}  // namespace luftpost::gl
