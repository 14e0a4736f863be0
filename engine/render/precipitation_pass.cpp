#include "engine/render/precipitation_pass.h"

#include <algorithm>
#include <cmath>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr double kShutter = 1.0 / 160.0;  // s
constexpr double kWrap = 4096.0;         // m

/// What falls, as it is seen: m/s, m across, opacity of a streak, share of the cells with one at 1 mm/h, m of the shortest streak.
struct Drops {
    double speed, size, opacity, share, shortest;
};

/// Drops that carry most of the water: the median diameter of Marshall and Palmer, D = 0.9 R^0.21 mm, falling with 3.78 D^0.67 m/s (Atlas and
/// Ulbrich 1977); drizzle is small and slow by that. They are drawn twice as wide as they are: a drop is a lens with a bright rim.
Drops rain(double rate) {
    double const diameter = 0.9 * std::pow(rate, 0.21);
    return {3.78 * std::pow(diameter, 0.67), 2e-3 * diameter, 0.4, 0.2, 0.03};
}
constexpr Drops kSnow{1.1, 8e-3, 1.0, 0.35, 0.012};
/// Stones of 8 mm: 12.43 D^0.5 m/s, D in cm (Matson and Huggins 1980).
constexpr Drops kHail{11.1, 8e-3, 1.0, 0.06, 0.01};

Drops dropsOf(core::AirSample const& air) {
    if (air.hail > 0.25 * (air.rain + air.snow + air.hail)) return kHail;
    return air.snow > air.rain + air.hail ? kSnow : rain(air.rain + air.hail);
}

constexpr double kLeast = 0.05;          // mm/h, less is not seen
}  // namespace

PrecipitationPass::PrecipitationPass(gl::ProgramLibrary& programs) : program_{programs.compute("precipitation")} {}

void PrecipitationPass::draw(FrameContext const& context) {
    Snapshot const& snapshot = context.snapshot;
    core::AirSample const& air = snapshot.air;
    double const rate = air.rain + air.snow + air.hail;
    if (rate < kLeast) return;
    Drops const drops = dropsOf(air);
    glm::dvec3 const moved{glm::vec3{context.frame.cameraMoved}};
    glm::dvec3 const cameraVelocity = snapshot.frameSeconds > 0.0 ? moved / snapshot.frameSeconds : glm::dvec3{0.0};
    glm::dvec3 const velocity = air.windWorld - glm::dvec3{0.0, drops.speed, 0.0} - cameraVelocity;
    double const speed = std::max(glm::length(velocity), 0.1);
    fallen_ = snapshot.still ? 0.0 : std::fmod(fallen_ + speed * snapshot.frameSeconds, kWrap);

    double const streak = std::clamp(speed * kShutter, drops.shortest, 0.6);
    double const share = std::clamp(drops.share * std::sqrt(rate), 0.02, 0.8);
    program_.use();
    program_.set("axisAndFallen", glm::vec4{glm::dvec4{velocity / speed, fallen_}});
    program_.set("dropShape", glm::vec4{glm::dvec4{streak, drops.size, share, drops.opacity}});
    context.targets.depth.bind(0);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    gl::dispatchOver(context.targets.size, {8, 8});
    gl::barrier(gl::Barrier::all);
}
}  // namespace luftpost::render
