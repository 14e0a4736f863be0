#include "engine/flight/propeller.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::flight {
namespace {
struct Coefficients {
    double thrust, power;
};

/// Ct n^2 and Cp n^2 at n turns a second: with n^2 multiplied in, a stopped propeller needs no division by
/// zero.
Coefficients scaledCoefficients(PropellerData const& p, double axial, double turns) {
    double const last = p.advance.back();
    double const travelled = std::max(axial, 0.0) / p.diameter;  // J n
    if (travelled >= last * turns) {
        double const n = travelled / last;
        return {p.thrust.back() * n * n, p.power.back() * n * n};
    }
    double const j = travelled / turns;
    std::size_t i = 1;
    while (i + 1 < p.advance.size() && p.advance[i] < j) ++i;
    double const t = (j - p.advance[i - 1]) / (p.advance[i] - p.advance[i - 1]);
    double const n2 = turns * turns;
    return {(p.thrust[i - 1] + t * (p.thrust[i] - p.thrust[i - 1])) * n2,
            (p.power[i - 1] + t * (p.power[i] - p.power[i - 1])) * n2};
}

/// Power falls with the density ratio, and a little more (Gagg and Farrar).
double altitudeShare(EngineData const& engine, double density) {
    double const sigma = density / 1.225;
    return std::max((1.0 + engine.altitudeLoss) * sigma - engine.altitudeLoss, 0.0);
}
double throttleShare(EngineData const& engine, double share) {
    return engine.idleShare + (1.0 - engine.idleShare) * std::max(share, 0.0);
}
double shaftTorque(PropellerData const& p, double axial, double rate, double density) {
    double const cp = scaledCoefficients(p, axial, rate / (2.0 * core::kPi)).power;
    return cp * density * p.diameter * p.diameter * p.diameter * p.diameter * p.diameter / (2.0 * core::kPi);
}
}  // namespace

PropellerAnswer propellerAnswer(PropellerData const& p, glm::dvec3 const& velocityBody, double rate,
                                double density, glm::dvec3 const& arm) {
    double const axial = velocityBody.x, radius = 0.5 * p.diameter, disc = core::kPi * radius * radius;
    double const d2 = p.diameter * p.diameter;
    PropellerAnswer answer;
    answer.thrust = scaledCoefficients(p, axial, rate / (2.0 * core::kPi)).thrust * density * d2 * d2;
    answer.shaftTorque = shaftTorque(p, axial, rate, density);

    // Momentum theory: the wash has gained its full speed far behind the disc, half of it at the disc.
    double const inflow = std::max(axial, 0.0);
    double const far = std::sqrt(std::max(inflow * inflow + 2.0 * answer.thrust / (density * disc), 0.0));
    answer.washSpeed = far - inflow;
    double const throughDisc = 0.5 * (far + inflow);
    answer.swirlSpeed =
        answer.shaftTorque / (density * disc * std::max(throughDisc, 5.0) * (2.0 / 3.0) * radius);

    // P-factor: air that comes from below is met harder by the blade that goes down, on the right: the
    // thrust's centre moves that way. And the disc turns the air that comes across, which pushes the hub
    // along with it.
    double const blade = 0.25 * rate * radius;
    glm::dvec3 const inflowAcross =
        glm::dvec3{0.0, -velocityBody.y, -velocityBody.z} / std::sqrt(axial * axial + blade * blade + 1.0);
    double const limit = std::max(1.0, glm::length(inflowAcross));
    glm::dvec3 const bent = inflowAcross / limit;
    glm::dvec3 const centre = arm + p.offset * radius * glm::cross(glm::dvec3{1.0, 0.0, 0.0}, bent);
    glm::dvec3 const force =
        glm::dvec3{answer.thrust, 0.0, 0.0} + p.sideForce * std::abs(answer.thrust) * bent;
    answer.loads.add(force, centre);
    answer.loads.torque.x -= answer.shaftTorque;
    return answer;
}

double engineTorque(EngineData const& engine, double share, double rate, double density, bool fuel) {
    double const friction = engine.frictionTorque * std::min(rate / (0.1 * engine.rate), 1.0);
    if (!fuel) return -friction;
    double const rated = engine.power / engine.rate + engine.frictionTorque;
    double const overspeed = std::max(rate / engine.rate - 1.0, 0.0);  // the charge cannot follow
    return rated * throttleShare(engine, share) * altitudeShare(engine, density) / (1.0 + overspeed) -
           friction;
}

double fuelFlow(EngineData const& engine, double share, double rate, double density) {
    return engine.consumption * engine.power * throttleShare(engine, share) * altitudeShare(engine, density) *
           (rate / engine.rate);
}

double steadyRate(Airframe const& airframe, double share, double speed, double density, bool fuel) {
    double low = 0.0, high = 4.0 * airframe.engine.rate;
    for (int i = 0; i < 50; ++i) {
        double const middle = 0.5 * (low + high);
        bool const speedsUp = engineTorque(airframe.engine, share, middle, density, fuel) >
                              shaftTorque(airframe.propeller, speed, middle, density);
        (speedsUp ? low : high) = middle;
    }
    return 0.5 * (low + high);
}
}  // namespace luftpost::flight
