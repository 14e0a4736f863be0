#include "engine/render/cloud_glow.h"

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr glm::ivec3 kCells{128, 128, 32};  // lib/cloud_glow.glsl's kGlowSide, lib/cloud_scene.glsl's kGlowSlices
constexpr unsigned kUnit = 17, kCellsUnit = 0;
constexpr int kSweeps = 20;  // from nothing: what is left changes a picture by less than a thousandth
constexpr int kGroup = 8;
}  // namespace

CloudGlow::CloudGlow(gl::ProgramLibrary& programs)
    : cellsProgram_{programs.compute("cloud_glow_cells")},
      spreadProgram_{programs.compute("cloud_glow_spread")},
      gatherProgram_{programs.compute("cloud_glow_gather")},
      cells_{gl::Format::rgba16f, kCells, 1, "cloud glow cells"},
      glow_{gl::Format::rg16f, kCells, 1, "cloud glow"},
      sampler_{{.wrap = gl::Wrap::repeat}, "cloud glow"} {
    glow_.clear();  // read, though not taken, where it was never solved
}

void CloudGlow::spread(GridRows const& rows, int sweeps) {
    spreadProgram_.use();
    spreadProgram_.set("firstRow", rows.first);
    cells_.bindImage(0, gl::Access::readWrite);
    for (int pass = 0; pass < 2 * sweeps; ++pass) {
        spreadProgram_.set("colour", pass & 1);
        gl::dispatch({kCells.x / 2 / kGroup, rows.count / kGroup, 1});
        gl::barrier(gl::Barrier::image);
    }
}

void CloudGlow::draw(GridRows const& rows) {
    if (rows.count == 0) return;
    cellsProgram_.use();
    cellsProgram_.set("firstRow", rows.first);
    cellsProgram_.set("anew", rows.anew ? 1 : 0);
    cells_.bindImage(0, gl::Access::readWrite);
    gl::dispatch({kCells.x / kGroup, rows.count / kGroup, kCells.z});
    gl::barrier(gl::Barrier::image);
    spread(rows, rows.anew ? kSweeps : 1);
    gl::barrier(gl::Barrier::textureFetch);
    gatherProgram_.use();
    gatherProgram_.set("firstRow", rows.first);
    cells_.bind(kCellsUnit);
    sampler_.bind(kCellsUnit);
    glow_.bindImage(0, gl::Access::write);
    gl::dispatch({kCells.x / kGroup, rows.count / kGroup, kCells.z});
    gl::barrier(gl::Barrier::textureFetch);
    gl::Sampler::unbind(kCellsUnit);
}

void CloudGlow::bind() const {
    glow_.bind(kUnit);
    sampler_.bind(kUnit);
}
}  // namespace luftpost::render
