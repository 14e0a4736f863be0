// The seven parameters of the layer between the stick and the control surfaces, as the config menu shows
// them.
#pragma once
#include <tuple>

#include "engine/core/settings.h"

namespace luftpost::flight {
/// They act in `normal` and `easy`; maxThrottle acts at every level. Angles in degrees: they are what a
/// player reads.
struct AssistSettings {
    double rollFactor = 1.0;        // share of the roll command
    double rollSpeed_dps = 60.0;    // roll rate of the full stick
    double pitchSpeed_dps = 25.0;   // pitch rate of the full stick
    double yawSpeed_dps = 15.0;     // yaw rate of the full pedal
    double stabilizingRoll = 0.5;   // 1/s, rate to wings level with the stick free
    double inducedYawFactor = 1.0;  // share of the coordinated turn g tan(bank) / V flown unasked
    double maxThrottle = 1.0;       // share of full power at the full lever
};

inline constexpr std::tuple assistFields{
    core::Field{&AssistSettings::rollFactor, "aircraft.rollFactor", 0.0, 2.0,
                "Share of the roll command that is flown (assist normal and easy)"},
    core::Field{&AssistSettings::rollSpeed_dps, "aircraft.rollSpeed", 20.0, 120.0,
                "Roll rate of the full stick in degrees a second (assist normal and easy)"},
    core::Field{&AssistSettings::pitchSpeed_dps, "aircraft.pitchSpeed", 5.0, 60.0,
                "Pitch rate of the full stick in degrees a second (assist normal and easy)"},
    core::Field{&AssistSettings::yawSpeed_dps, "aircraft.yawSpeed", 5.0, 45.0,
                "Yaw rate of the full pedal in degrees a second (assist normal and easy)"},
    core::Field{&AssistSettings::stabilizingRoll, "aircraft.stabilizingRoll", 0.0, 3.0,
                "How fast the wings come level with the stick free, per second (assist normal and easy)"},
    core::Field{&AssistSettings::inducedYawFactor, "aircraft.inducedYawFactor", 0.0, 2.0,
                "Share of the coordinated turn of the bank that is flown unasked (assist normal and easy)"},
    core::Field{&AssistSettings::maxThrottle, "aircraft.maxThrottle", 0.2, 2.0,
                "Share of full power that the full lever gives (every assist)"}};
}  // namespace luftpost::flight
