#include "engine/flight/rigid_body.h"

#include <cmath>

#include "engine/core/math.h"

namespace luftpost::flight {
glm::dquat turnBy(glm::dvec3 const& rotation) {
    double const angle = glm::length(rotation);
    // sin(a/2)/a without a division by nothing; the series is exact to the last bit that small.
    double const share = angle > 1.0e-4 ? core::sin(0.5 * angle) / angle : 0.5 - angle * angle / 48.0;
    return glm::dquat{core::cos(0.5 * angle), share * rotation.x, share * rotation.y, share * rotation.z};
}

Motion moved(Motion const& motion, Loads const& loads, glm::dvec3 const& gravityWorld, double mass,
             glm::dmat3 const& inertia, double dt) {
    glm::dquat const& start = motion.worldFromBody;
    glm::dmat3 const inverse = glm::inverse(inertia);
    glm::dvec3 const momentumWorld = start * (inertia * motion.ratesBody + loads.torque * dt);
    auto const ratesAt = [&](glm::dquat const& attitude) {
        return inverse * (glm::conjugate(attitude) * momentumWorld);
    };
    glm::dvec3 middle = ratesAt(start);
    for (int i = 0; i < 3; ++i) middle = ratesAt(start * turnBy(middle * (0.5 * dt)));

    Motion next;
    next.worldFromBody = glm::normalize(start * turnBy(middle * dt));
    next.ratesBody = ratesAt(next.worldFromBody);
    next.velocityWorld = motion.velocityWorld + (gravityWorld + (start * loads.force) / mass) * dt;
    next.positionWorld = motion.positionWorld + next.velocityWorld * dt;
    return next;
}
}  // namespace luftpost::flight
