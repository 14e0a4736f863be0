// How keys and gamepad become a stick. These settings change the flight: a change is an input stamped with a
// tick.
#pragma once
#include <tuple>

#include "engine/core/settings.h"

namespace luftpost::ui {
struct InputSettings {
    double keySeconds = 0.35;  // from centre to full deflection while a key is held
    // Of each axis of a gamepad or joystick: the share of its travel that counts as centre, and the exponent that makes it finer
    // about the centre (1: straight).
    double rollDeadZone = 0.12, rollCurve = 1.6;
    double pitchDeadZone = 0.12, pitchCurve = 1.6;
    double yawDeadZone = 0.12, yawCurve = 1.6;
    double thrustDeadZone = 0.12, thrustCurve = 1.6;
    double brakesDeadZone = 0.05, brakesCurve = 1.0;
};

inline constexpr std::tuple inputFields{
    core::Field{&InputSettings::keySeconds, "controls.keySeconds", 0.05, 2.0,
                "Seconds from centre to full stick while a key is held"},
    core::Field{&InputSettings::rollDeadZone, "controls.rollDeadZone", 0.0, 0.5,
                "Share of the roll axis' travel that counts as centre"},
    core::Field{&InputSettings::rollCurve, "controls.rollCurve", 1.0, 3.0,
                "How much finer the roll axis is about its centre (1: not at all)"},
    core::Field{&InputSettings::pitchDeadZone, "controls.pitchDeadZone", 0.0, 0.5,
                "Share of the pitch axis' travel that counts as centre"},
    core::Field{&InputSettings::pitchCurve, "controls.pitchCurve", 1.0, 3.0,
                "How much finer the pitch axis is about its centre (1: not at all)"},
    core::Field{&InputSettings::yawDeadZone, "controls.yawDeadZone", 0.0, 0.5,
                "Share of the yaw axis' travel that counts as centre"},
    core::Field{&InputSettings::yawCurve, "controls.yawCurve", 1.0, 3.0,
                "How much finer the yaw axis is about its centre (1: not at all)"},
    core::Field{&InputSettings::thrustDeadZone, "controls.thrustDeadZone", 0.0, 0.5,
                "Share of the travel of the axis that moves the throttle that counts as centre"},
    core::Field{&InputSettings::thrustCurve, "controls.thrustCurve", 1.0, 3.0,
                "How much finer the axis that moves the throttle is about its centre (1: not at all)"},
    core::Field{&InputSettings::brakesDeadZone, "controls.brakesDeadZone", 0.0, 0.5,
                "Share of the brake axis' travel that does not brake"},
    core::Field{&InputSettings::brakesCurve, "controls.brakesCurve", 1.0, 3.0,
                "How much finer the brake axis is at its beginning (1: not at all)"}};

/// How the mouse is used. These do not change the flight: they decide what a sample holds.
struct MouseSettings {
    bool flight = false;
    float travel = 0.25f;
    bool invertPitch = false;
};

inline constexpr std::tuple mouseFields{
    core::Field{&MouseSettings::flight, "controls.mouseFlight", "The mouse moves the stick"},
    core::Field{&MouseSettings::travel, "controls.mouseTravel", 0.05f, 1.0f,
                "Way of the mouse from centre to full stick, share of the window's height"},
    core::Field{&MouseSettings::invertPitch, "controls.mouseInvertPitch", "Pulling the mouse toward you lowers the nose"}};
}  // namespace luftpost::ui
