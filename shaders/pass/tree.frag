#version 450 core
#include "shaders/lib/camera.glsl"
#include "shaders/lib/terrain_cover.glsl"
#include "shaders/lib/terrain_light.glsl"
#include "shaders/lib/terrain_noise.glsl"

in vec3 world;
in vec2 across;
in vec4 clipNow;
in vec4 clipBefore;
flat in vec3 middle;
flat in vec3 right;
flat in vec3 above;
flat in vec4 about;
flat in vec2 offset;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    float conifer = about.x;
    // The crown stands on a short trunk, which shows from the side.
    float lift = 0.16 * (1.0 - conifer) * about.w;
    float y = (across.y - lift) / (1.0 - lift);
    // Seen from the side a conifer narrows to its top.
    float taper = mix(1.0, clamp(0.62 - 0.60 * y, 0.03, 1.2), conifer * about.w);
    vec2 disc = vec2(across.x / taper, y);
    float r2 = dot(disc, disc);
    ivec2 seed = ivec2(about.y * 1.0e4, about.z);
    float leaves = landNoise(seed, (across + 1.0) * 3.0, 0, 5u);
    float finer = landNoise(seed, (across + 1.0) * 7.0, 0, 6u);
    float near = clamp(1.5 - length(world) / 160.0, 0.0, 1.0);
    if (near > 0.0) finer += near * (0.8 * landNoise(seed, (across + 1.0) * 16.0, 0, 7u) + 0.6 * landNoise(seed, (across + 1.0) * 37.0, 0, 8u));
    bool crown = r2 <= 0.92 + 0.30 * leaves + 0.15 * finer;
    if (!crown && !(abs(across.x) < 0.09 && across.y < 0.0 && about.w > 0.5)) discard;
    float depth = sqrt(max(1.0 - r2, 0.0));
    vec3 outward = normalize(normalize(right) * disc.x + normalize(above) * disc.y - normalize(middle) * depth);
    vec3 normal = normalize(outward + vec3(0.0, 0.35, 0.0) + 0.35 * vec3(leaves, finer, leaves - finer));
    vec3 albedo = mix(mix(vec3(0.092, 0.138, 0.044), vec3(0.130, 0.155, 0.056), about.y), mix(vec3(0.055, 0.100, 0.045), vec3(0.075, 0.120, 0.055), about.y), conifer);
    albedo *= (0.85 + 0.35 * leaves + 0.25 * finer) * (1.0 - 0.25 * frame.weather.w);
    if (!crown) albedo = vec3(0.09, 0.07, 0.05);
    // Snow lies on what faces up; needles hold more of it than twigs.
    float fallen = landRamp(land.levels.y - 60.0, land.levels.y + 160.0, about.z);
    albedo = mix(albedo, kSnowAlbedo, fallen * landRamp(0.05, 0.75, normal.y + 0.45 * leaves + 0.2 * finer) * mix(0.55, 0.9, conifer));
    float hollow = mix(1.0, clamp(0.72 + 0.4 * across.y, 0.4, 1.0), about.w);  // little light comes down to the lower leaves
    float share = sunShare(offset, about.z) * hollow;
    colour = vec4(mattLight(albedo, normal, about.z, share, hollow) * frame.exposure.x, 1.0);
    motion = motionOf(clipNow, clipBefore);
}
