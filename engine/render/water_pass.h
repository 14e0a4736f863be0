// Draws the lakes over the land that lies under them.
#pragma once
#include "engine/gl/program_library.h"
#include "engine/render/land_scene.h"

namespace luftpost::render {
class WaterPass {
public:
    /// Throws core::Error when its shaders do not load.
    explicit WaterPass(gl::ProgramLibrary& programs);
    /// After the land; chunks without water are left out.
    void draw(FrameContext const& context, LandScene const& scene);

private:
    gl::Program const& program_;
};
}  // namespace luftpost::render
