// What the instruments show of the flight: read by the HUD and by the bot alike.
#pragma once
#include "game/app/simulation.h"
#include "game/ui/hud.h"

namespace luftpost::app {
/// The state of this tick; prompts, messages, camera and the player's size are left to the frame.
ui::HudState instruments(Simulation const& simulation);
}  // namespace luftpost::app
