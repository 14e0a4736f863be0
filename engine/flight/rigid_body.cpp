#include "engine/flight/rigid_body.h"

namespace luftpost::flight {
namespace {
/// The turn of a step `dt` at the steady rate `rates`, by the Cayley map: the exponential map's rational
/// twin, which makes the step below keep the energy exactly where the exponential map only keeps it near.
glm::dquat turned(glm::dvec3 const& rates, double dt) {
    glm::dvec3 const half = rates * (0.5 * dt);
    return glm::normalize(glm::dquat{1.0, half.x, half.y, half.z});
}
}  // namespace

Motion moved(Motion const& motion, Loads const& loads, glm::dvec3 const& gravityWorld, double mass,
             glm::dmat3 const& inertia, double dt) {
    glm::dmat3 const inverse = glm::inverse(inertia);
    glm::dvec3 const before = inertia * motion.ratesBody + loads.torque * dt;  // angular momentum, body frame
    glm::dvec3 after = before;
    glm::dquat turn{1.0, 0.0, 0.0, 0.0};
    // Fixed point of the midpoint rule; each round gains a factor |rates| dt / 2.
    for (int i = 0; i < 10; ++i) {
        turn = turned(inverse * (0.5 * (before + after)), dt);
        after = glm::conjugate(turn) * before;
    }
    Motion next;
    next.worldFromBody = glm::normalize(motion.worldFromBody * turn);
    next.ratesBody = inverse * after;
    next.velocityWorld =
        motion.velocityWorld + (gravityWorld + (motion.worldFromBody * loads.force) / mass) * dt;
    next.positionWorld = motion.positionWorld + next.velocityWorld * dt;
    return next;
}
}  // namespace luftpost::flight
