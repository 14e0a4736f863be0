#include "engine/render/precipitation_pass.h"

#include <algorithm>
#include <cmath>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr double kShutter = 1.0 / 160.0;  // s
constexpr double kWrap = 4096.0;         // m
constexpr double kSnowFall = 1.1;        // m/s

/// Terminal velocity of the drops that carry most of the water: Atlas and Ulbrich 1977, v = 3.78 D^0.67 (D in mm), with
/// the median diameter of Marshall and Palmer, D = 0.9 R^0.21.
double rainFall(double rate) { return 3.78 * std::pow(0.9 * std::pow(rate, 0.21), 0.67); }

constexpr double kLeast = 0.05;          // mm/h, less is not seen
}  // namespace

PrecipitationPass::PrecipitationPass(gl::ProgramLibrary& programs) : program_{programs.compute("precipitation")} {}

void PrecipitationPass::draw(FrameContext const& context) {
    Snapshot const& snapshot = context.snapshot;
    core::AirSample const& air = snapshot.air;
    double const rate = air.rain + air.snow + air.hail;
    if (rate < kLeast) return;
    bool const snow = air.snow > air.rain + air.hail;
    glm::dvec3 const moved{glm::vec3{context.frame.cameraMoved}};
    glm::dvec3 const cameraVelocity = snapshot.frameSeconds > 0.0 ? moved / snapshot.frameSeconds : glm::dvec3{0.0};
    glm::dvec3 const fall{0.0, snow ? -kSnowFall : -rainFall(rate), 0.0};
    glm::dvec3 const velocity = air.windWorld + fall - cameraVelocity;
    double const speed = std::max(glm::length(velocity), 0.1);
    fallen_ = snapshot.still ? 0.0 : std::fmod(fallen_ + speed * snapshot.frameSeconds, kWrap);

    double const streak = std::clamp(speed * kShutter, snow ? 0.012 : 0.03, 0.6);
    double const share = std::clamp((snow ? 0.35 : 0.2) * std::pow(rate, 0.5), 0.02, 0.8);
    program_.use();
    program_.set("axisAndFallen", glm::vec4{glm::dvec4{velocity / speed, fallen_}});
    program_.set("dropShape", glm::vec4{static_cast<float>(streak), snow ? 0.008f : 0.0016f, static_cast<float>(share),
                                        snow ? 1.0f : 0.4f});
    context.targets.depth.bind(0);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    gl::dispatchOver(context.targets.size, {8, 8});
    gl::barrier(gl::Barrier::all);
}
}  // namespace luftpost::render
