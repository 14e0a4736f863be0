// What a flight is made from: with the list of stamped inputs, all that its bits depend on.
#pragma once
#include <string>
#include <vector>

#include "engine/core/frames.h"
#include "game/app/inputs.h"
#include "game/app/simulation.h"

namespace luftpost::app {
struct FlightPlan {
    WeatherInput weather;       // its source is not empty; with a recording the flight begins in it
    std::string weatherSha256;  // of the recording; empty: a preset
    core::UtcSeconds weatherLatest = 0.0;  // a METAR's month is the latest such day at or before this
    core::Place place;
    SimulationOptions simulation;
};

/// A flight that was flown: the replay file.
struct Replay {
    FlightPlan plan;
    long long ticks = 0;
    std::vector<StampedInput> inputs;  // by tick
};

/// Format "luftpost-replay-1" (JSON); numbers keep every bit.
std::string replayText(Replay const& replay);
/// Throws core::Error naming file, place and expectation; payload and fuel are held to what the chosen
/// airframe carries.
Replay readReplay(std::filesystem::path const& file, Hangar const& hangar);
}  // namespace luftpost::app
