// The light that is scattered again and again in the clouds around the camera: read by the march through shaders/lib/cloud_scene.glsl.
#pragma once
#include "engine/gl/program_library.h"
#include "engine/gl/sampler.h"
#include "engine/gl/texture.h"

namespace luftpost::render {
/// Rows of columns that are drawn anew in a frame.
struct GridRows {
    int first = 0;
    int count = 0;
    bool anew = false;  // all of them, and nothing that was known is of use
};

/// 128 x 128 upright columns of 32 cells over the inner grid of CloudDepths, from whose depths it is solved (shaders/lib/cloud_glow.glsl says what and
/// how), 6.3 MB. A column stands for the same place of the world as long as it is in reach: a band of rows a frame, each better known
/// with every visit; everything once for stills and after a leap of the clock. GL thread only.
class CloudGlow {
public:
    explicit CloudGlow(gl::ProgramLibrary& programs);

    /// After the grids of optical depth are bound.
    void draw(GridRows const& rows);
    /// For the passes that read it.
    void bind() const;
    std::size_t bytes() const { return cells_.bytes() + glow_.bytes(); }

private:
    void spread(GridRows const& rows, int sweeps);

    gl::Program const& cellsProgram_;
    gl::Program const& spreadProgram_;
    gl::Program const& gatherProgram_;
    gl::Texture3D cells_, glow_;
    gl::Sampler sampler_;
};
}  // namespace luftpost::render
