// Sprung wheels on the ground: a spring and a damper across the ground, friction along it.
#pragma once
#include <array>

#include "engine/core/environment.h"
#include "engine/flight/air_loads.h"

namespace luftpost::flight {
struct GroundLoads {
    Loads loads;  // body frame, about the centre of gravity
    std::array<WheelState, kMaxWheels> wheels{};
    double touchdownSpeed =
        0.0;               // m/s across the ground of the hardest wheel that has just met it; 0 for none
    bool inWater = false;  // a wheel has met water
};
/// `below` is the ground under the centre of gravity; a wheel well above it is not looked up.
GroundLoads groundLoads(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                        core::GroundSample const& below, core::GroundFunction const& ground, double dt);

/// The hull's first point under the ground, an index of airframe.strikes; -1 for none.
int strikeUnderGround(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                      core::GroundSample const& below, core::GroundFunction const& ground);

/// Metres from the lowest wheel (springs free) to the ground under the centre of gravity.
double wheelHeight(Airframe const& airframe, AircraftState const& state, MassProperties const& masses,
                   core::GroundSample const& below);
}  // namespace luftpost::flight
