// How passes ask the sky: radiance by direction, air light and transmittance before a point, light at an altitude.
// GLSL alone: it names the samplers that the sky's tables are bound to.
#ifndef LUFTPOST_SKY_TABLES_GLSL
#define LUFTPOST_SKY_TABLES_GLSL
#include "shaders/lib/atmosphere.glsl"
#include "shaders/lib/cloud_light.glsl"
#include "shaders/shared/sky_block.glsl.h"

layout(binding = 20) uniform sampler2D skyTransmittanceTable;
layout(binding = 21) uniform sampler2D skyMultipleTable;
layout(binding = 22) uniform sampler2D skyViewTable;
layout(binding = 23) uniform sampler3D skyAerialTable;
layout(binding = 24) uniform sampler3D skyAerialThroughTable;
layout(binding = 25) uniform sampler3D skyShadeTable;  // made by AirShade
layout(binding = 19) uniform sampler2D skyAroundTable;

/// What a cloud at an altitude has around it, no other in the way: mean radiances of the half of the sphere above it and of the one below,
/// as a level plane weighs them.
struct Around {
    vec3 above;
    vec3 below;
};
Around aroundAt(float h) {
    float x = aroundCoordinate(h, float(textureSize(skyAroundTable, 0).x));
    return Around(textureLod(skyAroundTable, vec2(x, 0.25), 0.0).rgb, textureLod(skyAroundTable, vec2(x, 0.75), 0.0).rgb);
}

/// The light that clouds are lit by: the sun, or the moon once the sun gives less.
struct KeyLight {
    vec3 toward;      // world, unit
    vec3 above;       // irradiance above the air
    float radius;
};
KeyLight keyLight() {
    bool sunlit = sky.lights.sun.y > kSunGivesWay;
    return sunlit ? KeyLight(sky.lights.sun.xyz, sky.lights.sunLight.rgb, sky.lights.sun.w)
                  : KeyLight(sky.lights.moon.xyz, sky.lights.moonLight.rgb, sky.lights.moon.w);
}

vec2 shadeDirection(vec3 direction) {
    vec2 size = vec2(textureSize(skyShadeTable, 0).xy);
    return aerialCoordinate(vec3(size, 2.0), sky.skyCamera.x, direction, sky.lights.sun.xyz, 0.0).xy;
}

/// Radiance of the sky between the clouds, in their shade, without the sun's and moon's discs and the stars; below the horizon
/// that of hazy land. `direction`: world, unit.
vec3 skyRadiance(vec3 direction) {
    vec2 size = vec2(textureSize(skyViewTable, 0));
    vec3 open = textureLod(skyViewTable, skyCoordinate(size, sky.skyCamera.x, direction, sky.lights.sun.xyz), 0.0).rgb;
    float slices = float(textureSize(skyShadeTable, 0).z);
    return open * (1.0 - textureLod(skyShadeTable, vec3(shadeDirection(direction), shadeOfSky(slices)), 0.0).rgb);
}

vec3 openAirBefore(vec3 direction, float distance) {
    vec3 size = vec3(textureSize(skyAerialTable, 0));
    return textureLod(skyAerialTable, aerialCoordinate(size, sky.skyCamera.x, direction, sky.lights.sun.xyz, distance), 0.0).rgb;
}

/// The air between the camera and a point at `distance` toward `direction` (world, unit), in the shade of the clouds: what lies
/// there comes to the eye as  radiance * transmittance + its air light.
AirLight airBefore(vec3 direction, float distance) {
    vec3 size = vec3(textureSize(skyAerialThroughTable, 0));
    vec3 uvw = aerialCoordinate(size, sky.skyCamera.x, direction, sky.lights.sun.xyz, distance);
    AirLight light;
    light.transmittance = textureLod(skyAerialThroughTable, uvw, 0.0).rgb;
    light.radiance = openAirBefore(direction, distance);
    float slices = float(textureSize(skyShadeTable, 0).z);
    vec3 dimmed = textureLod(skyShadeTable, vec3(shadeDirection(direction), shadeCoordinate(slices, distance)), 0.0).rgb;
    light.radiance -= dimmed * (distance > kShadeReach ? openAirBefore(direction, kShadeReach) : light.radiance);
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
