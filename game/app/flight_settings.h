// The settings that change the flight: a change of one is a stamped input.
#pragma once
#include <tuple>

#include "engine/core/settings.h"
#include "engine/flight/assist.h"
#include "engine/flight/assist_settings.h"
#include "engine/flight/autopilot.h"
#include "engine/weather/cloud_settings.h"
#include "game/app/hangar.h"
#include "game/ui/input_settings.h"

namespace luftpost::app {
struct PilotSettings {
    AirframeChoice airframe = AirframeChoice::mailPlane;
    flight::AssistLevel assist = flight::AssistLevel::normal;
};
inline constexpr std::tuple pilotFields{
    core::Field{&PilotSettings::airframe, "aircraft.airframe", kAirframeWords,
                "What is flown: the light mail plane or the heavier, faster freight plane; from the next start or respawn (R) on"},
    core::Field{&PilotSettings::assist, "aircraft.assist", flight::kAssistWords,
                "Who moves the surfaces: sim (the stick), light, normal, easy (points where one steers)"}};

struct FlightSettings {
    PilotSettings pilot;
    flight::AssistSettings assist;
    flight::AutopilotSettings autopilot;
    ui::InputSettings input;
    weather::CloudSettings clouds;  // where there is cloud there is lift
};

/// Appends the list over `settings`.
inline void appendFlightSettings(core::SettingList& list, FlightSettings& settings) {
    core::appendSettings(list, settings.pilot, pilotFields);
    core::appendSettings(list, settings.assist, flight::assistFields);
    core::appendSettings(list, settings.autopilot, flight::autopilotFields);
    core::appendSettings(list, settings.input, ui::inputFields);
    core::appendSettings(list, settings.clouds, weather::cloudFields);
}
}  // namespace luftpost::app
