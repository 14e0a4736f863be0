#version 450 core
#include "shaders/lib/camera.glsl"
#include "shaders/lib/terrain_mesh.glsl"
#include "shaders/lib/terrain_light.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/waves.glsl"

in vec3 world;
in vec2 place;
in vec4 clipNow;
in vec4 clipBefore;
layout(location = 0) out vec4 colour;   // premultiplied
layout(location = 1) out vec4 motion;

/// The sun or moon in the rough mirror of the waves.
vec3 glint(vec3 normal, vec3 eye, vec3 light, vec3 irradiance, float alpha) {
    float cosLight = dot(normal, light);
    if (cosLight <= 0.0) return vec3(0.0);
    vec3 halfway = normalize(eye + light);
    float facets = facetDensity(clamp(dot(normal, halfway), 0.0, 1.0), alpha) * facetVisibility(max(dot(normal, eye), 1e-3), cosLight, alpha);
    return irradiance * fresnel(vec3(0.02), clamp(dot(halfway, light), 0.0, 1.0)) * (facets * cosLight);
}

void main() {
    float bed = texture(chunkSamples, (place / chunkPlace.z * chunkPlace.w + 0.5) * chunkMorph.z).x;
    float depth = land.levels.x - bed;
    if (depth <= 0.0) discard;
    float distance = length(world);
    vec3 eye = -world / distance;
    float footprint = distance * frame.projection.w / sqrt(clamp(eye.y, 0.03, 1.0));
    vec2 wrapped = vec2(chunkOrigin.xy & (kWavePeriod - 1)) + place;
    // Shallows are calmer; the open lake takes the whole wind.
    vec2 wind = vec2(frame.wind.x, -frame.wind.z) * clamp(0.35 + depth * 0.12, 0.0, 1.0);
    WaveFace face = waveFace(wrapped - float(kWavePeriod) * floor(wrapped / float(kWavePeriod)), wind, frame.time.x, footprint);
    vec3 normal = normalize(vec3(-face.slope.x, 1.0, face.slope.y) + vec3(world.x, 0.0, world.z) / kCurvatureRadius);
    float alpha = sqrt(2.0 * face.unresolved + 1.0e-5);

    float cosEye = max(dot(normal, eye), 0.02);
    float mirror = fresnel(vec3(0.02), cosEye).x / (1.0 + 4.0 * alpha * (1.0 - cosEye));
    vec3 mirrored = reflect(-eye, normal);
    mirrored = normalize(vec3(mirrored.x, abs(mirrored.y) + 0.25 * alpha, mirrored.z));
    vec3 sky = mix(skyRadiance(mirrored), frame.skyIrradiance.rgb / kSurfacePi, 0.25);

    float share = sunShare(chunkPlace.xy + place, land.levels.x);
    vec3 sun = sunIrradianceAt(land.levels.x) * share;
    vec3 moon = moonIrradianceAt(land.levels.x) * frame.moonIrradiance.w;
    vec3 light = sun * max(frame.sunDirection.y, 0.0) + moon * max(frame.moonDirection.y, 0.0) + frame.skyIrradiance.rgb;
    float path = depth * (1.0 + 0.5 / max(eye.y, 0.25));
    vec3 through = exp(-vec3(0.55, 0.20, 0.24) * path);
    float clear = dot(through, vec3(0.3, 0.5, 0.2));
    vec3 body = mix(vec3(0.010, 0.034, 0.042), vec3(0.030, 0.075, 0.065), exp(-0.25 * depth)) * light / kSurfacePi;

    vec3 reflected = sky * mirror + glint(normal, eye, frame.sunDirection.xyz, sun, alpha) + glint(normal, eye, frame.moonDirection.xyz, moon, alpha);
    float cover = 1.0 - clear * (1.0 - mirror);
    float shore = clamp(depth / (0.05 + 0.5 * footprint * 0.1), 0.0, 1.0);
    colour = vec4((body * (1.0 - mirror) * (1.0 - clear) + reflected) * frame.exposure.x, cover) * shore;
    motion = vec4(motionOf(clipNow, clipBefore), 0.0, 1.0);
}
