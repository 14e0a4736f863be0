// The shadow of the clouds on ground, aircraft and air. GLSL alone: reads the map that CloudShadow binds.
#ifndef LUFTPOST_CLOUD_SHADOW_GLSL
#define LUFTPOST_CLOUD_SHADOW_GLSL
#include "shaders/lib/cloud_light.glsl"
#include "shaders/shared/cloud.glsl.h"
#include "shaders/shared/frame.glsl.h"

layout(binding = 15) uniform sampler2D cloudShadowMap;  // optical depth toward the light, altitude of what takes it

/// Share of the key light (sun, or moon at night) that the clouds let through to a place: x east and z south of the
/// camera, flat, m; y above sea level. Beyond the map it is the mean over the land.
float cloudShadow(vec3 place) {
    if (clouds.march.x == 0 || clouds.light.z < 0.5) return 1.0;
    vec3 toward = frame.sunDirection.y > kSunGivesWay ? frame.sunDirection.xyz : frame.moonDirection.xyz;
    vec2 onPlane = place.xz - toward.xz * ((place.y - clouds.shadowPlace.w) / max(toward.y, 0.06));
    vec2 uv = (onPlane + clouds.shadowPlace.xy) * clouds.shadowPlace.z;
    vec2 border = abs(uv - 0.5) * 2.0;
    float outside = smoothstep(0.85, 0.98, max(border.x, border.y));
    vec2 shadow = textureLod(cloudShadowMap, uv, 0.0).rg;
    float through = mix(beamBehind(shadow.x), 1.0, clamp((place.y - shadow.y) / 600.0 + 0.5, 0.0, 1.0));
    return mix(through, frame.sunIrradiance.w, outside);
}
#endif
