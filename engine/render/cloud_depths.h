// Two grids around the camera of the optical depth from a place in the clouds toward the light: read by the march through
// shaders/lib/cloud_scene.glsl instead of sampling the whole way.
#pragma once
#include "engine/gl/program_library.h"
#include "engine/gl/sampler.h"
#include "engine/gl/texture.h"
#include "engine/render/cloud_glow.h"
#include "engine/render/cloud_program.h"

namespace luftpost::render {
/// 128 x 128 columns along the light over 24 and 96 km, 32 slices between the lowest base and the highest top each, 2 MB. A texel
/// means the same place of the world as long as it is in reach, so that nothing is drawn anew for the camera's sake: a
/// band of rows a frame, everything once for stills and after a leap of the clock.
class CloudDepths {
public:
    explicit CloudDepths(gl::ProgramLibrary& programs);

    /// Where the grids lie this frame; before the scene's block is uploaded.
    void place(Snapshot const& snapshot, CloudScene& scene);
    /// After the sky's tables are bound. What it drew anew.
    GridRows draw(CloudScene const& scene);
    /// For the passes that read them.
    void bind() const;
    std::size_t bytes() const { return grids_.bytes(); }

private:
    CloudProgram program_;
    gl::Texture3D grids_;
    gl::Sampler sampler_;
    glm::vec3 heights_{0.0f};  // m above sea level, of the lowest and the highest slice and of the plane
    bool whole_ = true;
    int band_ = 0;
};
}  // namespace luftpost::render
