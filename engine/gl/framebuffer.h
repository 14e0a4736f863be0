// Owner of a framebuffer object.
#pragma once
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "engine/gl/texture.h"

namespace luftpost::gl {
/// Draws into textures that outlive it. Id 0 is empty (not the window's framebuffer; see bindWindow).
class Framebuffer {
public:
    Framebuffer() = default;
    /// Colour attachments in the order of the fragment shader's outputs; all of one size; either may be missing.
    Framebuffer(std::initializer_list<Texture2D const*> colours, Texture2D const* depth, std::string_view label = {});
    /// One layer of an array as depth attachment.
    Framebuffer(Texture2DArray const& depth, int layer, std::string_view label = {});
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept
        : id_{std::exchange(other.id_, 0u)}, size_{std::exchange(other.size_, glm::ivec2{0})} {}
    Framebuffer& operator=(Framebuffer&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(size_, other.size_);
        return *this;
    }
    unsigned id() const { return id_; }
    glm::ivec2 size() const { return size_; }

    /// Makes it the target of draws; the viewport covers it.
    void bind() const;
    void clearColour(int attachment, glm::vec4 const& colour) const;
    /// Reversed depth: 0 is far.
    void clearDepth(float depth = 0.0f) const;
    /// Copies the first colour attachment to the window's framebuffer of `windowSize` pixels.
    void copyToWindow(glm::ivec2 const& windowSize) const;

    static void bindWindow(glm::ivec2 const& windowSize);

private:
    unsigned id_ = 0;
    glm::ivec2 size_{0};
};
}  // namespace luftpost::gl
