// Owner of a vertex array object: how a draw finds its vertices.
#pragma once
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include "engine/gl/buffer.h"
#include "engine/gl/types.h"

namespace luftpost::gl {
/// One input of the vertex shader: layout(location = `location`).
struct Attribute {
    unsigned location = 0;
    int components = 4;
    AttributeType type = AttributeType::float32;
    unsigned offset = 0;      // bytes from the start of the vertex
    bool normalised = false;  // integers read as 0..1 floats
    bool integer = false;     // integers read as integers
};

/// The vertices (or instances) of one buffer, which outlives the vertex array.
struct VertexSource {
    Buffer const* buffer = nullptr;
    int stride = 0;           // bytes from one vertex to the next
    std::span<Attribute const> attributes;
    unsigned divisor = 0;     // 1: one element an instance
    std::size_t offset = 0;   // bytes to the first vertex
};

class VertexArray {
public:
    /// Empty: no object.
    VertexArray() = default;
    VertexArray(std::initializer_list<VertexSource> sources, Buffer const* indices = nullptr,
                IndexType indexType = IndexType::none, std::string_view label = {});
    /// An object with no attributes, for shaders that count gl_VertexID.
    static VertexArray withoutAttributes();
    ~VertexArray();
    VertexArray(VertexArray&& other) noexcept
        : id_{std::exchange(other.id_, 0u)}, indexType_{other.indexType_} {}
    VertexArray& operator=(VertexArray&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(indexType_, other.indexType_);
        return *this;
    }
    unsigned id() const { return id_; }
    IndexType indexType() const { return indexType_; }

    /// Points source number `source` at another buffer.
    void setSource(unsigned source, Buffer const& buffer, int stride, std::size_t offset = 0);

private:
    unsigned id_ = 0;
    IndexType indexType_ = IndexType::none;
};
}  // namespace luftpost::gl
