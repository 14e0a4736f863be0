// The lines that fade on the HUD, and what they say of the flight's events.
#pragma once
#include <vector>

#include "game/app/simulation.h"
#include "game/ui/hud.h"

namespace luftpost::app {
class Messages {
public:
    void say(std::string text, ui::MessageKind kind, double seconds);
    /// The line of an event, if it deserves one.
    void sayEvent(FlightEventAt const& event, double seconds);
    /// Those still to be shown at `seconds` of flight.
    std::vector<ui::HudMessage> at(double seconds);

private:
    struct Line {
        ui::HudMessage message;
        double since = 0.0;
    };
    std::vector<Line> lines_;
};
}  // namespace luftpost::app
