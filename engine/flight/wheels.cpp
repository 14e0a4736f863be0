#include "engine/flight/wheels.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"

namespace luftpost::flight {
namespace {
constexpr double kNear = 12.0;  // m; the hull reaches no farther, and ground rises no more beside it
constexpr double kSlipOfFullGrip =
    0.1;  // m/s; friction comes in over this much slip, so that a tyre can stand still
constexpr double kBottomed = 0.35;  // m of compression where the leg is at its end

core::GroundSample groundAt(core::GroundFunction const& ground, glm::dvec3 const& pointWorld) {
    return ground(pointWorld.x, -pointWorld.z);
}
bool isNear(glm::dvec3 const& pointWorld, core::GroundSample const& below) {
    return pointWorld.y - below.height < kNear;
}

/// Friction along the ground: rolling and brakes along the wheel, side force across it, together inside one
/// circle.
glm::dvec3 friction(WheelData const& wheel, double load, double brakes, glm::dvec3 const& velocity,
                    glm::dvec3 const& along, glm::dvec3 const& across) {
    auto const grip = [](double slip) { return std::clamp(slip / kSlipOfFullGrip, -1.0, 1.0); };
    double const rolling =
        wheel.skid ? wheel.rolling : wheel.rolling + wheel.braking * std::clamp(brakes, 0.0, 1.0);
    double forward = -rolling * grip(glm::dot(velocity, along));
    double side = -wheel.side * grip(glm::dot(velocity, across));
    double const most = std::max(wheel.side, rolling), both = std::sqrt(forward * forward + side * side);
    if (both > most) forward *= most / both, side *= most / both;
    return load * (forward * along + side * across);
}
}  // namespace

GroundLoads groundLoads(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                        core::GroundSample const& below, core::GroundFunction const& ground, double dt) {
    GroundLoads answer;
    glm::dquat const bodyFromWorld = glm::conjugate(state.worldFromBody);
    for (std::size_t i = 0; i < airframe.wheels.size(); ++i) {
        WheelData const& wheel = airframe.wheels[i];
        WheelState& now = answer.wheels[i];
        now.angle = state.wheels[i].angle;
        glm::dvec3 const arm = wheel.position - masses.centre;
        glm::dvec3 const pointWorld = state.positionWorld + state.worldFromBody * arm;
        if (!isNear(pointWorld, below)) continue;
        core::GroundSample const under = groundAt(ground, pointWorld);
        double const depth = (under.height - pointWorld.y) * under.normalWorld.y;
        if (depth <= 0.0) continue;
        now.contact = true;
        now.compression = std::min(depth, kBottomed);

        glm::dvec3 const normal = bodyFromWorld * under.normalWorld;
        glm::dvec3 const velocity = bodyFromWorld * state.velocityWorld + glm::cross(state.ratesBody, arm);
        double const rising = glm::dot(velocity, normal);
        now.load = std::clamp(wheel.stiffness * now.compression - wheel.damping * rising, 0.0,
                              4.0 * wheel.stiffness * kBottomed);
        double const turn = wheel.steering * state.surfaces.rudder;
        glm::dvec3 const ahead{core::cos(turn), 0.0, core::sin(turn)};
        glm::dvec3 along = ahead - normal * glm::dot(ahead, normal);
        along /= std::max(glm::length(along), 1.0e-3);
        glm::dvec3 const across = glm::cross(along, normal);
        glm::dvec3 const rub = friction(wheel, now.load, state.surfaces.brakes, velocity, along, across);
        answer.loads.add(now.load * normal + rub, arm + normal * now.compression);

        now.slip = std::abs(glm::dot(velocity, across));
        now.angle += glm::dot(velocity, along) * dt / 0.2;
        if (!state.wheels[i].contact) answer.touchdownSpeed = std::max(answer.touchdownSpeed, -rising);
        answer.inWater = answer.inWater || under.surface == core::Surface::water;
    }
    return answer;
}

int strikeUnderGround(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                      core::GroundSample const& below, core::GroundFunction const& ground) {
    for (std::size_t i = 0; i < airframe.strikes.size(); ++i) {
        glm::dvec3 const pointWorld =
            state.positionWorld + state.worldFromBody * (airframe.strikes[i].position - masses.centre);
        if (isNear(pointWorld, below) && pointWorld.y < groundAt(ground, pointWorld).height)
            return static_cast<int>(i);
    }
    return -1;
}

double wheelHeight(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                   core::GroundSample const& below) {
    double lowest = 1.0e9;
    for (WheelData const& wheel : airframe.wheels)
        lowest = std::min(lowest, (state.worldFromBody * (wheel.position - masses.centre)).y);
    return state.positionWorld.y + lowest - below.height;
}
}  // namespace luftpost::flight
