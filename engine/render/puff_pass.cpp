#include "engine/render/puff_pass.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr unsigned kBinding = 5;

struct Ball {
    glm::vec4 place;   // relative to the camera, radius
    glm::vec4 colour;
};
}  // namespace

PuffPass::PuffPass(gl::ProgramLibrary& programs)
    : program_{programs.graphics("puff")}, none_{gl::VertexArray::withoutAttributes()} {}

void PuffPass::draw(FrameContext const& context) {
    std::vector<Ball> balls;
    for (Puff const& puff : context.snapshot.puffs)
        balls.push_back({glm::vec4{relativeToCamera(context, puff.positionWorld), puff.radius}, puff.colour});
    if (balls.empty()) return;
    std::ranges::stable_sort(balls, std::ranges::greater{}, [](Ball const& ball) { return glm::length(glm::vec3{ball.place}); });
    std::size_t const bytes = balls.size() * sizeof(Ball);
    if (bytes > balls_.bytes()) balls_ = gl::Buffer{std::bit_ceil(bytes), "puffs"};
    balls_.update(gl::bytesOfRange(balls));
    balls_.bindStorage(kBinding);
    context.targets.colourOnly.bind();
    gl::DrawState state;
    state.blend = gl::Blend::alpha;
    gl::apply(state);
    program_.use();
    context.targets.depth.bind(0);
    gl::drawArrays(none_, gl::Primitive::triangleStrip, 0, 4, static_cast<int>(balls.size()));
}
}  // namespace luftpost::render
