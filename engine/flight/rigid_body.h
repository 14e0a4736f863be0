// How a rigid body moves under a force and a torque. Pure functions over plain data.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace luftpost::flight {
/// A force through the centre of gravity and a torque about it, in the body frame. N, N m.
struct Loads {
    glm::dvec3 force{0.0};
    glm::dvec3 torque{0.0};

    /// A force that acts `arm` (m) from the centre of gravity.
    void add(glm::dvec3 const& atForce, glm::dvec3 const& arm) {
        force += atForce;
        torque += glm::cross(arm, atForce);
    }
    Loads& operator+=(Loads const& other) {
        force += other.force;
        torque += other.torque;
        return *this;
    }
};

struct Motion {
    glm::dvec3 positionWorld{0.0};
    glm::dvec3 velocityWorld{0.0};
    glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 ratesBody{0.0};  // rad/s
};

/// One step of `dt` seconds. Semi-implicit for the position. Euler's equations by the midpoint rule, the
/// attitude turned by the mean rate of the step (a Lie group midpoint): without torque the body's momentum
/// only turns, so neither its size nor the energy drifts, however long. inertia in kg m2, body frame.
Motion moved(Motion const& motion, Loads const& loads, glm::dvec3 const& gravityWorld, double mass,
             glm::dmat3 const& inertia, double dt);
}  // namespace luftpost::flight
