#include "game/app/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/math.h"
#include "game/app/runway_start.h"
#include "game/app/state_hash.h"

namespace luftpost::app {
namespace {
constexpr double kRespawnHeight = 300.0;  // m above the ground
constexpr double kFuelThatFlies = 5.0;    // kg; with less, a respawn fills up

glm::dvec2 directionEastNorth(double heading) { return {core::sin(heading), core::cos(heading)}; }

RunwayStart runwayStart(World const& world, SimulationOptions const& options) {
    return app::runwayStart(world.land(), world.field(), options.time);
}
glm::dvec2 startEastNorth(World const& world, SimulationOptions const& options) {
    return options.start.runway ? runwayStart(world, options).eastNorth : options.start.eastNorth;
}
double startHeading(World const& world, SimulationOptions const& options) {
    return options.start.runway ? runwayStart(world, options).heading : options.start.heading;
}
}  // namespace

Simulation::Simulation(World& world, Hangar hangar, SimulationOptions const& options)
    : world_{world},
      hangar_{std::move(hangar)},
      flown_{options.settings.pilot.airframe},
      aircraft_{chosen(hangar_, flown_), options.payload, options.fuel},
      delivery_{options.seed, startEastNorth(world, options),
                directionEastNorth(startHeading(world, options)), world.ground()},
      settings_{options.settings},
      clockUtc_{options.time},
      payload_{options.payload},
      fuel_{options.fuel} {
    startFlight(options);
    stick_.begin(std::min(aircraft_.state().trim.throttle / settings_.assist.maxThrottle, 1.0));
    before_ = aircraft_.state();
}

void Simulation::startFlight(SimulationOptions const& options) {
    core::AirFunction const air = airAtAnyTime();
    if (options.start.runway) {
        RunwayStart const start = runwayStart(world_, options);
        aircraft_.startOnRunway(start.eastNorth.x, start.eastNorth.y, start.heading, air, world_.ground(),
                                options.time);
        return;
    }
    glm::dvec2 const place = options.start.eastNorth;
    double const ground = world_.ground()(place.x, place.y).height;
    if (!(options.start.altitude > ground))
        throw core::Error{"--start", "",
                          fmt::format("expected an altitude above the ground, {:.0f} m, found {}", ground,
                                      options.start.altitude)};
    aircraft_.startInAir(core::worldFromEastNorth(place.x, place.y, options.start.altitude),
                         options.start.heading, options.start.tas, air, world_.ground(), options.time);
}

void Simulation::apply(FlightInput const& input) {
    if (auto const* sample = std::get_if<ui::InputSample>(&input)) sample_ = *sample;
    if (auto const* weather = std::get_if<WeatherInput>(&input)) world_.use(*weather);
    if (auto const* clock = std::get_if<ClockInput>(&input)) setClock(clock->utc, clockRate_);
    if (auto const* clock = std::get_if<ClockRateInput>(&input)) setClock(utc(), clock->rate);
    if (auto const* change = std::get_if<SettingInput>(&input)) {
        core::SettingList list;
        appendFlightSettings(list, settings_);
        core::Setting* const setting = core::findSetting(list, change->key);
        CHECK(setting, "{} does not change the flight", change->key);
        setting->set(change->value);
        // What is set in the menu holds as it stands there: the knobs begin anew from it.
        if (change->key == "aircraft.autopilotAltitude_ft") autopilot_.raised = 0.0;
        if (change->key == "aircraft.autopilotHeading_deg" || change->key == "aircraft.autopilotCourse") autopilot_.turned = 0.0;
    }
}

void Simulation::setClock(core::UtcSeconds utc, double rate) {
    clockTick_ = tick_;
    clockUtc_ = utc;
    clockRate_ = rate;
}

void Simulation::step() {
    weather::AirInstant const instant = airNow();
    core::AirFunction const air = [&instant](glm::dvec3 const& p, core::UtcSeconds) { return instant.at(p); };
    ui::Stick::Action const action = stick_.step(sample_, settings_.input, autopilot_.engaged);
    if (action.respawn) respawn();
    if (action.drop) releaseParcel();
    if (action.autopilot) switchAutopilot(!autopilot_.engaged);
    stepAircraft(action, air);
    stepDelivery(air);
    ++tick_;
    if (aircraft_.state().crashed()) {
        crashed_.push_back({seconds(), aircraft_.state().positionWorld});
        note(FlightEvent::crashed, aircraft_.state().positionWorld,
             flight::crashText(aircraft_.airframe(), aircraft_.state()));
        respawn();
    }
}

void Simulation::stepAircraft(ui::Stick::Action const& action, core::AirFunction const& air) {
    before_ = aircraft_.state();
    flight::Controls controls = action.controls;
    controls.throttle = stick_.controls().throttle;  // a respawn in this tick has moved the lever
    flight::AssistLevel level = settings_.pilot.assist;
    flight::AssistSettings assist = settings_.assist;
    if (autopilot_.engaged && flight::takesOver(controls)) switchAutopilot(false);
    if (autopilot_.engaged) {
        delivery::DropZone const& zone = delivery_.target();
        flight::turnKnobs(autopilot_, aircraft_.airframe(), action.leverMoved, action.trimPitch, action.trimYaw);
        double const flaps = controls.flaps;
        controls = flight::autopilotHands(aircraft_.state(), aircraft_.airframe(), settings_.autopilot,
                                          {zone.east, zone.north}, autopilot_);
        controls.flaps = flaps;
        level = flight::AssistLevel::normal;
        assist = flight::AssistSettings{.maxThrottle = settings_.assist.maxThrottle};
        stick_.setThrottle(controls.throttle);  // the lever goes along
    }
    aircraft_.step(controls, level, assist, air, world_.ground(), utc());
    flight::AircraftState const& now = aircraft_.state();
    if (now.touchdownTick != before_.touchdownTick && now.touchdownTick >= 0)
        note(FlightEvent::touchdown, now.positionWorld,
             fmt::format("Touchdown at {:.1f} m/s", now.touchdownSpeed));
    if (auto const landing = landingWatch_.step(now, world_.land().runway(), seconds())) {
        landings_.push_back(*landing);
        note(FlightEvent::landed, now.positionWorld);
    }
}

/// In the air only: on the wheels there is nothing to hold.
void Simulation::switchAutopilot(bool on) {
    if (on && aircraft_.state().readings.onGround) return;
    autopilot_ = on ? flight::engagedAutopilot(aircraft_.airframe(), aircraft_.state()) : flight::AutopilotMemory{};
    if (!on) note(FlightEvent::autopilot, aircraft_.state().positionWorld, "Autopilot off: you have the stick");
}

std::string Simulation::autopilotText() const {
    using flight::AutopilotCourse;
    if (!autopilot_.engaged) return {};
    AutopilotCourse const course = settings_.autopilot.course;
    double const heading = core::degrees(flight::autopilotHeading(settings_.autopilot, autopilot_)) + 360.0;
    std::string const steers = course == AutopilotCourse::target ? "to " + delivery_.target().name
                                                                 : fmt::format("heading {:.0f}", std::fmod(heading, 360.0));
    double const altitude_ft = flight::autopilotAltitude(settings_.autopilot, autopilot_) / core::kMetresPerFoot;
    return fmt::format("AUTOPILOT  {}  altitude {:.0f} ft  speed {:.0f} kt", steers, altitude_ft,
                       autopilot_.speed / core::kMetresPerSecondPerKnot);
}

void Simulation::releaseParcel() {
    flight::AircraftState const& state = aircraft_.state();
    glm::dvec3 const hatch = state.positionWorld + state.worldFromBody * glm::dvec3{0.0, -0.8, 0.0};
    if (delivery_.release(hatch, state.velocityWorld, seconds()) != delivery::DeliveryEvent::released) return;
    aircraft_.setPayload(std::max(0.0, payload_ - delivery_.parcelData().mass));
    note(FlightEvent::released, hatch);
}

void Simulation::stepDelivery(core::AirFunction const& air) {
    using delivery::DeliveryEvent;
    delivery::DropZone const due = delivery_.target();
    DeliveryEvent const event = delivery_.step(air, world_.ground(), seconds(), utc());
    if (event == DeliveryEvent::none) return;
    if (event == DeliveryEvent::chuteOpened)
        return note(FlightEvent::chuteOpened, delivery_.parcel()->positionWorld);
    aircraft_.setPayload(payload_);
    delivery::Drop const& drop = delivery_.drops().back();
    if (event == DeliveryEvent::delivered)
        note(FlightEvent::delivered, drop.landingWorld,
             fmt::format("Delivered at {}: {:.0f} points, {:.0f} m from the centre", due.name, drop.score,
                         drop.distance));
    if (event == DeliveryEvent::lost)
        note(FlightEvent::lost, drop.landingWorld,
             fmt::format("The parcel is lost: {:.0f} m from the centre of {}. A new one is aboard",
                         drop.distance, due.name));
}

/// Another airframe takes over the place; it carries what it can of the load.
void Simulation::useChosenAirframe() {
    if (settings_.pilot.airframe == flown_) return;
    flown_ = settings_.pilot.airframe;
    flight::Airframe const& airframe = chosen(hangar_, flown_);
    flight::AircraftState state = aircraft_.state();
    payload_ = std::min(payload_, airframe.payloadMax);
    fuel_ = std::min(fuel_, airframe.fuelMax);
    state.payload = std::min(state.payload, airframe.payloadMax);
    state.fuel = std::min(state.fuel, airframe.fuelMax);
    aircraft_ = flight::Aircraft{airframe, state.payload, state.fuel};
    aircraft_.restore(state);
}

void Simulation::respawn() {
    useChosenAirframe();
    autopilot_ = {};
    core::AirFunction const air = airAtAnyTime();
    if (aircraft_.state().fuel < kFuelThatFlies) aircraft_.setFuel(std::max(fuel_, kFuelThatFlies));
    aircraft_.respawn(kRespawnHeight, air, world_.ground(), utc());
    stick_.begin(std::min(aircraft_.state().trim.throttle / settings_.assist.maxThrottle, 1.0));
    before_ = aircraft_.state();
    landingWatch_.forget();
    note(FlightEvent::respawned, aircraft_.state().positionWorld);
}

void Simulation::note(FlightEvent event, glm::dvec3 const& positionWorld, std::string text) {
    events_.push_back({event, positionWorld, std::move(text)});
}

core::AirFunction Simulation::airAtAnyTime() const {
    return [this](glm::dvec3 const& p, core::UtcSeconds t) {
        return world_.air().instant(t, settings_.clouds).at(p);
    };
}

Simulation::Moment Simulation::moment() const {
    return {aircraft_.state(), before_, delivery_, settings_, sample_, stick_, tick_, clockTick_, clockUtc_, clockRate_, crashed_, landingWatch_, landings_, flown_, autopilot_, payload_, fuel_,
            world_.held()};
}

void Simulation::goTo(Moment const& moment) {
    if (moment.flown != flown_) aircraft_ = flight::Aircraft{chosen(hangar_, moment.flown), moment.aircraft.payload, moment.aircraft.fuel};
    aircraft_.restore(moment.aircraft);
    flown_ = moment.flown;
    autopilot_ = moment.autopilot;
    payload_ = moment.payload;
    fuel_ = moment.fuel;
    before_ = moment.before;
    delivery_ = moment.delivery;
    settings_ = moment.settings;
    sample_ = moment.sample;
    stick_ = moment.stick;
    tick_ = moment.tick;
    clockTick_ = moment.clockTick;
    clockUtc_ = moment.clockUtc;
    clockRate_ = moment.clockRate;
    crashed_ = moment.crashed;
    landingWatch_ = moment.landingWatch;
    landings_ = moment.landings;
    world_.takeBack(moment.weather);
    events_.clear();
}

std::vector<FlightEventAt> Simulation::takeEvents() { return std::exchange(events_, {}); }

std::string Simulation::stateHash() const {
    StateHash hash;
    auto const take = [&](double value) { hash.take(value); };
    flight::forEachNumber(aircraft_.state(), take);
    delivery::forEachNumber(delivery_, take);
    stick_.forEachNumber(take);
    autopilot_.forEachNumber(take);
    take(static_cast<double>(flown_));
    take(static_cast<double>(tick_));
    take(utc()), take(clockRate_);
    hash.take(delivery_.randomState());
    return hash.text();
}
}  // namespace luftpost::app
