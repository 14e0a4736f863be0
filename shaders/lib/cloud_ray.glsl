// One pixel's ray through the clouds and what is kept of it. GLSL alone; for passes that have the depth target at unit 0 and
// the store's images at 0 and 1.
#ifndef LUFTPOST_CLOUD_RAY_GLSL
#define LUFTPOST_CLOUD_RAY_GLSL
#include "shaders/lib/cloud_march.glsl"
#include "shaders/lib/cloud_store.glsl"

layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 0, rgba16f) uniform writeonly image2D newLight;  // radiance * preExposure, transmittance
layout(binding = 1, rgba16f) uniform writeonly image2D newFacts;  // packedFacts

void keepRay(ivec2 pixel, vec4 light, CloudFacts facts) {
    imageStore(newLight, pixel, light);
    imageStore(newFacts, pixel, packedFacts(facts));
}

void marchPixel(ivec2 pixel) {
    vec2 centre = vec2(pixel) + 0.5;
    if (!insidePicture(centre)) {
        keepRay(pixel, vec4(0.0, 0.0, 0.0, 1.0), CloudFacts(1.0e6, kNoLand, vec2(0.0)));
        return;
    }
    float land = distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, centre);
    MarchResult ray = marchClouds(rayDirection(centre), land);
    keepRay(pixel, vec4(min(ray.light * frame.exposure.x, vec3(60000.0)), ray.through), CloudFacts(ray.distance, land, vec2(0.0)));
}
#endif
