// One flight with all that accompanies it: the list of inputs, the bot, the log, the hashes.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/app/flight_log.h"
#include "game/app/flight_plan.h"
#include "game/app/flight_track.h"
#include "game/app/flown_weather.h"
#include "game/app/report.h"
#include "game/app/simulation.h"
#include "game/app/world.h"
#include "game/bot/pilot.h"

namespace luftpost::app {
struct SessionOptions {
    FlightPlan plan;
    std::vector<StampedInput> script;  // by tick: the input file or a replay
    std::string bot;                   // of --bot, who flies; empty: the player
    bool log = false;                  // keep the log's rows
    bool track = false;                // keep the way for maps
    bool weather = false;              // keep the weather that is flown
};

class Session {
public:
    /// Throws core::Error when the weather cannot be loaded, is not the one of the plan, or the start lies
    /// underground.
    explicit Session(SessionOptions options);

    /// What the player or the bot does now: acts from the next tick and is kept for the replay. Throws as Simulation::apply does;
    /// then nothing has changed.
    void input(FlightInput const& what);
    /// Weather with a recording, from a feed or a hand: its field is made beside the frame, then it acts (`enterOffered`). Of
    /// several in a row only the last counts.
    void offerWeather(WeatherInput weather) { world_.offer(std::move(weather)); }
    /// Once a frame, before its ticks: what is ready acts from the next tick as a stamped input. A line where it cannot be used.
    std::optional<std::string> enterOffered();
    /// One tick: what is due of the script, the bot at 20 Hz, the simulation, log and hash.
    void tick();

    /// A moment of a flight that is all script, neither logged nor steered by the bot.
    struct Moment {
        Simulation::Moment simulation;
        std::size_t scriptDone = 0;
    };
    Moment moment() const { return {simulation_.moment(), scriptDone_}; }
    /// Of a session with the same plan and script. The report's hashes remain those of what was flown.
    void goTo(Moment const& moment);

    Simulation const& simulation() const { return simulation_; }
    std::vector<FlightEventAt> takeEvents() { return simulation_.takeEvents(); }
    World& world() { return world_; }
    World const& world() const { return world_; }

    /// The weather that was flown so far as the text of a recording: its own where the flight had but one, else what was kept of all.
    std::string weatherText();
    std::string const& logText() const { return log_.text(); }
    /// The way so far, with where parcels were released and came down and where the aircraft broke.
    FlightTrack track() const;
    Replay replay() const { return {options_.plan, simulation_.tick(), inputs_}; }
    /// What the flight itself knows of its report.
    FlightReport report() const;

private:
    void askPilot();
    void keepRow();
    void keepWay();

    SessionOptions options_;
    World world_;
    Simulation simulation_;
    FlightLog log_;
    FlightTrack track_;
    std::size_t scriptDone_ = 0;
    std::unique_ptr<bot::Pilot> pilot_;  // the bot
    ui::InputSample sample_;
    std::vector<StampedInput> inputs_;
    std::vector<std::string> hashes_;
    FlownWeather flown_;
};
}  // namespace luftpost::app
