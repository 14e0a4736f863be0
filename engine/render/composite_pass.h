// The air before what was drawn, the sky behind it.
#pragma once
#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
/// Reads the depth and the sky's tables (SkyPass has drawn before), changes the colour target in place.
class CompositePass {
public:
    explicit CompositePass(gl::ProgramLibrary& programs);
    void draw(FrameContext const& context, bool starsShow);

private:
    gl::Program const& program_;
    gl::Program const& dayProgram_;  // without stars
    gl::Buffer stars_;
};
}  // namespace luftpost::render
