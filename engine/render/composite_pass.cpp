#include "engine/render/composite_pass.h"

#include <vector>

#include "engine/gl/draw.h"
#include "engine/sky/stars.h"

namespace luftpost::render {
namespace {
constexpr unsigned kStarBinding = 7;

/// The grid as the shader's StarBlock lays it out: 512 cells of four integers, then the stars.
gl::Buffer starBuffer() {
    sky::StarGrid const grid = sky::starGrid();
    std::vector<glm::vec4> content;
    for (glm::ivec2 const& cell : grid.cells)
        content.emplace_back(glm::intBitsToFloat(glm::ivec4{cell.x, cell.y, 0, 0}));
    content.insert(content.end(), grid.stars.begin(), grid.stars.end());
    return gl::Buffer{gl::bytesOfRange(content), "bright stars"};
}
}  // namespace

CompositePass::CompositePass(gl::ProgramLibrary& programs)
    : program_{programs.compute("composite")}, dayProgram_{programs.compute("composite", {"STARS false"})}, stars_{starBuffer()} {}

void CompositePass::draw(FrameContext const& context, bool starsShow) {
    (starsShow ? program_ : dayProgram_).use();
    context.targets.depth.bind(0);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    stars_.bindStorage(kStarBinding);
    gl::dispatchOver(context.targets.size, {8, 8});
    gl::barrier(gl::Barrier::all);
}
}  // namespace luftpost::render
