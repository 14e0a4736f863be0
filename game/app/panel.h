// The instruments of the cockpit: the nodes of assets/models/plane.glb as the readings turn them.
#pragma once
#include <vector>

#include "engine/render/snapshot.h"
#include "game/ui/hud.h"

namespace luftpost::app {
/// Degrees clockwise from the top at which the needle of a dial stands at a reading. The node must be one of the scales.
double needleAngle_deg(std::string_view node, double reading);
/// All needles, the horizon, the compass card and the ball, from what the HUD shows.
std::vector<render::NodePose> panelPoses(ui::HudState const& state);
}  // namespace luftpost::app
