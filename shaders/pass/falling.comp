#version 450 core
// Shafts of rain and snow along one ray of every `block` x `block` pixels: they have no fine edges but those of what stands before them.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/cloud_store.glsl"
#include "shaders/lib/groups.glsl"
#include "shaders/lib/weather_light.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 1) uniform sampler2D cloudFacts;
layout(binding = 2) uniform sampler2D colour;                          // a: transmittance of the clouds
layout(binding = 0, rgba16f) uniform writeonly image2D lightTarget;    // radiance * preExposure, transmittance
layout(binding = 1, rgba16f) uniform writeonly image2D litTarget;      // of Fallen, log2 of the distance
uniform int block;
uniform int samples;

void main() {
    ivec2 place = strewnPixel();
    if (any(greaterThanEqual(place, imageSize(lightTarget)))) return;
    ivec2 pixel = min(place * block + block / 2, ivec2(frame.viewport.xy) - 1);
    vec2 centre = vec2(pixel) + 0.5;
    LightRay ray = LightRay(rayDirection(centre), distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, centre),
                            unpackedFacts(texelFetch(cloudFacts, pixel, 0)).distance, texelFetch(colour, pixel, 0).a, picturePixel(vec2(place)));
    Fallen fallen = alongFalling(ray, keyLight(), samples);
    imageStore(lightTarget, place, vec4(min(fallen.light * frame.exposure.x, vec3(60000.0)), fallen.through));
    imageStore(litTarget, place, vec4(min(fallen.lit, vec3(60000.0)), log2(max(fallen.distance, 1.0))));
}
