// How bright the picture is shown: measured and adapted on the GPU, read there by the tone map; nothing waits.
#pragma once
#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
/// Measures the colour target and leaves the exposure in the storage block of shaders/shared/exposure_block.glsl.h,
/// bound for the passes that follow. A still's exposure is that of its own picture; else the eye adapts with the
/// frame's seconds. Counts are integers, so the same frames give the same bits.
class ExposurePass {
public:
    explicit ExposurePass(gl::ProgramLibrary& programs);
    void draw(FrameContext const& context);
    /// Binds what the latest `draw` left.
    void bind() const;

private:
    gl::Program const& measure_;
    gl::Program const& adapt_;
    gl::Buffer state_;
};
}  // namespace luftpost::render
