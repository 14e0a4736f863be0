// The clouds' shade in the air: table five of the sky, read by every pass through shaders/lib/sky_tables.glsl.
#pragma once
#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/render/cloud_scene.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
/// Made anew a band of rows a frame, everything at once for stills and after a leap of the clock; nothing where no cloud has a
/// body.
class AirShade {
public:
    explicit AirShade(gl::ProgramLibrary& programs);

    /// After the sky's tables and the grids of optical depth are bound.
    void draw(FrameContext const& context, CloudScene const& scene);
    /// For all passes of the frame.
    void bind() const;
    std::size_t bytes() const { return table_.bytes(); }

private:
    gl::Program const& program_;
    gl::Texture3D table_;
    bool empty_ = false;  // the table is full of zeros
    bool whole_ = true;
    int band_ = 0;
};
}  // namespace luftpost::render
