// From the stick to the surfaces, at each level of assist.
#pragma once
#include "engine/flight/aircraft_state.h"
#include "engine/flight/assist_settings.h"

namespace luftpost::flight {
/// The commands for this tick from the stick and from what the instruments read at the end of the last one.
/// `memory` is carried on. dt in s.
SurfaceCommands assistedCommands(Airframe const& airframe, AircraftState const& state, Controls const& stick,
                                 AssistLevel level, AssistSettings const& settings, AssistMemory& memory,
                                 double dt);

/// Each value in its range, what is not a number as 0.
Controls cleaned(Controls const& stick);
}  // namespace luftpost::flight
