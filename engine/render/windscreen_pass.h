// Rain on the glass before a camera in the cockpit.
#pragma once
#include <glm/vec2.hpp>

#include "engine/gl/program_library.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
/// GL thread only.
class WindscreenPass {
public:
    explicit WindscreenPass(gl::ProgramLibrary& programs);
    /// Over the finished HDR picture; nothing without Snapshot::windscreen or when the glass is dry. A still shows it as wet as it becomes.
    void draw(FrameContext const& context);

private:
    gl::Program const& program_;
    double wet_ = 0.0;        // 0..1
    glm::dvec2 slid_{0.0};    // m, as lib/windscreen has it
};
}  // namespace luftpost::render
