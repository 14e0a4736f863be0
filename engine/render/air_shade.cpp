#include "engine/render/air_shade.h"

#include "engine/gl/draw.h"
#include "shaders/shared/sky_block.glsl.h"

namespace luftpost::render {
namespace {
constexpr glm::ivec3 kSize{80, 72, 21};
constexpr int kBands = 9;  // frames in which all rows are drawn anew
}  // namespace

AirShade::AirShade(gl::ProgramLibrary& programs)
    : program_{programs.compute("sky_shade")}, table_{gl::Format::rgba16f, kSize, 1, "air shade"} {
    table_.setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::repeat);  // the azimuth wraps
}

void AirShade::draw(FrameContext const& context, CloudScene const& scene) {
    bool const any = !scene.empty() && scene.block().depthHeights.w > 0.5f && context.snapshot.clouds.shadows;
    if (!any) {
        if (!empty_) table_.clear();
        empty_ = whole_ = true;
        return;
    }
    whole_ = whole_ || context.snapshot.still || scene.leapt();
    program_.use();
    program_.set("firstRow", whole_ ? 0 : band_ * (kSize.y / kBands));
    table_.bindImage(0, gl::Access::write);
    gl::dispatchOver({kSize.x, whole_ ? kSize.y : kSize.y / kBands}, {8, 8});
    gl::barrier(gl::Barrier::textureFetch);
    band_ = (band_ + 1) % kBands;
    empty_ = whole_ = false;
}

void AirShade::bind() const { table_.bind(static_cast<unsigned>(glsl::kSkyShadeUnit)); }
}  // namespace luftpost::render
