// The courier: a pilot that reads what the HUD shows and the ground ahead, as a player sees it through the
// windscreen, and acts through the input layer 20 times a second.
#pragma once
#include "engine/core/environment.h"
#include "game/bot/pilot.h"

namespace luftpost::bot {

class Courier : public Pilot {
public:
    /// `stallSpeed` of the airframe, m/s: its speeds are so many times that.
    Courier(core::GroundFunction ground, double stallSpeed);

    ui::InputSample decide(ui::HudState const& hud) override;

private:
    struct Aim {
        glm::dvec2 courseEastNorth{0.0, 1.0};  // unit, the track to fly
        double altitude = 0.0;                 // m above sea level
        bool release = false;
    };
    Aim aim(ui::HudState const& hud);
    double steepestAhead(ui::HudState const& hud, glm::dvec2 course) const;
    glm::dvec2 clearCourse(ui::HudState const& hud, glm::dvec2 wanted);
    ui::DirectStick fly(ui::HudState const& hud, Aim const& aim) const;

    core::GroundFunction ground_;
    double cruise_, slowest_;  // m/s, indicated
    bool outbound_ = false;  // passed the zone without a good release: flies on, then turns back
    int evading_ = 0;        // side of the turn that avoids terrain: -1 left, +1 right
    glm::dvec2 outboundCourse_{0.0, 1.0};
};
}  // namespace luftpost::bot
