// The layer between the stick and the control surfaces. The aerodynamics are the same at every level; what
// changes is who moves the surfaces.
//   sim     the stick is the surfaces (plus the trim the flight started with)
//   light   the stick is the surfaces; the rudder keeps the ball centred and damps yaw
//   normal  the stick asks for bank and pitch rate; attitude is held with the stick free; stall and overbank
//   are guarded easy    points where one steers, holds height and speed, cannot stall above 15 m
#pragma once
#include <array>
#include <string_view>

namespace luftpost::flight {
enum class AssistLevel { sim, light, normal, easy };
inline constexpr std::array<std::string_view, 4> kAssistWords{"sim", "light", "normal", "easy"};

/// The pilot's stick: elevator + nose up, aileron + roll right, rudder + nose right, each -1..1; throttle,
/// flaps, brakes 0..1; trim, + nose up and nose right, -1..1. Values outside are clamped, values that are not numbers count as 0.
struct Controls {
    double throttle = 0.0, elevator = 0.0, aileron = 0.0, rudder = 0.0, flaps = 0.0, brakes = 0.0;
    double elevatorTrim = 0.0, rudderTrim = 0.0;  // the wheels beside the seat; they act in sim and light
};

/// What the assist carries from tick to tick. Plain data, part of the aircraft's state.
struct AssistMemory {
    double climbAngle = 0.0;     // rad, the flight path that is held
    double heldAltitude = 0.0;   // m
    double holdsAltitude = 0.0;  // 1 while heldAltitude is flown instead of climbAngle
    double heldBank = 0.0;       // rad, held with the stick free and stabilizingRoll 0
    double pitchIntegral = 0.0;  // of the commands, in shares of the travel
    double rollIntegral = 0.0;
    double yawIntegral = 0.0;
    double throttleIntegral = 0.0;
    double excess = 0.0;            // thrust less drag over weight, smoothed: the climb angle that keeps the speed
    double startSpeed = 0.0;  // m/s calibrated, what easy holds with the lever where the start put it
};
}  // namespace luftpost::flight
