// A fixed-pitch propeller on a piston engine. Thrust and power follow the coefficients over the advance ratio
// J = V / (n D), n in turns a second: T = Ct rho n^2 D^4, P = Cp rho n^3 D^5.
#pragma once
#include <glm/glm.hpp>

#include "engine/flight/airframe.h"
#include "engine/flight/rigid_body.h"

namespace luftpost::flight {
struct PropellerAnswer {
    Loads loads;          // body frame, about the centre of gravity: thrust, reaction to the shaft, P-factor
    double thrust = 0.0;  // N
    double shaftTorque = 0.0;  // N m, that the propeller takes from its shaft
    double washSpeed = 0.0;    // m/s, gained by the air far behind the disc
    double swirlSpeed = 0.0;   // m/s, of the wash about the shaft, with the propeller
};
/// `velocityBody`: of the propeller through the air; `rate` in rad/s, >= 0, turning about +x (clockwise seen
/// by the pilot); `arm`: from the centre of gravity. Past the table's end the coefficients grow as J^2, so
/// that a stopped propeller has a finite drag.
PropellerAnswer propellerAnswer(PropellerData const& propeller, glm::dvec3 const& velocityBody, double rate,
                                double density, glm::dvec3 const& arm);

/// N m on the shaft, friction taken off; `share` of full power (may exceed 1), `rate` in rad/s. No fuel:
/// friction alone.
double engineTorque(EngineData const& engine, double share, double rate, double density, bool fuel);
/// kg/s.
double fuelFlow(EngineData const& engine, double share, double rate, double density);
/// The rate (rad/s) at which the engine's torque and the propeller's are equal at axial speed `speed`.
double steadyRate(Airframe const& airframe, double share, double speed, double density, bool fuel);
}  // namespace luftpost::flight
