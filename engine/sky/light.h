// The light at one point of the air: what land, clouds and aircraft are lit by, and where the exposure starts from.
#pragma once
#include <glm/glm.hpp>

#include "engine/sky/atmosphere.h"
#include "engine/sky/sky_state.h"
#include "shaders/lib/exposure.glsl"

namespace luftpost::sky {
/// 1 of our irradiance in lux: the sun's illuminance above the air.
inline constexpr double kSunIlluminance_lx = static_cast<double>(glsl::kSunLux);

/// Irradiances, scene-linear Rec. 709, the sun's above the air being 1.
struct SkyLight {
    glm::vec3 sun{0.0f};          // on a plane facing the sun, after the air, no cloud in the way
    glm::vec3 moon{0.0f};         // the same of the moon
    glm::vec3 moonAboveAir{0.0f};  // the moon's above the air: by phase and distance
    glm::vec3 skyClear{0.0f};     // from above on a horizontal plane, of a cloudless sky
    glm::vec3 sky{0.0f};          // the same under the clouds above: greyer, and dimmer or brighter
    glm::vec3 ground{0.0f};       // from below on a horizontal plane: land and clouds below in sun and sky
    glm::vec3 groundRadiance{0.0f};  // of the land in the mean, 1/(sr), for the sky's lower half
    float exposure = 1.0f;        // from radiance to the tone curve, before the picture is measured; no jump from noon to night
};

/// Light at `altitude` (m above sea level). `conditions.cover` is what lies above that altitude; `tables` are of the air without clouds.
SkyLight skyLight(SkyState const& state, AtmosphereTables const& tables, double altitude,
                  AirConditions const& conditions);

/// Light on land in the shade of clouds and in the sun, over its mean under the clouds of the hour (which `ground` is of). In the shade it is the open
/// sky's between the clouds and what they let through; against path-traced land under cumulus and stratocumulus its mean is within a sixth.
glm::vec2 landContrast(SkyLight const& light, SkyState const& state, AirConditions const& conditions);

/// Albedo of the land in the mean, by colour.
glm::vec3 landAlbedo(AirConditions const& conditions);

/// The moon's irradiance above the air: Allen's phase law (Astrophysical Quantities), 0.267 lx when full at its mean
/// distance; a little redder than the sun.
glm::vec3 moonIrradiance(SkyState const& state);

/// Radiance of the airglow and of all stars together at the zenith above the air, 1/sr: 2e-4 cd/m2 (a natural sky
/// without moon has magnitude 21.9 to 22 per square arc second).
glm::vec3 airglowRadiance();

/// Mean luminance, 1/sr, that a camera under `light` meets, half land and half sky: exposure's analytic start.
float meanLuminance(SkyLight const& light, SkyState const& state, double cover);

/// What a scene of mean luminance `mean` is multiplied by so that its mid-tones come out where the eye expects them:
/// mid-grey by day, ever darker from dusk to night (shaders/lib/exposure.glsl).
float exposureFor(float mean);

float luminance(glm::vec3 const& rgb);
}  // namespace luftpost::sky
