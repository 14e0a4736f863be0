#include "game/app/panel.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/frames.h"
#include "game/app/panel_scales.h"

namespace luftpost::app {
namespace {
constexpr float kBallTravel = 0.020f;  // m from the middle of its tube
constexpr double kBallLoad = 0.2;      // g there
constexpr float kHorizonDepth = 0.2f;  // the horizon is a ball pressed flat

/// About the panel's normal; + is clockwise as the pilot, who looks along x, sees it.
glm::quat clockwise(double angle) {
    return glm::angleAxis(static_cast<float>(angle), glm::vec3{1.0f, 0.0f, 0.0f});
}

render::NodePose needle(std::string_view node, double reading) {
    return {.node = std::string{node}, .rotation = clockwise(core::radians(needleAngle_deg(node, reading)))};
}
}  // namespace

double needleAngle_deg(std::string_view node, double reading) {
    auto const scale = std::find_if(kDialScales.begin(), kDialScales.end(),
                                    [&](DialScale const& s) { return s.node == node; });
    CHECK(scale != kDialScales.end(), "no dial {}", node);
    double share = (reading - scale->low) / (scale->high - scale->low);
    bool const round = scale->highAngle_deg - scale->lowAngle_deg >= 360.0;
    share = round ? share - std::floor(share) : std::clamp(share, 0.0, 1.0);
    return scale->lowAngle_deg + share * (scale->highAngle_deg - scale->lowAngle_deg);
}

std::vector<render::NodePose> panelPoses(ui::HudState const& state) {
    constexpr double kSecondsPerMinute = 60.0;
    double const altitude_ft = state.positionWorld.y / core::kMetresPerFoot;
    double const climb_fpm = state.velocityWorld.y / core::kMetresPerFoot * kSecondsPerMinute;
    std::vector<render::NodePose> poses{
        needle("needle_airspeed", state.indicatedSpeed / core::kMetresPerSecondPerKnot),
        needle("needle_altitude", altitude_ft),
        needle("needle_altitude_short", altitude_ft),
        needle("needle_climb", climb_fpm),
        needle("needle_turn", core::degrees(state.turnRate)),
        needle("needle_rpm", state.rpm),
        needle("needle_fuel", state.fuel_kg),
        needle("needle_angle", core::degrees(state.alpha)),
        needle("needle_load", state.loadFactor),
        needle("needle_flaps", 100.0 * state.flaps),
        {.node = "compass_card", .rotation = clockwise(-state.heading)}};
    auto const slip = static_cast<float>(std::clamp(-state.sideLoad / kBallLoad, -1.0, 1.0));
    poses.push_back({.node = "slip_ball", .translation = glm::vec3{0.0f, 0.0f, kBallTravel * slip}});
    poses.push_back({.node = "horizon", .scale = glm::vec3{kHorizonDepth, 1.0f, 1.0f}});
    glm::quat const pitched = glm::angleAxis(static_cast<float>(state.pitch), glm::vec3{0.0f, 0.0f, 1.0f});
    poses.push_back({.node = "horizon_ball", .rotation = clockwise(-state.roll) * pitched});
    return poses;
}
}  // namespace luftpost::app
