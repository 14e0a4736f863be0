// The aircraft flown by a fixed hand in still air, beside the game and a little each frame: what the assist's settings do.
#pragma once
#include <optional>

#include "engine/flight/aircraft.h"
#include "game/app/flight_settings.h"
#include "game/ui/response_plot.h"

namespace luftpost::app {
class ResponseTrial {
public:
    explicit ResponseTrial(flight::Airframe airframe);
    /// Flies on for at most so many ticks; from the beginning when the settings have changed.
    void follow(PilotSettings const& pilot, flight::AssistSettings const& assist, int ticks);
    /// The curves of the last trials that were flown to the end; empty before the first.
    ui::ResponseCurves const& curves() const { return curves_; }

    static constexpr double kSeconds = 16.0;

private:
    struct Run {
        flight::Aircraft aircraft;
        PilotSettings pilot;
        flight::AssistSettings assist;
        std::vector<ui::ResponsePoint> points{};
        int tick = 0;
    };
    Run begin(PilotSettings const& pilot, flight::AssistSettings const& assist) const;
    /// True when it has come to its end.
    static bool fly(Run& run, int& ticks);

    flight::Airframe airframe_;
    std::optional<Run> now_, usual_;
    bool nowDone_ = false, usualDone_ = false;
    ui::ResponseCurves curves_;
};
}  // namespace luftpost::app
