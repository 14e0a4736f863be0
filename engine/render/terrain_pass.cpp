#include "engine/render/terrain_pass.h"

#include "engine/gl/draw.h"

namespace luftpost::render {
TerrainPass::TerrainPass(gl::ProgramLibrary& programs)
    : program_{programs.graphics("terrain")},
      normalsProgram_{programs.graphics(gl::GraphicsStages{"terrain_normals", "normals", "normals"})} {}

void TerrainPass::draw(FrameContext const& context, LandScene const& scene) {
    gl::DrawState state = gl::opaqueState();
    state.wireframe = context.snapshot.debug.wireframe;
    gl::apply(state);
    context.targets.opaque.bind();
    program_.use();
    scene.bind();
    for (terrain::DrawnChunk const& chunk : scene.chunks()) scene.draw(chunk, program_, context.snapshot.camera.positionWorld);
}

void TerrainPass::drawNormals(FrameContext const& context, LandScene const& scene) {
    gl::DrawState state = gl::opaqueState();
    state.depthWrite = false;
    state.cull = gl::Cull::none;
    gl::apply(state);
    context.targets.blended.bind();
    normalsProgram_.use();
    scene.bind();
    for (terrain::DrawnChunk const& chunk : scene.chunks())
        scene.draw(chunk, normalsProgram_, context.snapshot.camera.positionWorld);
}
}  // namespace luftpost::render
