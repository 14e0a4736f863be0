#include "engine/render/exposure_pass.h"

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr unsigned kExposureBinding = 6;
constexpr std::size_t kBytes = 16 + 4 * 256;
constexpr int kStride = 4;  // pixels between measured ones
}  // namespace

ExposurePass::ExposurePass(gl::ProgramLibrary& programs)
    : measure_{programs.compute("exposure_measure")},
      adapt_{programs.compute("exposure_adapt")},
      state_{kBytes, "exposure"} {
    state_.clear();
}

void ExposurePass::draw(FrameContext const& context) {
    bind();
    context.targets.colour.bind(0);
    measure_.use();
    gl::dispatchOver((context.targets.size + glm::ivec2{kStride - 1}) / kStride, {8, 8});
    gl::barrier(gl::Barrier::storage);
    adapt_.use();
    gl::dispatch({1, 1, 1});
    gl::barrier(gl::Barrier::storage);
}

void ExposurePass::bind() const { state_.bindStorage(kExposureBinding); }
}  // namespace luftpost::render
