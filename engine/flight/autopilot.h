// The autopilot for long legs: hands that hold a course, an altitude and a speed. They move the stick of assist normal,
// whatever the player's level is, so it flies each airframe and each air that this assist flies.
#pragma once
#include <tuple>

#include "engine/core/settings.h"
#include "engine/flight/aircraft_state.h"

namespace luftpost::flight {
enum class AutopilotCourse { engaged, heading, target };
inline constexpr std::array<std::string_view, 3> kAutopilotCourseWords{"engaged", "heading", "target"};

struct AutopilotSettings {
    AutopilotCourse course = AutopilotCourse::engaged;
    double heading_deg = 0.0;
    double altitude_ft = 0.0;  // what the HUD reads in
    double climb_fpm = 500.0;
};
inline constexpr std::tuple autopilotFields{
    core::Field{&AutopilotSettings::course, "aircraft.autopilotCourse", kAutopilotCourseWords,
                "What the autopilot steers: the heading it was engaged on, the heading below, or to the target (the drop zone)"},
    core::Field{&AutopilotSettings::heading_deg, "aircraft.autopilotHeading_deg", 0.0, 360.0,
                "Heading of the autopilot in degrees from true north, where the course says so"},
    core::Field{&AutopilotSettings::altitude_ft, "aircraft.autopilotAltitude_ft", 0.0, 20000.0,
                "Altitude of the autopilot in feet above sea level; 0: the one where it was engaged"},
    core::Field{&AutopilotSettings::climb_fpm, "aircraft.autopilotClimb_fpm", 100.0, 1500.0,
                "Fastest climb or descent of the autopilot in feet a minute; the speed comes first"}};

/// What it carries from tick to tick; part of the state hash.
struct AutopilotMemory {
    bool engaged = false;
    double heading = 0.0;   // rad, when it was engaged
    double altitude = 0.0;  // m above sea level, the same
    double speed = 0.0;     // m/s calibrated, held by power
    double power = 0.0;     // 0..1, what the speed needs so far
    double turned = 0.0;    // rad, what its knobs add to the heading, engaged or set ...
    double raised = 0.0;    // m, ... and to the altitude

    template <class Take>
    void forEachNumber(Take&& take) const {
        for (double value : {engaged ? 1.0 : 0.0, heading, altitude, speed, power, turned, raised}) take(value);
    }
};

/// From now on this heading, this altitude, this speed (within what the airframe cruises at).
AutopilotMemory engagedAutopilot(Airframe const& airframe, AircraftState const& state);
/// Its knobs in this tick: the lever's whole travel is from the slowest speed to the airframe's cruise limit; `climb` and `turn`,
/// -1..1, move the altitude by 40 ft and the heading by 5 degrees a second.
void turnKnobs(AutopilotMemory& memory, Airframe const& airframe, double lever, double climb, double turn);
/// The heading that it flies to, rad from true north; not on the way to a target.
double autopilotHeading(AutopilotSettings const& settings, AutopilotMemory const& memory);
/// True where the player takes over: a stick or pedal moved well out of its centre.
bool takesOver(Controls const& stick);
/// The hands of this tick, for assist normal; `targetEastNorth` in m.
Controls autopilotHands(AircraftState const& state, Airframe const& airframe, AutopilotSettings const& settings,
                        glm::dvec2 targetEastNorth, AutopilotMemory& memory);
/// The altitude that it flies to, m above sea level.
double autopilotAltitude(AutopilotSettings const& settings, AutopilotMemory const& memory);
}  // namespace luftpost::flight
