// Everything that changes the flight, in ticks of 1/240 s: clock, inputs, aircraft, parcel, job. The same
// inputs at the same ticks give the same bits, at any frame rate and with any number of workers.
#pragma once
#include <string>
#include <vector>

#include "engine/flight/aircraft.h"
#include "engine/flight/autopilot.h"
#include "game/app/flight_settings.h"
#include "game/app/inputs.h"
#include "game/app/landing.h"
#include "game/app/world.h"
#include "game/delivery/delivery.h"
#include "game/ui/input.h"

namespace luftpost::app {
/// How a flight begins. Angles in radians.
struct FlightStart {
    bool runway = false;    // on the airfield's threshold, nose into the wind; else in the air:
    double altitude = 0.0;  // m above sea level
    double tas = 50.0;      // m/s relative to the local air
    double heading = 0.0;   // clockwise from true north
    glm::dvec2 eastNorth{0.0};  // m from the origin, in the air
};

struct SimulationOptions {
    unsigned seed = 1;
    core::UtcSeconds time = 0.0;
    FlightStart start;
    double payload = 240.0, fuel = 100.0;  // kg
    FlightSettings settings;
};

/// What a tick brought about, for messages and sounds.
enum class FlightEvent { released, chuteOpened, delivered, lost, crashed, respawned, touchdown, landed, autopilot };
struct FlightEventAt {
    FlightEvent event = FlightEvent::released;
    glm::dvec3 positionWorld{0.0};
    std::string text;  // for the player; may be empty
};

class Simulation {
public:
    /// `world` must outlive the simulation. Throws core::Error when the start lies below the ground.
    Simulation(World& world, Hangar hangar, SimulationOptions const& options);
    Simulation(Simulation const&) = delete;
    Simulation& operator=(Simulation const&) = delete;

    /// Acts from the next step on. Throws core::Error where a weather's recording carries no field.
    void apply(FlightInput const& input);
    /// One tick.
    void step();

    long long tick() const { return tick_; }  // the next one to be stepped; its beginning is now
    double seconds() const { return static_cast<double>(tick_) * core::kTickSeconds; }
    /// The weather's clock.
    core::UtcSeconds utc() const { return clockUtc_ + clockRate_ * (static_cast<double>(tick_ - clockTick_) * core::kTickSeconds); }
    double clockRate() const { return clockRate_; }

    flight::Aircraft const& aircraft() const { return aircraft_; }
    /// Which of the hangar's that is.
    AirframeChoice airframeChoice() const { return flown_; }
    flight::AircraftState const& before() const {
        return before_;
    }  // of the tick before, for the picture between
    delivery::Delivery const& delivery() const { return delivery_; }
    ui::Stick const& stick() const { return stick_; }
    FlightSettings const& settings() const { return settings_; }
    /// The air at this tick, with the clouds as the settings have them.
    weather::AirInstant airNow() const { return airAt(utc()); }
    /// The same at another time of the weather's clock.
    weather::AirInstant airAt(core::UtcSeconds utc) const { return world_.air().instant(utc, settings_.clouds); }
    World const& world() const { return world_; }
    /// Where and when the aircraft broke.
    struct Crash {
        double seconds = 0.0;
        glm::dvec3 positionWorld{0.0};
    };
    std::vector<Crash> const& crashed() const { return crashed_; }
    int crashes() const { return static_cast<int>(crashed_.size()); }
    std::vector<Landing> const& landings() const { return landings_; }

    /// All that the flight goes on from, bit for bit.
    struct Moment {
        flight::AircraftState aircraft, before;
        delivery::Delivery delivery;
        FlightSettings settings;
        ui::InputSample sample;
        ui::Stick stick;
        long long tick = 0, clockTick = 0;
        core::UtcSeconds clockUtc = 0.0;
        double clockRate = 1.0;
        std::vector<Crash> crashed;
        LandingWatch landingWatch;
        std::vector<Landing> landings;
        AirframeChoice flown{};
        flight::AutopilotMemory autopilot;
        double payload = 0.0, fuel = 0.0;  // kg, of the start
        World::Held weather;
    };
    Moment moment() const;
    /// Of a simulation with the same options. Events not yet taken go.
    void goTo(Moment const& moment);

    /// What the autopilot flies, as the HUD says it; empty: it is off.
    std::string autopilotText() const;

    /// The events since the last call, in order.
    std::vector<FlightEventAt> takeEvents();
    /// 16 hex digits over everything that the flight's future depends on.
    std::string stateHash() const;

private:
    void setClock(core::UtcSeconds utc, double rate);
    core::AirFunction airAtAnyTime() const;
    void startFlight(SimulationOptions const& options);
    void releaseParcel();
    void switchAutopilot(bool on);
    void useChosenAirframe();
    void respawn();
    void stepAircraft(ui::Stick::Action const& action, core::AirFunction const& air);
    void stepDelivery(core::AirFunction const& air);
    void note(FlightEvent event, glm::dvec3 const& positionWorld, std::string text = {});

    World& world_;
    Hangar hangar_;
    AirframeChoice flown_;
    flight::Aircraft aircraft_;
    flight::AircraftState before_;
    delivery::Delivery delivery_;
    FlightSettings settings_;
    flight::AutopilotMemory autopilot_;
    ui::InputSample sample_;
    ui::Stick stick_;
    long long tick_ = 0;
    long long clockTick_ = 0;          // at this tick the weather's clock was set to ...
    core::UtcSeconds clockUtc_ = 0.0;  // ... this, and it runs on ...
    double clockRate_ = 1.0;           // ... so many times as fast
    double payload_ = 0.0, fuel_ = 0.0;  // kg, of the start
    std::vector<Crash> crashed_;
    LandingWatch landingWatch_;
    std::vector<Landing> landings_;
    std::vector<FlightEventAt> events_;
};
}  // namespace luftpost::app
