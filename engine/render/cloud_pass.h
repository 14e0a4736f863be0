// The clouds of the picture: their scene and shadow, the march of a sixteenth of the rays (or of more), the picture made of
// them with the rays of the frames before, the composite.
#pragma once
#include <array>
#include <optional>

#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/render/cloud_depths.h"
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
    /// The shadow map and the depths toward the light, and all bindings of the clouds.
    void prepare(FrameContext const& context);
    /// One ray of each block.
    void march(FrameContext const& context);
    /// The other pixels from the frames before; rays for those that nothing is known of.
    void resolve(FrameContext const& context);
    /// Into the colour target; its alpha becomes the transmittance of the clouds.
    void composite(FrameContext const& context);

    /// GPU bytes of noise volumes and cloud map.
    std::size_t bytes() const { return scene_.bytes(); }
    /// GPU bytes of what the clouds keep for each pixel of the picture, of their shadow and of the depths toward the light.
    std::size_t screenBytes() const;

private:
    /// One ray's answer per pixel (lib/cloud_store.glsl): the newest, and that of the frame before once there is one.
    struct Screen {
        explicit Screen(glm::ivec2 const& size);
        /// What frames with a history need besides.
        void prepareHistory();
        glm::ivec2 size;
        std::array<gl::Texture2D, 2> light, facts;
        gl::Buffer rays;  // CloudRayList of lib/cloud_rays.glsl
    };

    void prepareScreen(glm::ivec2 const& size);
    void bindStore() const;
    void findAgain(FrameContext const& context);
    void marchAsked();
    std::size_t newest() const { return static_cast<std::size_t>(newest_); }

    gl::Program const& marchProgram_;
    gl::Program const& resolveProgram_;
    gl::Program const& listProgram_;
    gl::Program const& fillProgram_;
    gl::Program const& compositeProgram_;
    CloudScene scene_;
    CloudShadow shadow_;
    CloudDepths depths_;
    std::optional<Screen> screen_;
    std::uint64_t frame_ = 0;
    int newest_ = 0;                 // which of light and facts holds the latest picture
    bool history_ = false;           // the other one holds the frame before
    float exposureBefore_ = 1.0f;
};
}  // namespace luftpost::render
