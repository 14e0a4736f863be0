// The clouds of the picture: their scene and shadow, the march of a sixteenth of the rays (or of more), the picture made of
// them with the rays of the frames before, the composite.
#pragma once
#include <array>
#include <optional>

#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/render/air_shade.h"
#include "engine/render/cloud_depths.h"
#include "engine/render/cloud_program.h"
#include "engine/render/cloud_scene.h"
#include "engine/render/cloud_shadow.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
/// Order in a frame: describe (any time before), prepare (once the sky's tables are bound; before land and models, which
/// read the shadow), march, resolve, composite (after the air was put before land and sky).
class CloudPass {
public:
    explicit CloudPass(gl::ProgramLibrary& programs);

    /// Cloud map and block of the frame.
    void describe(Snapshot const& snapshot);
    /// The shadow map and the depths toward the light (a tile has those of the whole), and all bindings of the clouds.
    void prepare(FrameContext const& context);
    /// One ray of each block.
    void march(FrameContext const& context);
    /// The other pixels from the frames before; rays for those that nothing is known of.
    void resolve(FrameContext const& context);
    /// Into the colour target; its alpha becomes the transmittance of the clouds.
    void composite(FrameContext const& context);

    /// lib/cloud_store.glsl's facts of the picture's clouds. Null before the first draw and without clouds.
    gl::Texture2D const* facts() const;
    CloudScene const& scene() const { return scene_; }

    /// GPU bytes of noise volumes and cloud map.
    std::size_t bytes() const { return scene_.bytes(); }
    /// GPU bytes of what the clouds keep for each pixel of the picture, of their shadow and of the depths toward the light.
    std::size_t screenBytes() const;

private:
    /// One ray's answer per pixel (lib/cloud_store.glsl).
    struct Store {
        explicit Store(glm::ivec2 const& size);
        gl::Texture2D light, facts;
    };

    /// Takes the store that this frame is written to; those of other sizes are kept as history.
    void takeStore(glm::ivec2 const& size);
    void findAgain(FrameContext const& context);
    void marchAsked();
    Store const& newest() const { return *stores_[static_cast<std::size_t>(newest_)]; }
    Store const& older() const { return *stores_[static_cast<std::size_t>(1 - newest_)]; }

    CloudProgram marchProgram_;
    gl::Program const& resolveProgram_;
    gl::Program const& fillProgram_;
    gl::Program const& compositeProgram_;
    CloudScene scene_;
    CloudShadow shadow_;
    CloudDepths depths_;
    CloudGlow glow_;
    AirShade shade_;
    std::array<std::optional<Store>, 2> stores_;
    gl::Buffer rays_;                // CloudRayList of lib/cloud_rays.glsl
    std::uint64_t frame_ = 0;
    int newest_ = 0;                 // which store holds the latest picture
    bool history_ = false;           // it does
    float exposureBefore_ = 1.0f;
};
}  // namespace luftpost::render
