// Owner of a sampler object.
#pragma once
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "engine/gl/types.h"

namespace luftpost::gl {
struct SamplerSettings {
    Filter minFilter = Filter::linear;
    Filter magFilter = Filter::linear;
    Wrap wrap = Wrap::clampToEdge;
    bool compareDepth = false;                // sampler2DShadow: passes where reference >= texel (reversed depth)
    glm::vec4 border{0.0f, 0.0f, 0.0f, 0.0f};  // of Wrap::clampToBorder
};

class Sampler {
public:
    Sampler() = default;
    explicit Sampler(SamplerSettings const& settings, std::string_view label = {});
    ~Sampler();
    Sampler(Sampler&& other) noexcept : id_{std::exchange(other.id_, 0u)} {}
    Sampler& operator=(Sampler&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    unsigned id() const { return id_; }
    void bind(unsigned unit) const;
    /// Texture unit `unit` goes back to the texture's own sampling.
    static void unbind(unsigned unit);

private:
    unsigned id_ = 0;
};
}  // namespace luftpost::gl
