#include "engine/flight/air_loads.h"

#include <algorithm>
#include <cmath>

namespace luftpost::flight {
namespace {
constexpr double kIceThatSpoils = 60.0;  // kg of ice on the strips that spoils their sections wholly

void addPoint(MassProperties& sum, MassData const& point, double mass) {
    glm::dvec3 const r = point.position;
    sum.mass += mass;
    sum.centre += mass * r;
    sum.inertia += mass * (glm::dot(r, r) * glm::dmat3{1.0} - glm::outerProduct(r, r));
}

/// How far the surface of a strip is turned, trailing edge away from the normal.
double deflection(Airframe const& airframe, StripData const& strip, SurfaceCommands const& surfaces) {
    auto const travelled = [](double command, double up, double down) {
        return command > 0.0 ? -command * up : -command * down;
    };
    switch (strip.surface) {
        case ControlSurface::elevator:
            return travelled(surfaces.elevator, airframe.elevatorUp, airframe.elevatorDown);
        case ControlSurface::rudder:
            return travelled(surfaces.rudder, airframe.rudder, airframe.rudder);
        case ControlSurface::aileron: {
            double const onThisSide = strip.position.z > 0.0 ? surfaces.aileron : -surfaces.aileron;
            return travelled(onThisSide, airframe.aileronUp, airframe.aileronDown);
        }
        case ControlSurface::flap:
            return surfaces.flaps * airframe.flapTravel;
        case ControlSurface::none:
            break;
    }
    return 0.0;
}

/// The part of the induced drag that is left near the ground (McCormick).
double groundEffect(Airframe const& airframe, double height) {
    double const ratio = 16.0 * std::max(height + airframe.wingHeight, 0.1) / airframe.wingSpan;
    return ratio * ratio / (1.0 + ratio * ratio);
}

/// The velocity of the propeller's wash and the wing's downwash where a strip is, body frame.
glm::dvec3 inducedVelocity(StripData const& strip, PropellerAnswer const& propeller, glm::dvec3 const& shaft,
                           double downwash, double speed) {
    glm::dvec3 velocity{-strip.wash * propeller.washSpeed, 0.0, 0.0};
    if (strip.swirl > 0.0) {
        glm::dvec3 const across{0.0, strip.position.y - shaft.y, strip.position.z - shaft.z};
        double const distance = std::max(glm::length(across), 0.1);
        velocity +=
            strip.swirl * propeller.swirlSpeed * glm::cross(glm::dvec3{1.0, 0.0, 0.0}, across) / distance;
    }
    if (strip.place == StripPlace::tail) velocity -= downwash * speed * strip.normal;
    return velocity;
}
}  // namespace

MassProperties massProperties(Airframe const& airframe, AircraftState const& state) {
    MassProperties sum{0.0, glm::dvec3{0.0}, airframe.emptyInertia};
    addPoint(sum, airframe.empty, airframe.empty.mass);
    addPoint(sum, airframe.pilot, airframe.pilot.mass);
    addPoint(sum, airframe.payload, state.payload);
    addPoint(sum, airframe.fuel, state.fuel);
    sum.mass += state.ice;  // spread over the strips: about the centre
    sum.centre /= sum.mass;
    glm::dvec3 const c = sum.centre;
    sum.inertia -= sum.mass * (glm::dot(c, c) * glm::dmat3{1.0} - glm::outerProduct(c, c));
    return sum;
}

AirLoads airLoads(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                  core::AirSample const& centre, double height) {
    glm::dquat const bodyFromWorld = glm::conjugate(state.worldFromBody);
    glm::dvec3 const velocity = bodyFromWorld * (state.velocityWorld - centre.windWorld);
    double const speed = glm::length(velocity);
    AirLoads air;
    glm::dvec3 const shaftArm = airframe.propeller.position - masses.centre;
    air.propeller = propellerAnswer(airframe.propeller, velocity + glm::cross(state.ratesBody, shaftArm),
                                    state.propellerRate, centre.density, shaftArm);
    air.loads = air.propeller.loads;
    // The shaft is a gyroscope.
    air.loads.torque -=
        glm::cross(state.ratesBody, glm::dvec3{airframe.propeller.inertia * state.propellerRate, 0.0, 0.0});

    double const induced = groundEffect(airframe, height);
    double wingLift = 0.0;
    for (std::size_t i = 0; i < airframe.strips.size(); ++i) {
        StripData const& strip = airframe.strips[i];
        StripState const& kept = state.strips[i];
        glm::dvec3 const arm = strip.position - masses.centre;
        StripFlow flow;
        flow.velocityBody =
            bodyFromWorld * (state.velocityWorld - kept.windWorld) + glm::cross(state.ratesBody, arm) -
            inducedVelocity(strip, air.propeller, airframe.propeller.position, state.downwash, speed);
        flow.density = centre.density;
        flow.deflection = deflection(airframe, strip, state.surfaces);
        flow.inducedShare = strip.place == StripPlace::wing ? induced : 1.0;
        flow.ice = std::min(state.ice / kIceThatSpoils, 1.0);
        flow.separation = kept.separation;
        StripAnswer const answer = stripAnswer(strip, flow);
        air.loads.add(answer.forceBody, arm);
        air.loads.torque += answer.torqueBody;
        air.strips[i] = answer;
        if (strip.place == StripPlace::wing) wingLift += answer.lift * strip.area;
    }
    air.downwash = airframe.downwash * induced * wingLift / airframe.wingArea;
    return air;
}
}  // namespace luftpost::flight
