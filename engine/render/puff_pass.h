// Smoke and dust: soft balls.
#pragma once
#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
class PuffPass {
public:
    /// Throws core::Error when its shaders do not load.
    explicit PuffPass(gl::ProgramLibrary& programs);
    /// Blends the snapshot's puffs over the picture, farthest first; the sky's tables and the clouds' shadow are bound.
    void draw(FrameContext const& context);

private:
    gl::Program const& program_;
    gl::VertexArray none_;
    gl::Buffer balls_;
};
}  // namespace luftpost::render
