// Level flight without acceleration: the attitude, surfaces and power that give it.
#pragma once
#include "engine/flight/air_loads.h"

namespace luftpost::flight {
/// Sets attitude, surfaces, trim, propeller rate, downwash and separation of `state` for wings-level flight
/// through uniform air at true airspeed `tas` (m/s), nose to `heading` (rad). Payload, fuel, position and the
/// strips' wind are taken as they are. Where no power or angle of attack holds level flight, the nearest.
void trimForLevelFlight(Airframe const& airframe, AircraftState& state, core::AirSample const& air,
                        double heading, double tas, double height);

/// Attitude from heading (clockwise from north), pitch (nose up) and roll (right wing down), rad.
glm::dquat attitude(double heading, double pitch, double roll);
}  // namespace luftpost::flight
