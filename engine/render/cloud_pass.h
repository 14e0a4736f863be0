// The clouds of the picture: their scene and shadow, the march of a sixteenth of the rays (or of all), the picture made
// of them with what the frames before saw, the composite.
#pragma once
#include <array>
#include <optional>

#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/render/cloud_scene.h"
#include "engine/render/cloud_shadow.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
/// Order in a frame: describe (any time before), prepare (once the sky's tables are bound; before land and models, which
/// read the shadow), draw (after the air was put before land and sky).
class CloudPass {
public:
    explicit CloudPass(gl::ProgramLibrary& programs);

    /// Cloud map and block of the frame.
    void describe(Snapshot const& snapshot);
    /// The shadow map, and all bindings of the clouds.
    void prepare(FrameContext const& context);
    /// March, resolve, composite into the colour target; its alpha becomes the transmittance of the clouds.
    void draw(FrameContext const& context);

    /// How far the clouds of the picture are: m, or 1 / m where `inverted`. Null before the first draw and without clouds.
    struct Distance { gl::Texture2D const* texture = nullptr; bool inverted = false; };
    Distance distance() const;
    CloudScene const& scene() const { return scene_; }

    /// GPU bytes of noise volumes and cloud map, screen-sized buffers apart.
    std::size_t bytes() const { return scene_.bytes(); }

private:
    struct Screen {
        explicit Screen(glm::ivec2 const& size, bool whole);
        glm::ivec2 size;
        bool whole;  // all rays: marched at full size, no history
        gl::Texture2D marchedLight, marchedDistance;
        std::array<gl::Texture2D, 2> light, facts;
    };

    void march(FrameContext const& context);
    void resolve(FrameContext const& context);
    void composite(FrameContext const& context);

    gl::Program const& marchProgram_;
    gl::Program const& resolveProgram_;
    gl::Program const& compositeProgram_;
    CloudScene scene_;
    CloudShadow shadow_;
    std::optional<Screen> screen_;
    std::uint64_t frame_ = 0;
    int newest_ = 0;                 // which of light and facts holds the latest picture
    bool history_ = false;           // the other one holds the frame before
    float exposureBefore_ = 1.0f;
};
}  // namespace luftpost::render
