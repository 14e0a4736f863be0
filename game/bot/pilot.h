// Who flies in a player's place: reads what instruments show and acts through the input layer, 20 times a second.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "engine/core/frames.h"
#include "engine/flight/aircraft_state.h"
#include "game/ui/hud.h"
#include "game/ui/input.h"

namespace luftpost::bot {
inline constexpr int kTicksPerDecision = core::kTicksPerSecond / 20;

/// What a flight was flown to find out, by name with its unit: {"stall_clean_kcas", 53.1}.
using Figures = std::vector<std::pair<std::string, double>>;

class Pilot {
public:
    virtual ~Pilot() = default;
    /// The recorder of a test flight runs every tick, before the decision of that tick.
    virtual void look(flight::AircraftState const&) {}
    /// What the hands do until the next decision.
    virtual ui::InputSample decide(ui::HudState const& hud) = 0;
    /// What was found out so far, and whether that is all.
    virtual Figures const* figures() const { return nullptr; }
    virtual bool finished() const { return false; }
};
}  // namespace luftpost::bot
