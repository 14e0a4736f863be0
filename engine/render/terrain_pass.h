// Draws the land into the opaque targets.
#pragma once
#include "engine/gl/program_library.h"
#include "engine/render/land_scene.h"

namespace luftpost::render {
class TerrainPass {
public:
    /// Throws core::Error when its shaders do not load.
    explicit TerrainPass(gl::ProgramLibrary& programs);
    /// After `scene.update` of this frame.
    void draw(FrameContext const& context, LandScene const& scene);
    /// The normals of the mesh as lines (F2).
    void drawNormals(FrameContext const& context, LandScene const& scene);

private:
    gl::Program const& program_;
    gl::Program const& normalsProgram_;
};
}  // namespace luftpost::render
