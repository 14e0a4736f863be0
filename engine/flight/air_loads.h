// What the air does to the aircraft as a whole: the strips and the propeller, which share wash and downwash.
#pragma once
#include <array>

#include "engine/core/environment.h"
#include "engine/flight/aircraft_state.h"
#include "engine/flight/propeller.h"
#include "engine/flight/strip.h"

namespace luftpost::flight {
/// Mass, centre (datum frame) and inertia about it with the payload, fuel and ice of the moment.
struct MassProperties {
    double mass = 0.0;
    glm::dvec3 centre{0.0};
    glm::dmat3 inertia{1.0};
};
MassProperties massProperties(Airframe const& airframe, AircraftState const& state);

struct AirLoads {
    Loads loads;  // body frame, about the centre of gravity
    PropellerAnswer propeller;
    std::array<StripAnswer, kMaxStrips> strips{};
    double downwash = 0.0;  // rad, where the tail's downwash tends
};
/// From the state as it is: strips' winds, separation, downwash, surfaces, propeller rate. Pure.
/// `centre`: the air at the centre of gravity; `height`: of the wheels above the ground, m.
AirLoads airLoads(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                  core::AirSample const& centre, double height);
}  // namespace luftpost::flight
