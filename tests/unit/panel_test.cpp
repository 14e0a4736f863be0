// The cockpit shows the true readings: needles stand on the figures of their dials, the horizon lies as the
// world's does.
#include "game/app/panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/assets/model.h"
#include "engine/core/frames.h"
#include "game/app/panel_scales.h"

namespace {
using namespace luftpost;
using app::needleAngle_deg;
namespace fs = std::filesystem;

assets::Model plane() {
    return assets::readModel(fs::path{LUFTPOST_SOURCE_DIR} / "assets" / "models" / "plane.glb");
}

render::NodePose poseOf(std::vector<render::NodePose> const& poses, std::string_view node) {
    auto const found = std::find_if(poses.begin(), poses.end(),
                                    [&](render::NodePose const& pose) { return pose.node == node; });
    EXPECT_NE(found, poses.end()) << node;
    return *found;
}

/// Where the pilot sees a needle point, clockwise from the top: y is up, z to the right.
double pointing_deg(render::NodePose const& pose) {
    glm::vec3 const tip = pose.rotation * glm::vec3{0.0f, 1.0f, 0.0f};
    return core::degrees(std::atan2(static_cast<double>(tip.z), static_cast<double>(tip.y)));
}

TEST(Panel, TurnsItsNeedlesToTheReadings) {
    ui::HudState state;
    state.indicatedSpeed = 100.0 * core::kMetresPerSecondPerKnot;
    state.positionWorld.y = 2250.0 * core::kMetresPerFoot;
    state.velocityWorld.y = 1000.0 * core::kMetresPerFoot / 60.0;
    state.rpm = 1500.0;
    state.fuel_kg = 80.0;
    state.heading = core::radians(90.0);
    auto const poses = app::panelPoses(state);
    EXPECT_NEAR(pointing_deg(poseOf(poses, "needle_airspeed")), 155.0, 1e-3)
        << "60 of 140 kt of the way from 20 to 335 degrees";
    EXPECT_NEAR(pointing_deg(poseOf(poses, "needle_altitude")), 90.0, 1e-3) << "250 of 1000 ft";
    EXPECT_NEAR(pointing_deg(poseOf(poses, "needle_altitude_short")), 81.0, 1e-3) << "2250 of 10,000 ft";
    EXPECT_NEAR(pointing_deg(poseOf(poses, "needle_climb")), -5.0, 1e-3);
    EXPECT_NEAR(pointing_deg(poseOf(poses, "needle_rpm")), 0.0, 1e-3) << "half of 3000";
    EXPECT_NEAR(pointing_deg(poseOf(poses, "needle_fuel")), 0.0, 1e-3) << "half full";
    EXPECT_NEAR(pointing_deg(poseOf(poses, "compass_card")), -90.0, 1e-3) << "E has come to the top";
}

TEST(Panel, StopsItsNeedlesAtTheEndsAndLetsTheAltimetersGoRound) {
    EXPECT_EQ(needleAngle_deg("needle_airspeed", 0.0), 20.0);
    EXPECT_EQ(needleAngle_deg("needle_airspeed", 500.0), 335.0);
    EXPECT_EQ(needleAngle_deg("needle_load", -9.0), -150.0);
    EXPECT_NEAR(needleAngle_deg("needle_altitude", 3250.0), 90.0, 1e-9);
    EXPECT_NEAR(needleAngle_deg("needle_altitude", -250.0), 270.0, 1e-9) << "below the sea";
}

TEST(Panel, HoldsItsHorizonWhereTheWorldsIs) {
    ui::HudState state;
    state.roll = core::radians(30.0);
    glm::quat const banked = poseOf(app::panelPoses(state), "horizon_ball").rotation;
    glm::vec3 const up = banked * glm::vec3{0.0f, 1.0f, 0.0f};  // the sky's pole
    EXPECT_NEAR(up.z, -0.5f, 1e-6f) << "right wing down: the sky leans to the left";
    state.roll = 0.0, state.pitch = core::radians(20.0);
    glm::quat const climbing = poseOf(app::panelPoses(state), "horizon_ball").rotation;
    EXPECT_LT((climbing * glm::vec3{0.0f, 1.0f, 0.0f}).x, -0.3f)
        << "nose up: more sky in front, toward the pilot";
    state.sideLoad = 0.1;
    EXPECT_LT(poseOf(app::panelPoses(state), "slip_ball").translation.z, 0.0f)
        << "pushed right, the ball is left";
}

TEST(Panel, FindsEveryNodeThatItMovesInTheModel) {
    assets::Model const model = plane();
    for (render::NodePose const& pose : app::panelPoses({})) {
        auto const node = std::find_if(model.nodes.begin(), model.nodes.end(),
                                       [&](assets::Node const& n) { return n.name == pose.node; });
        EXPECT_NE(node, model.nodes.end()) << pose.node;
    }
    for (app::DialScale const& scale : app::kDialScales) EXPECT_LT(scale.low, scale.high) << scale.node;
}
}  // namespace
