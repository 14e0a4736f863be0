// How passes ask the sky: radiance by direction, air light and transmittance before a point, light at an altitude.
// GLSL alone: it names the samplers that the sky's tables are bound to.
#ifndef LUFTPOST_SKY_TABLES_GLSL
#define LUFTPOST_SKY_TABLES_GLSL
#include "shaders/lib/atmosphere.glsl"
#include "shaders/shared/sky_block.glsl.h"

layout(binding = 20) uniform sampler2D skyTransmittanceTable;
layout(binding = 21) uniform sampler2D skyMultipleTable;
layout(binding = 22) uniform sampler2D skyViewTable;
layout(binding = 23) uniform sampler3D skyAerialTable;
layout(binding = 24) uniform sampler3D skyAerialThroughTable;

/// Radiance of the cloudless sky without the sun's and moon's discs and the stars; below the horizon that of hazy land.
/// `direction`: world, unit.
vec3 skyRadiance(vec3 direction) {
    vec2 size = vec2(textureSize(skyViewTable, 0));
    return textureLod(skyViewTable, skyCoordinate(size, sky.skyCamera.x, direction, sky.lights.sun.xyz), 0.0).rgb;
}

/// The air between the camera and a point at `distance` toward `direction` (world, unit): what lies there comes to the
/// eye as  radiance * transmittance + its air light.
AirLight airBefore(vec3 direction, float distance) {
    vec3 size = vec3(textureSize(skyAerialTable, 0));
    vec3 uvw = aerialCoordinate(size, sky.skyCamera.x, direction, sky.lights.sun.xyz, distance);
    AirLight light;
    light.radiance = textureLod(skyAerialTable, uvw, 0.0).rgb;
    light.transmittance = textureLod(skyAerialThroughTable, uvw, 0.0).rgb;
    return light;
}

/// Transmittance of the cloudless air from altitude `h` to the top along a zenith cosine; 0 through the Earth.
vec3 airToTop(float h, float mu) {
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    return lightThroughAir(skyTransmittanceTable, size, h, mu, 0.0005);
}

/// The sun's and the moon's irradiance at an altitude on planes that face them, no cloud in the way.
vec3 sunIrradianceAt(float h) {
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    return sky.lights.sunLight.rgb *
           lightThroughAir(skyTransmittanceTable, size, h, sky.lights.sun.y, sky.lights.sun.w);
}
vec3 moonIrradianceAt(float h) {
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    return sky.lights.moonLight.rgb *
           lightThroughAir(skyTransmittanceTable, size, h, sky.lights.moon.y, sky.lights.moon.w);
}
#endif
