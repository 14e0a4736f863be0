// One aircraft in flight: rigid body, strips, propeller, wheels and assist, stepped once a tick. The air and
// the ground come in as functions. Same inputs, same bits, on every machine. Not for two threads at once.
#pragma once
#include <glm/glm.hpp>

#include "engine/core/environment.h"
#include "engine/flight/aircraft_state.h"
#include "engine/flight/airframe.h"
#include "engine/flight/assist.h"
#include "engine/flight/assist_settings.h"

namespace luftpost::flight {
class Aircraft {
public:
    /// Payload and fuel in kg, >= 0. The airframe is copied.
    Aircraft(Airframe airframe, double payload, double fuel);

    /// In the air at `positionWorld`, wings level, no sideslip, true airspeed `tas` (m/s) relative to the
    /// local air, nose to `heading` (rad clockwise from north); throttle and trim are solved for level
    /// flight: start the lever at state().trim.throttle, with the stick centred. Too slow or too fast for
    /// level flight: the nearest that can be.
    void startInAir(glm::dvec3 const& positionWorld, double heading, double tas, core::AirFunction const& air,
                    core::GroundFunction const& ground, core::UtcSeconds time);
    /// On its wheels at the point `east`, `north` (m), at rest, engine idling, nose to `heading`.
    void startOnRunway(double east, double north, double heading, core::AirFunction const& air,
                       core::GroundFunction const& ground, core::UtcSeconds time);
    /// As startInAir at the place of the crash, `height` above the ground there (and never below where the
    /// aircraft is), at a comfortable cruise; payload and fuel stay.
    void respawn(double height, core::AirFunction const& air, core::GroundFunction const& ground,
                 core::UtcSeconds time);

    /// One tick (1/240 s). `time` is that of the tick's beginning.
    void step(Controls const& stick, AssistLevel level, AssistSettings const& settings,
              core::AirFunction const& air, core::GroundFunction const& ground, core::UtcSeconds time);

    /// A parcel leaves (or comes aboard): the mass changes, nothing else. kg, >= 0.
    void setPayload(double payload) { state_.payload = payload; }
    void setFuel(double fuel) { state_.fuel = fuel; }

    AircraftState const& state() const { return state_; }
    /// Goes on from a kept state, bit for bit.
    void restore(AircraftState const& state) { state_ = state; }
    Airframe const& airframe() const { return airframe_; }

private:
    /// First readings of a state just placed.
    void begin(core::AirSample const& air, core::GroundFunction const& ground);

    Airframe airframe_;
    AircraftState state_;
};
}  // namespace luftpost::flight
