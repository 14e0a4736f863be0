// Light on the land: sun (or moon) through clouds and past other land, the sky's and the ground's own.
#ifndef LUFTPOST_TERRAIN_LIGHT_GLSL
#define LUFTPOST_TERRAIN_LIGHT_GLSL
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/terrain.glsl.h"
#include "shaders/lib/cloud_shadow.glsl"
#include "shaders/lib/model_shadow.glsl"
#include "shaders/lib/sky_tables.glsl"

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

/// Share of the sun's light that comes past land, clouds and models to `offset` (m east and north of the camera, flat).
float sunShare(vec2 offset, float altitude) {
    vec3 relative = vec3(offset.x, altitude - land.levels.w, -offset.y);
    return landLight(offset, altitude) * modelShadow(relative) * cloudShadow(vec3(relative.x, altitude, relative.z));
}

/// Radiance of a matt surface at `altitude`. `share`: of sunShare; `open`: what its own hollows leave of the sky.
vec3 mattLight(vec3 albedo, vec3 normal, float altitude, float share, float open) {
    vec3 sun = sunIrradianceAt(altitude) * (max(dot(normal, frame.sunDirection.xyz), 0.0) * share);
    vec3 moon = moonIrradianceAt(altitude) * (max(dot(normal, frame.moonDirection.xyz), 0.0) * frame.moonIrradiance.w);
    float up = 0.5 + 0.5 * normal.y;
    vec3 around = mix(frame.groundIrradiance.rgb, frame.skyIrradiance.rgb, up) * open;
    return albedo * (sun + moon + around) * (1.0 / 3.14159265);
}
#endif
