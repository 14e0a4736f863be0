// The clouds' page of the config menu. At the defaults the weather is what the field says.
#pragma once
#include <tuple>

#include "engine/core/settings.h"

namespace luftpost::weather {
struct CloudSettings {
    float densityThreshold = 0.0f;  // added to the rank that cloud must stay below: + less cloud, - more
    float scale = 1.0f;             // size of the billows
    float weatherScale = 1.0f;      // size of the clouds and of the gaps between them
    float higherScale = 1.0f;       // size of the fibres of the high layers
    float hg = 0.85f;               // asymmetry of the first scattering
    float sigma = 1.0f;             // extinction, times that of the water
    float height = 0.0f;            // m, added to every base and top
    float powder = 0.0f;            // darkening of thin edges, 0 = none: the light needs no help
    float rays = 0.0625f;           // share of the picture's rays marched each frame, at least; 1: all, and no history
    bool shadows = true;            // clouds darken ground, aircraft and air
    int noise = 1;                  // seed of the noise volumes; another one remakes them
};

inline constexpr std::tuple cloudFields{
    core::Field{&CloudSettings::densityThreshold, "clouds.densityThreshold", -0.5f, 0.5f,
                "How far the pattern must rise before there is cloud: + less, - more than the weather says"},
    core::Field{&CloudSettings::scale, "clouds.scale", 0.25f, 4.0f, "Size of the billows on a cloud"},
    core::Field{&CloudSettings::weatherScale, "clouds.weatherScale", 0.25f, 4.0f,
                "Size of clouds and of the gaps between them"},
    core::Field{&CloudSettings::higherScale, "clouds.higherScale", 0.25f, 4.0f, "Size of the fibres of high clouds"},
    core::Field{&CloudSettings::hg, "clouds.hg", 0.0f, 0.95f,
                "Asymmetry of scattering (Henyey-Greenstein): 0 even, 0.95 nearly straight on"},
    core::Field{&CloudSettings::sigma, "clouds.sigma", 0.05f, 4.0f, "Extinction, times what the cloud's water gives"},
    core::Field{&CloudSettings::height, "clouds.height", -1000.0f, 3000.0f, "Metres added to every cloud's base and top"},
    core::Field{&CloudSettings::powder, "clouds.powder", 0.0f, 1.0f, "Darkening of thin edges, for the look of old games"},
    core::Field{&CloudSettings::rays, "clouds.rays", 0.0625f, 1.0f,
                "Share of the picture's cloud rays marched each frame, at least: 0.0625, 0.25 or 1; more of them where frames take long"},
    core::Field{&CloudSettings::shadows, "clouds.shadows", "Clouds darken the ground and the air"},
    core::Field{&CloudSettings::noise, "clouds.noise", 1, 1000, "Seed of the billows; another one remakes them"}};
}  // namespace luftpost::weather
