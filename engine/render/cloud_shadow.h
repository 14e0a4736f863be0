// The shadow map of the clouds: read by land, models and air through shaders/lib/cloud_shadow.glsl.
#pragma once
#include "engine/gl/program_library.h"
#include "engine/gl/sampler.h"
#include "engine/gl/texture.h"
#include "engine/render/cloud_program.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
/// 256 x 256 texels over 40 km, snapped to texels. Drawn whole for stills and when it moved; else a band of rows a frame.
class CloudShadow {
public:
    explicit CloudShadow(gl::ProgramLibrary& programs);

    /// Where the map lies this frame; before the scene's block is uploaded.
    void place(Snapshot const& snapshot, CloudScene& scene);
    /// After the sky's tables are bound.
    void draw(FrameContext const& context, CloudScene const& scene);
    /// For the passes that read it.
    void bind() const;
    /// Of the map.
    std::size_t bytes() const { return map_.bytes(); }

private:
    CloudProgram program_;
    gl::Texture2D map_;
    gl::Sampler sampler_;
    glm::dvec2 corner_{0.0};  // m, world, east and south
    bool whole_ = true;
    int band_ = 0;
};
}  // namespace luftpost::render
