#include "engine/render/cloud_depths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr int kSide = 128;
constexpr int kSlices = 64;  // of both grids: twice kDepthSlices of lib/cloud_scene.glsl
constexpr std::array<double, 2> kWidths{24'000.0, 96'000.0};  // m
constexpr int kBands = 16;             // frames in which all rows are drawn anew
constexpr float kHeightStep = 100.0f;  // m: by so much lowest and highest slice move at a time
constexpr unsigned kUnit = 16;

/// Between which altitudes there are layers with a body, m, in whole steps; x above y when there are none. z: middle of the
/// lowest of them: there a low light's slant takes least out of the grids' reach.
glm::vec3 heightsOf(glsl::CloudBlock const& block) {
    constexpr float kHighest = std::numeric_limits<float>::max();
    glm::vec3 heights{kHighest, -kHighest, kHighest};
    for (int i = 0; i < block.march.x; ++i) {
        glsl::LayerShape const& shape = block.shapes[i];
        if (shape.extent.z < 0.5f || shape.look.z > 0.5f) continue;
        heights.x = std::min(heights.x, std::floor(shape.extent.x / kHeightStep) * kHeightStep);
        heights.y = std::max(heights.y, std::ceil(shape.extent.y / kHeightStep) * kHeightStep);
        heights.z = std::min(heights.z, std::round(0.5f * (shape.extent.x + shape.extent.y) / kHeightStep) * kHeightStep);
    }
    return heights;
}
}  // namespace

CloudDepths::CloudDepths(gl::ProgramLibrary& programs)
    : program_{programs, "cloud_depths"},
      grids_{gl::Format::r16f, {kSide, kSide, kSlices}, 1, "cloud depths"},
      sampler_{{.wrap = gl::Wrap::repeat}, "cloud depths"} {}

void CloudDepths::place(Snapshot const& snapshot, CloudScene& scene) {
    glm::vec3 const heights = heightsOf(scene.block());
    bool const any = heights.x < heights.y;
    whole_ = whole_ || snapshot.still || scene.leapt() || (any && heights != heights_);
    heights_ = heights;
    glm::dvec2 const camera{snapshot.camera.positionWorld.x, snapshot.camera.positionWorld.z};
    std::array<glm::vec4, 2> places{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        glm::dvec2 const modulo = camera - glm::floor(camera / kWidths[i]) * kWidths[i];
        places[i] = glm::vec4{glm::dvec4{modulo, 1.0 / kWidths[i], kWidths[i]}};
    }
    scene.setDepthPlaces(places, {heights, any ? 1.0f : 0.0f});
}

GridRows CloudDepths::draw(CloudScene const& scene) {
    if (scene.empty() || scene.block().depthHeights.w < 0.5f) return {};
    gl::Program const& program = program_.of(scene);
    program.use();
    GridRows const rows{whole_ ? 0 : band_ * (kSide / kBands), whole_ ? kSide : kSide / kBands, whole_};
    program.set("firstRow", rows.first);
    grids_.bindImage(0, gl::Access::write);
    gl::dispatch({kSide / 8, rows.count / 8, 2});
    gl::barrier(gl::Barrier::textureFetch);
    band_ = (band_ + 1) % kBands;
    whole_ = false;
    return rows;
}

void CloudDepths::bind() const {
    grids_.bind(kUnit);
    sampler_.bind(kUnit);
}
}  // namespace luftpost::render
