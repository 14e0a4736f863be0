#include "game/app/instruments.h"

#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::app {
ui::HudState instruments(Simulation const& simulation) {
    flight::AircraftState const& aircraft = simulation.aircraft().state();
    flight::Readings const& readings = aircraft.readings;
    delivery::Delivery const& delivery = simulation.delivery();
    delivery::DropZone const& zone = delivery.target();
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
    hud.throttle = simulation.stick().controls().throttle;
    hud.flaps = simulation.stick().controls().flaps;
    hud.brakes = simulation.stick().controls().brakes;
    hud.rpm = aircraft.propellerRate * 60.0 / (2.0 * core::kPi);
    hud.fuel_kg = aircraft.fuel;
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
