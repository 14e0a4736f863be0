// The block that all shaders of the sky read: the air, the lights, and where the camera stands in the air.
#ifndef LUFTPOST_SKY_BLOCK_GLSL_H
#define LUFTPOST_SKY_BLOCK_GLSL_H
#include "shaders/shared/atmosphere.glsl.h"
GLSL_BEGIN

GLSL_CONST int kSkyBlockBinding = 4;
// Texture units of the sky's tables: transmittance, multiple scattering, sky view, aerial radiance and transmittance.
GLSL_CONST int kSkyTransmittanceUnit = 20;
GLSL_CONST int kSkyMultipleUnit = 21;
GLSL_CONST int kSkyViewUnit = 22;
GLSL_CONST int kSkyAerialUnit = 23;
GLSL_CONST int kSkyAerialThroughUnit = 24;

#ifdef __cplusplus
struct SkyBlock {
#else
layout(std140, binding = 4) uniform SkyBlock {
#endif
    Atmosphere air;
    SkyLights lights;
    vec4 skyCamera;           // x: altitude in m for the tables; y: that of their making; z: sun's, w: moon's part in them
    vec4 airglow;             // rgb: radiance at the zenith above the air
    mat4 celestialFromWorld;  // rotation to J2000
#ifdef __cplusplus
};
#else
} sky;
#endif

GLSL_END
#endif
