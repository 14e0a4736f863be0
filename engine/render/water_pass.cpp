#include "engine/render/water_pass.h"

#include "engine/gl/draw.h"

namespace luftpost::render {
WaterPass::WaterPass(gl::ProgramLibrary& programs) : program_{programs.graphics("water")} {}

void WaterPass::draw(FrameContext const& context, LandScene const& scene) {
    gl::DrawState state = gl::opaqueState();
    state.blend = gl::Blend::premultiplied;
    state.wireframe = context.snapshot.debug.wireframe;
    gl::apply(state);
    context.targets.opaque.bind();
    program_.use();
    scene.bind();
    auto const level = static_cast<float>(scene.land().waterLevel());
    for (terrain::DrawnChunk const& chunk : scene.chunks())
        if (scene.lowest(chunk.key) < level) scene.draw(chunk, program_, context.snapshot.camera.positionWorld);
}
}  // namespace luftpost::render
