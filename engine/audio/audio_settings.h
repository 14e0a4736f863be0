// How loud the player wants what.
#pragma once
#include <tuple>

#include "engine/core/settings.h"

namespace luftpost::audio {
struct AudioSettings {
    double master = 0.8;
    double engine = 1.0;
    double surroundings = 1.0;
    double effects = 1.0;
    double climb = 0.0;
};

inline constexpr std::tuple audioFields{
    core::Field{&AudioSettings::master, "sound.master", 0.0, 1.0, "How loud everything is"},
    core::Field{&AudioSettings::engine, "sound.engine", 0.0, 1.0, "How loud engine and propeller are"},
    core::Field{&AudioSettings::surroundings, "sound.surroundings", 0.0, 1.0, "How loud wind, rain and thunder are"},
    core::Field{&AudioSettings::effects, "sound.effects", 0.0, 1.0, "How loud chute, wheels, delivery and clicks are"},
    core::Field{&AudioSettings::climb, "sound.climb", 0.0, 1.0, "How loud the tone is that tells climb and sink"}};
}  // namespace luftpost::audio
