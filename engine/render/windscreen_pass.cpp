#include "engine/render/windscreen_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr double kWholeRate = 8.0;              // mm/h, as many drops as the glass can hold
constexpr double kWets = 2.0, kDries = 7.0;     // s, until it is as wet as the rain makes it, and dry again
constexpr double kLeast = 0.02;                 // wetness, less is not seen
constexpr double kHolds = 18.0;                 // m/s: the air drives drops up against their weight from here on
constexpr double kDrift = 0.008;                // m/s of a drop per m/s of air
constexpr double kWrap = 1024.0;                // m, after which the drops lie otherwise
constexpr double kTimeWrap = 4096.0;            // s
}  // namespace

WindscreenPass::WindscreenPass(gl::ProgramLibrary& programs) : program_{programs.compute("windscreen")} {}

void WindscreenPass::draw(FrameContext const& context) {
    Snapshot const& snapshot = context.snapshot;
    if (!snapshot.windscreen) return;
    Windscreen const& glass = *snapshot.windscreen;
    double const becomes = std::clamp(std::sqrt(snapshot.air.rain / kWholeRate), 0.0, 1.0);
    double const seconds = becomes > wet_ ? kWets : kDries;
    wet_ = snapshot.still ? becomes : wet_ + (becomes - wet_) * (1.0 - std::exp(-snapshot.frameSeconds / seconds));
    if (!snapshot.still) {  // the tiles of a still show the same drops
        double const air = glass.airspeed_mps - kHolds;
        slid_.x = std::fmod(slid_.x + kDrift * air * snapshot.frameSeconds, kWrap);
        slid_.y = std::fmod(slid_.y + kDrift * std::max(air, 0.0) * snapshot.frameSeconds, kWrap);
    }
    if (wet_ < kLeast) return;
    program_.use();
    program_.set("bodyFromWorld", glm::mat3{glm::mat3_cast(glm::conjugate(glass.worldFromBody))});
    program_.set("cabin", glass.cabin);
    program_.set("water", glm::vec4{glm::dvec4{wet_, slid_, std::fmod(snapshot.simulationSeconds, kTimeWrap)}});
    context.targets.depth.bind(0);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    gl::dispatchOver(context.targets.size, {8, 8});
    gl::barrier(gl::Barrier::all);
}
}  // namespace luftpost::render
