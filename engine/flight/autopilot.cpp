#include "engine/flight/autopilot.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::flight {
namespace {
constexpr double kSteepestBank = core::radians(25.0);
constexpr double kTakeOver = 0.15;  // share of the stick's travel
constexpr double kSlowest = 1.35, kGuarded = 1.25;  // stalls
constexpr double kRaising = 40.0 * core::kMetresPerFoot, kTurning = core::radians(5.0);  // a second

/// -pi..pi, from one angle to another.
double turn(double from, double to) { return core::atan2(core::sin(to - from), core::cos(to - from)); }

/// How far the nose, or the way over the ground, has to turn right; rad.
double turnWanted(AircraftState const& state, AutopilotSettings const& settings, glm::dvec2 targetEastNorth,
                  AutopilotMemory const& memory) {
    Readings const& now = state.readings;
    if (settings.course != AutopilotCourse::target) return turn(now.heading, autopilotHeading(settings, memory));
    double const east = targetEastNorth.x - state.positionWorld.x, north = targetEastNorth.y + state.positionWorld.z;
    return turn(core::atan2(state.velocityWorld.x, -state.velocityWorld.z), core::atan2(east, north));
}

double climbWanted(AircraftState const& state, Airframe const& airframe, AutopilotSettings const& settings,
                   AutopilotMemory const& memory) {
    double const most = settings.climb_fpm * core::kMetresPerFoot / 60.0;
    double const climb = std::clamp(0.2 * (autopilotAltitude(settings, memory) - state.positionWorld.y), -most, most);
    return std::min(climb, 0.8 * (state.readings.cas - kGuarded * airframe.stallSpeed));
}
}  // namespace

AutopilotMemory engagedAutopilot(Airframe const& airframe, AircraftState const& state) {
    Readings const& now = state.readings;
    double const speed = std::clamp(now.cas, kSlowest * airframe.stallSpeed, airframe.cruiseLimitSpeed);
    return {true, now.heading, state.positionWorld.y + now.climb, speed, state.commands.throttle};
}

void turnKnobs(AutopilotMemory& memory, Airframe const& airframe, double lever, double climb, double turn) {
    double const slowest = kSlowest * airframe.stallSpeed, fastest = airframe.cruiseLimitSpeed;
    memory.speed = std::clamp(memory.speed + lever * (fastest - slowest), slowest, fastest);
    memory.raised += climb * kRaising * core::kTickSeconds;
    memory.turned += turn * kTurning * core::kTickSeconds;
}

double autopilotHeading(AutopilotSettings const& settings, AutopilotMemory const& memory) {
    bool const set = settings.course == AutopilotCourse::heading;
    return (set ? core::radians(settings.heading_deg) : memory.heading) + memory.turned;
}

bool takesOver(Controls const& stick) {
    return std::abs(stick.elevator) > kTakeOver || std::abs(stick.aileron) > kTakeOver ||
           std::abs(stick.rudder) > kTakeOver;
}

double autopilotAltitude(AutopilotSettings const& settings, AutopilotMemory const& memory) {
    return (settings.altitude_ft > 0.0 ? settings.altitude_ft * core::kMetresPerFoot : memory.altitude) + memory.raised;
}

Controls autopilotHands(AircraftState const& state, Airframe const& airframe, AutopilotSettings const& settings,
                        glm::dvec2 targetEastNorth, AutopilotMemory& memory) {
    Readings const& now = state.readings;
    double const bank = std::clamp(turnWanted(state, settings, targetEastNorth, memory), -kSteepestBank, kSteepestBank);
    double const climb = climbWanted(state, airframe, settings, memory);
    double const slow = memory.speed - now.cas;
    memory.power = std::clamp(memory.power + 0.004 * slow * core::kTickSeconds, 0.0, 1.0);
    Controls hands;
    hands.aileron = std::clamp(1.6 * (bank - now.roll), -1.0, 1.0);
    hands.elevator = std::clamp(3.0 * (climb - now.climb) / std::max(now.tas, 15.0), -0.5, 0.5);
    hands.throttle = std::clamp(memory.power + 0.05 * slow + 0.06 * climb, 0.0, 1.0);
    return hands;
}
}  // namespace luftpost::flight
