// The log of a flight: one row at t = 0, 0.1, ... s, in the units of the contract.
#pragma once
#include <string>

#include "engine/core/frames.h"
#include "engine/flight/aircraft_state.h"
#include "game/app/geodesy.h"

namespace luftpost::app {
class FlightLog {
public:
    static constexpr int kTicksPerRow = core::kTicksPerSecond / 10;

    explicit FlightLog(core::Place const& place);

    /// Adds the row of this moment.
    void add(double seconds, flight::AircraftState const& state);
    /// Header and rows as CSV.
    std::string const& text() const { return text_; }

private:
    Geodesy geodesy_;
    std::string text_;
};
}  // namespace luftpost::app
