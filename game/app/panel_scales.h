// The scales of the dials in the cockpit: assets/make/models.py draws the figures and game/app/panel.cpp turns the needles by
// these very rows.
#pragma once
#include <array>
#include <string_view>

namespace luftpost::app {
/// A needle's node, the readings at both ends of its scale and where it then points: degrees clockwise from the top, as the pilot
/// sees it. A needle stops at the ends; one whose ends are a turn apart goes round.
struct DialScale {
    std::string_view node;
    double low, high, lowAngle_deg, highAngle_deg;
};
inline constexpr std::array kDialScales{
    DialScale{"needle_airspeed", 40.0, 180.0, 20.0, 335.0},          // kt
    DialScale{"needle_altitude", 0.0, 1000.0, 0.0, 360.0},           // ft
    DialScale{"needle_altitude_short", 0.0, 10000.0, 0.0, 360.0},    // ft
    DialScale{"needle_climb", -2000.0, 2000.0, -260.0, 80.0},        // ft/min
    DialScale{"needle_turn", -6.0, 6.0, -40.0, 40.0},                // degrees a second
    DialScale{"needle_rpm", 0.0, 3000.0, -135.0, 135.0},             // a minute
    DialScale{"needle_fuel", 0.0, 160.0, -60.0, 60.0},               // kg
    DialScale{"needle_angle", -10.0, 20.0, -120.0, 120.0},           // degrees, angle of attack
    DialScale{"needle_load", -2.0, 4.0, -150.0, 150.0},              // g
    DialScale{"needle_flaps", 0.0, 100.0, -90.0, 90.0},              // share of the travel, percent
};
}  // namespace luftpost::app
