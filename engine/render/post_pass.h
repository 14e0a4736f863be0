// From the HDR picture to the screen: bloom, tone map, smooth edges, dither.
#pragma once
#include <vector>

#include "engine/gl/program_library.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
class PostPass {
public:
    /// Throws core::Error when its shaders do not load.
    explicit PostPass(gl::ProgramLibrary& programs);

    void drawBloom(FrameContext const& context);
    /// With the latest bloom, which is the whole picture's, into `display`, whose size may differ from the HDR targets'.
    void drawToneMap(FrameContext const& context, gl::Framebuffer const& display);

private:
    void takeLevels(glm::ivec2 const& picture);
    void takeEncoded(glm::ivec2 const& size);

    gl::Program const& down_;
    gl::Program const& up_;
    gl::Program const& toneMap_;
    gl::Program const& finish_;
    glm::ivec2 picture_{0};
    std::vector<gl::Texture2D> levels_;  // of the bloom: a quarter of the picture's size, an eighth, ...
    gl::Texture2D encoded_;
    gl::Framebuffer encodedTarget_;
};
}  // namespace luftpost::render
