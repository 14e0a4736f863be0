#include "engine/flight/strip.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"

namespace luftpost::flight {
namespace {
constexpr double kPlateForce = 1.6;   // c: normal force of a thick plate of aspect ratio 7 across the flow
constexpr double kHysteresis = 0.05;  // rad, by which flow that has left comes back later
constexpr double kChordsToSeparate = 4.0;  // n: chord lengths of travel to gain or lose the flow

double smoothStep(double x) {
    double const t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// s_static of the header.
double staticSeparation(StripData const& strip, StripFlow const& flow, double alpha) {
    double const lost =
        strip.surfaceStall * std::max(flow.deflection, 0.0) + kHysteresis * flow.separation + 0.08 * flow.ice;
    double const above = alpha - (strip.stallAngle - lost);
    double const below = (strip.stallAngleNegative + lost) - alpha;
    return smoothStep(std::max(above, below) / strip.stallWidth + 0.5);
}
}  // namespace

StripAnswer stripAnswer(StripData const& strip, StripFlow const& flow) {
    double const forward = flow.velocityBody.x;
    double const across = glm::dot(flow.velocityBody, strip.normal);
    double const speed = std::sqrt(forward * forward + across * across);
    StripAnswer answer;
    if (speed < 1.0e-3) return answer;
    double const alpha = core::atan2(-across, forward) + strip.incidence;
    double const sine = core::sin(alpha), cosine = core::cos(alpha);

    double const attachedLift =
        strip.liftSlope * (1.0 - 0.2 * flow.ice) *
        (std::clamp(alpha, -0.7, 0.7) - strip.zeroLiftAngle + strip.surfaceLift * flow.deflection);
    double const attachedDrag = strip.dragZero * (1.0 + 2.0 * flow.ice) +
                                strip.inducedDrag * flow.inducedShare * attachedLift * attachedLift +
                                strip.surfaceDrag * flow.deflection * flow.deflection;
    double const attachedMoment = strip.momentZero + strip.surfaceMoment * flow.deflection;

    // A control in dead air still turns the plate a little.
    double const plateSine = sine + 0.3 * strip.surfaceLift * flow.deflection * cosine;
    double const plateNormal = kPlateForce * plateSine / (0.56 + 0.44 * std::abs(plateSine));
    double const plateArm = cosine >= 0.0 ? 0.25 * std::abs(sine) : 0.5 - 0.25 * std::abs(sine);  // chords

    double const s = flow.separation;
    double const lift = (1.0 - s) * attachedLift + s * plateNormal * cosine;
    double const drag = (1.0 - s) * attachedDrag + s * (strip.dragZero + plateNormal * sine);
    double const moment = (1.0 - s) * attachedMoment - s * plateNormal * plateArm;

    double const pressureArea = 0.5 * flow.density * speed * speed * strip.area;
    glm::dvec3 const x{1.0, 0.0, 0.0};
    glm::dvec3 const along = (x * forward + strip.normal * across) / speed;   // where the panel goes
    glm::dvec3 const upward = (strip.normal * forward - x * across) / speed;  // a quarter turn from it
    answer.forceBody = pressureArea * (lift * upward - drag * along);
    answer.torqueBody = pressureArea * strip.chord * moment * glm::cross(x, strip.normal);
    answer.alpha = alpha;
    answer.lift = lift;
    answer.separationStatic = staticSeparation(strip, flow, alpha);
    answer.separationRate = speed / (kChordsToSeparate * strip.chord);
    return answer;
}
}  // namespace luftpost::flight
