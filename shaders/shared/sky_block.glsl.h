// The block that all shaders of the sky read: the air, the lights, and where the camera stands in the air.
#ifndef LUFTPOST_SKY_BLOCK_GLSL_H
#define LUFTPOST_SKY_BLOCK_GLSL_H
#include "shaders/shared/atmosphere.glsl.h"
#include "shaders/shared/block.glsl.h"
GLSL_BEGIN

GLSL_CONST int kSkyBlockBinding = 9;
// Texture units of the sky's tables: transmittance, multiple scattering, sky view, aerial radiance and transmittance, shade, what is
// around a cloud.
GLSL_CONST int kSkyTransmittanceUnit = 20;
GLSL_CONST int kSkyMultipleUnit = 21;
GLSL_CONST int kSkyViewUnit = 22;
GLSL_CONST int kSkyAerialUnit = 23;
GLSL_CONST int kSkyAerialThroughUnit = 24;
GLSL_CONST int kSkyShadeUnit = 25;
GLSL_CONST int kSkyAroundUnit = 19;

UNIFORM_BLOCK(SkyBlock, 9) {
    Atmosphere air;
    SkyLights lights;
    vec4 skyCamera;           // x: altitude in m when the tables were made; y: 1: the moon is in them; z: 1: stars show
    vec4 airglow;             // rgb: radiance at the zenith above the air
    vec4 land;                // x: light on land in the shade of clouds, over its mean under those of the hour; y: the same of sunlit land
    mat4 celestialFromWorld;  // rotation to J2000
} BLOCK_NAME(sky);

GLSL_END
#endif
