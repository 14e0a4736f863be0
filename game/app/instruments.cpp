#include "game/app/instruments.h"

#include <cmath>

#include "engine/core/frames.h"
#include "engine/flight/propeller.h"

namespace luftpost::app {
namespace {
std::optional<double> fuelSeconds(flight::Airframe const& airframe, flight::AircraftState const& aircraft) {
    double const flow = flight::fuelFlow(airframe.engine, aircraft.surfaces.throttle, aircraft.propellerRate,
                                         aircraft.readings.density);
    if (!(flow > 1.0e-6) || !(aircraft.fuel > 0.0)) return std::nullopt;
    return aircraft.fuel / flow;
}

/// At rest where it cannot taxi on: on its nose or side, without fuel, or held fast with the engine at work.
bool isStuck(Simulation const& simulation) {
    constexpr double kUpright = 0.7, kAtRest = 0.3;  // cosine; m/s
    flight::AircraftState const& aircraft = simulation.aircraft().state();
    double const upright = (aircraft.worldFromBody * glm::dvec3{0.0, 1.0, 0.0}).y;
    if (aircraft.readings.groundSpeed > kAtRest || !(aircraft.readings.onGround || upright < 0.0))
        return false;
    flight::Controls const& stick = simulation.stick().controls();
    return upright < kUpright || !(aircraft.fuel > 0.0) ||
           (stick.throttle > 0.6 && stick.brakes < 0.1 && aircraft.surfaces.throttle > 0.55);
}

ui::HudLanding landingOf(Landing const& landing, double seconds) {
    ui::HudLanding shown{landing.touchdownSpeed, landing.speed,   landing.loadFactor, landing.drift,
                         landing.bank,           landing.bounces, landing.touchAndGo};
    shown.onAirfield = landing.aim.has_value();
    if (landing.aim) shown.beyondAim = landing.aim->beyond, shown.offLine = landing.aim->offLine;
    shown.age = seconds - landing.endT;
    return shown;
}
}  // namespace

ui::HudState instruments(Simulation const& simulation) {
    flight::AircraftState const& aircraft = simulation.aircraft().state();
    flight::Readings const& readings = aircraft.readings;
    delivery::Delivery const& delivery = simulation.delivery();
    delivery::DropZone const& zone = delivery.target();
    flight::Controls const& levers = simulation.stick().controls();
    ui::HudState hud;
    hud.time = simulation.seconds();
    hud.utc = simulation.utc();
    hud.positionWorld = aircraft.positionWorld;
    hud.velocityWorld = aircraft.velocityWorld;
    hud.windWorld = readings.windWorld;
    hud.indicatedSpeed = readings.cas;
    hud.height = readings.height;
    hud.heading = readings.heading;
    hud.pitch = readings.pitch;
    hud.roll = readings.roll;
    hud.throttle = levers.throttle;
    hud.flaps = levers.flaps;
    hud.brakes = levers.brakes;
    hud.rpm = aircraft.propellerRate * 60.0 / (2.0 * core::kPi);
    hud.fuel_kg = aircraft.fuel;
    flight::Airframe const& airframe = simulation.aircraft().airframe();
    hud.fuelSeconds = fuelSeconds(airframe, aircraft);
    hud.marks = {airframe.stallSpeed, airframe.stallSpeedFlaps, airframe.flapLimitSpeed,
                 airframe.cruiseLimitSpeed, airframe.neverExceedSpeed};
    hud.alpha = readings.alpha;
    hud.stallMargin = readings.stallMargin;
    hud.loadFactor = readings.loadFactor;
    hud.sideLoad = readings.sideLoad;
    hud.turnRate = readings.yawRate;
    hud.elevatorTrim = levers.elevatorTrim;
    hud.rudderTrim = levers.rudderTrim;
    flight::AssistLevel const assist = simulation.settings().pilot.assist;
    hud.trimActs = assist == flight::AssistLevel::sim || assist == flight::AssistLevel::light;
    hud.stuck = isStuck(simulation);
    if (!simulation.landings().empty())
        hud.landing = landingOf(simulation.landings().back(), simulation.seconds());
    hud.stalled = readings.stallHorn;
    hud.onGround = readings.onGround;
    hud.target = ui::HudTarget{zone.name, core::worldFromEastNorth(zone.east, zone.north, zone.height),
                               delivery::kDropZoneRadius};
    hud.parcelReady = delivery.parcelAboard();
    hud.score = static_cast<int>(std::lround(delivery.score()));
    hud.deliveries = delivery.deliveries();
    return hud;
}
}  // namespace luftpost::app
