// Rain and snow in the air near the camera.
#pragma once
#include "engine/gl/program_library.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
class PrecipitationPass {
public:
    explicit PrecipitationPass(gl::ProgramLibrary& programs);
    /// Over the finished HDR picture; nothing when it does not rain or the camera is above the clouds.
    void draw(FrameContext const& context);

private:
    gl::Program const& program_;
    double fallen_ = 0.0;  // m, along the drops' way, modulo a number of cells
};
}  // namespace luftpost::render
