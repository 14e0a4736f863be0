// Light on the land: sun (or moon) through clouds and past other land, the sky's and the ground's own.
#ifndef LUFTPOST_TERRAIN_LIGHT_GLSL
#define LUFTPOST_TERRAIN_LIGHT_GLSL
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/terrain.glsl.h"

layout(binding = 1) uniform sampler2D landShadow;  // altitude below which the land lies in another land's shadow, softness

/// Share of the sun's disc that land leaves free at `altitude` above `flatOffset` (m east and north of the camera).
float landLight(vec2 flatOffset, float altitude) {
    vec2 at = (flatOffset - land.shadow.xy) * land.shadow.z;
    if (land.shadow.w < 0.5 || any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) return 1.0;
    vec2 shade = texture(landShadow, at).xy;
    float free = clamp(0.5 + (altitude - shade.x) / max(shade.y, 2.0), 0.0, 1.0);
    vec2 rim = min(at, 1.0 - at);
    return mix(1.0, free, clamp(min(rim.x, rim.y) * 12.0, 0.0, 1.0));
}

/// Radiance of a matt surface. `open`: share of the sky that it sees beside what its tilt hides.
vec3 mattLight(vec3 albedo, vec3 normal, float free, float open) {
    vec3 sun = frame.sunIrradiance.rgb * (max(dot(normal, frame.sunDirection.xyz), 0.0) * free);
    vec3 moon = frame.moonIrradiance.rgb * max(dot(normal, frame.moonDirection.xyz), 0.0);
    float up = 0.5 + 0.5 * normal.y;
    vec3 around = frame.skyIrradiance.rgb * (up * open) + frame.groundIrradiance.rgb * (1.0 - up);
    return albedo * (sun + moon + around) * (1.0 / 3.14159265);
}
#endif
