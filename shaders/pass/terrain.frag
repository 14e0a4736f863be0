#version 450 core
#include "shaders/lib/camera.glsl"
#include "shaders/lib/terrain_mesh.glsl"
#include "shaders/lib/terrain_light.glsl"
#include "shaders/lib/terrain_colour.glsl"
#include "shaders/lib/runway.glsl"
#include "shaders/lib/scene_light.glsl"

in vec3 world;
in vec2 place;
in vec4 clipNow;
in vec4 clipBefore;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

/// Tilts the normal by fine relief that the mesh does not have.
vec3 roughened(vec3 normal, LandColour face, float footprint) {
    if (footprint > 60.0) return normal;
    vec2 broad = vec2(detailNoise(chunkOrigin.xy, place, 6, 45u, footprint), detailNoise(chunkOrigin.xy, place, 6, 46u, footprint)) +
                 0.7 * vec2(detailNoise(chunkOrigin.xy, place, 5, 47u, footprint), detailNoise(chunkOrigin.xy, place, 5, 48u, footprint));
    normal = normalize(normal + 0.55 * face.bump * vec3(broad.x, 0.0, broad.y));
    if (footprint > 8.0) return normal;
    vec2 tilt = vec2(detailNoise(chunkOrigin.xy, place, 2, 41u, footprint), detailNoise(chunkOrigin.xy, place, 2, 42u, footprint)) +
                0.6 * vec2(detailNoise(chunkOrigin.xy, place, 4, 43u, footprint), detailNoise(chunkOrigin.xy, place, 4, 44u, footprint));
    return normalize(normal + face.bump * vec3(tilt.x, 0.0, tilt.y));
}

/// What a film of water on rough ground mirrors of the sky.
vec3 wetSheen(vec3 normal, vec3 eye, float share) {
    const float roughness = 0.45;
    vec2 even = evenReflectance(clamp(dot(normal, eye), 0.0, 1.0), roughness);
    return share * (0.02 * even.x + even.y) * surroundingRadiance(reflect(-eye, normal), roughness);
}

void main() {
    vec4 ground = texture(chunkSamples, (place / chunkPlace.z * chunkPlace.w + 0.5) * chunkMorph.z);
    vec3 normal = normalize(ground.yzw);
    vec2 offset = chunkPlace.xy + place;
    float distance = length(world);
    float slant = clamp(-dot(world, normal) / distance, 0.06, 1.0);
    float footprint = distance * frame.projection.w / sqrt(slant);

    LandPoint p;
    p.origin = chunkOrigin.xy;
    p.offset = place;
    p.altitude = ground.x;
    p.aboveWater = ground.x - land.levels.x;
    p.flatness = normal.y;
    p.sunward = normal.z;
    p.snowLine = land.levels.y;
    vec2 home = offset - land.home.xy;
    p.clearing = land.home.w > 0.5 ? airfieldDistance(home) : 1.0e4;
    LandCover cover = landCover(p, footprint);
    LandColour face = landColour(p, cover, footprint);
    if (p.clearing < 200.0) face = runwayColour(home, face, footprint);

    float wet = frame.weather.w * (1.0 - cover.snow);
    vec3 albedo = face.albedo * (1.0 - 0.4 * wet);
    vec3 tilted = roughened(normal, face, footprint);
    tilted = normalize(tilted + vec3(world.x, 0.0, world.z) / kCurvatureRadius);
    float open = 1.0 - 0.35 * face.canopy;
    vec3 light = mattLight(albedo, tilted, ground.x, sunShare(offset, ground.x), open);
    if (wet > 0.0) light += wetSheen(tilted, -world / distance, wet * face.gloss);
    colour = vec4(light * frame.exposure.x, 1.0);
    motion = motionOf(clipNow, clipBefore);
}
