// The strip: one panel of the aircraft in its own air. Written to be read.
//
// The problem. An aircraft in gusty air is not one point with one angle of attack: a gust lifts one wing
// before the other, a rolling wing meets the air from below on the side that goes down, one wing stalls first
// and the aircraft spins. Tables of coefficients for the whole aircraft do not know that. So the aircraft is
// cut into panels, each meets the air at its own place and answers alone; roll damping, adverse yaw, gust
// response and spin are sums.
//
// The flow. The panel moves through the air with
//     v = velocity of the centre of gravity + rates x arm - wind where the panel is
// in the body frame. The panel spans along f x n, where f is the body's x axis and n the panel's normal; flow
// along the span makes no lift (simple sweep theory), so only v_f = v.f and v_n = v.n count:
//     V^2 = v_f^2 + v_n^2,   angle of attack  alpha = atan2(-v_n, v_f) + incidence.
//
// Attached flow. Thin-airfoil theory gives lift in proportion to the angle from the zero-lift line; a surface
// of finite span loses part of the slope to its own downwash, which the data holds as the slope of the finite
// surface. A control turned by delta moves the zero-lift angle by tau delta:
//     Cl = a (alpha - alpha_0 + tau delta),   Cd = Cd_0 + k Cl^2 + d delta^2
// with k = 1 / (pi e A) of the whole wing, less near the ground, where the ground stops the trailing
// vortices' downwash (McCormick: factor (16 h/b)^2 / (1 + (16 h/b)^2)).
//
// Separated flow. At large angles, up to flying backwards, a panel is a flat plate whose force stands across
// it:
//     Cn = c sin(alpha) / (0.56 + 0.44 |sin(alpha)|),   Cl = Cn cos(alpha),   Cd = Cn sin(alpha)
//     (Lindenburg),
// acting half-way along the chord at 90 degrees instead of at its quarter.
//
// Between them. The share s of the chord whose flow has left goes from 0 to 1 across the stall angle
// (smoothly, over a width), and both answers are mixed by it. Flow that has left comes back only at a smaller
// angle: while separated, the stall angle counts as less (hysteresis). And it takes time, some chord lengths
// of travel, so a quick pull may pass the stall angle for a moment:
//     ds/dt = (s_static(alpha, s) - s) V / (n c).
#pragma once
#include <glm/glm.hpp>

#include "engine/flight/airframe.h"

namespace luftpost::flight {
/// What a strip meets.
struct StripFlow {
    glm::dvec3 velocityBody{0.0};  // m/s, of the strip through its own air, wash and downwash included
    double density = 1.225;        // kg/m3
    double deflection = 0.0;       // rad, trailing edge away from the normal: + is more lift
    double inducedShare = 1.0;     // ground effect on the induced drag
    double ice = 0.0;              // 0..1, how far ice has spoilt the section
    double separation = 0.0;       // 0..1, as it is
};
/// What it answers.
struct StripAnswer {
    glm::dvec3 forceBody{0.0};      // N, at the strip's quarter chord
    glm::dvec3 torqueBody{0.0};     // N m, about it
    double alpha = 0.0;             // rad
    double lift = 0.0;              // lift coefficient
    double separationStatic = 0.0;  // where the separation tends
    double separationRate = 0.0;    // 1/s, how fast it tends there
};

StripAnswer stripAnswer(StripData const& strip, StripFlow const& flow);
}  // namespace luftpost::flight
