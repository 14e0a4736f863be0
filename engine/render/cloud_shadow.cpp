#include "engine/render/cloud_shadow.h"

#include <cmath>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr int kSize = 256;
constexpr double kWidth = 40'000.0;     // m
constexpr double kStep = kWidth / 16.0;  // the map moves by so much at a time
constexpr int kBands = 8;               // frames in which all rows are drawn anew
constexpr unsigned kUnit = 15;
}  // namespace

CloudShadow::CloudShadow(gl::ProgramLibrary& programs)
    : program_{programs, "cloud_shadow"}, map_{gl::Format::rg16f, {kSize, kSize}, 1, "cloud shadow"}, sampler_{{}, "cloud shadow"} {}

void CloudShadow::place(Snapshot const& snapshot, CloudScene& scene) {
    glm::dvec2 const camera{snapshot.camera.positionWorld.x, snapshot.camera.positionWorld.z};
    glm::dvec2 const corner = glm::floor((camera - 0.5 * kWidth) / kStep + 0.5) * kStep;
    whole_ = whole_ || snapshot.still || scene.leapt() || corner != corner_;
    corner_ = corner;
    scene.setShadowPlace({glm::vec2{camera - corner}, 1.0f / static_cast<float>(kWidth), static_cast<float>(snapshot.place.altitude_m)});
}

void CloudShadow::draw(FrameContext const& context, CloudScene const& scene) {
    if (scene.empty() || !context.snapshot.clouds.shadows) return;
    gl::Program const& program = program_.of(scene);
    program.use();
    program.set("firstRow", whole_ ? 0 : band_ * (kSize / kBands));
    map_.bindImage(0, gl::Access::write);
    gl::dispatchOver({kSize, whole_ ? kSize : kSize / kBands}, {8, 8});
    gl::barrier(gl::Barrier::textureFetch);
    band_ = (band_ + 1) % kBands;
    whole_ = false;
}

void CloudShadow::bind() const {
    map_.bind(kUnit);
    sampler_.bind(kUnit);
}
}  // namespace luftpost::render
