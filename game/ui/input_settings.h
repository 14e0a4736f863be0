// How keys and gamepad become a stick. These settings change the flight: a change is an input stamped with a
// tick.
#pragma once
#include <tuple>

#include "engine/core/settings.h"

namespace luftpost::ui {
struct InputSettings {
    double keySeconds = 0.35;   // from centre to full deflection while a key is held
    double padDeadZone = 0.12;  // share of a gamepad stick's travel that counts as centre
    double padExponent = 1.6;   // 1: straight; more: finer about the centre
    bool invertPitch = false;   // pulling the gamepad's stick lowers the nose
};

inline constexpr std::tuple inputFields{
    core::Field{&InputSettings::keySeconds, "controls.keySeconds", 0.05, 2.0,
                "Seconds from centre to full stick while a key is held"},
    core::Field{&InputSettings::padDeadZone, "controls.padDeadZone", 0.0, 0.5,
                "Share of a gamepad stick's travel that counts as centre"},
    core::Field{&InputSettings::padExponent, "controls.padExponent", 1.0, 3.0,
                "How much finer a gamepad stick is about its centre (1: not at all)"},
    core::Field{&InputSettings::invertPitch, "controls.invertPitch",
                "Pulling the gamepad's stick lowers the nose"}};
}  // namespace luftpost::ui
