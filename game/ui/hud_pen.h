// What the parts of the HUD draw with. Between ScreenFrame::begin and end.
#pragma once
#include <string>

#include <glm/glm.hpp>

#include "engine/core/frames.h"
#include "game/ui/draw_text.h"
#include "game/ui/hud.h"

namespace luftpost::ui {
/// Lengths are units of 1/720 of the window's height.
struct Pen {
    ImDrawList& list;
    Fonts const& f;
    glm::vec2 size;
    float s;  // pixels per unit

    glm::vec2 px(float x, float y) const { return glm::round(glm::vec2{x, y} * s); }
    void plate(glm::vec2 from, glm::vec2 to, ImU32 fill = colour::kPlate) const {
        list.AddRectFilled(im(from), im(to), fill, 9.0f * s);
    }
};

inline constexpr ImU32 kTrough = IM_COL32(250, 245, 230, 60);  // what bars and scales lie in

inline double feet(double metres) { return metres / core::kMetresPerFoot; }
inline double knots(double speed) { return speed / core::kMetresPerSecondPerKnot; }

/// The tape of the airspeed on the left with the marks of the airframe.
void drawSpeedTape(Pen const& pen, HudState const& state);
/// Slip ball, angle of attack, load factor, trim: on the right, over the altitude.
void drawBalance(Pen const& pen, HudState const& state);
/// Where the mouse holds the stick: about the middle of the picture.
void drawMouseStick(Pen const& pen, HudState const& state);
/// How one came down, for some seconds.
void drawLanding(Pen const& pen, HudState const& state);
}  // namespace luftpost::ui
