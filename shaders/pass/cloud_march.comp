#version 450 core
// One ray through the clouds: what it gathers of light, what it lets through, and how far away that is.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/cloud_march.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 0, rgba16f) uniform writeonly image2D lightTarget;    // radiance * preExposure, transmittance
layout(binding = 1, rg32f) uniform writeonly image2D distanceTarget;   // m, of the cloud and of the land behind it

void main() {
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(place, imageSize(lightTarget)))) return;
    ivec2 pixel = marchedPixel(place);
    vec2 centre = vec2(min(pixel, ivec2(frame.viewport.xy) - 1)) + 0.5;
    if (!insidePicture(centre)) {
        imageStore(lightTarget, place, vec4(0.0, 0.0, 0.0, 1.0));
        imageStore(distanceTarget, place, vec4(1.0e6, 1.0e9, 0.0, 0.0));
        return;
    }
    float land = distanceOfDepth(texelFetch(depthTarget, ivec2(centre), 0).r, centre);
    // A picture of all rays has none before it to be averaged with: what differs from ray to ray would stay in it as dots.
    float random = clouds.march.w == 1 ? 0.5 : randomOf(pixel);
    MarchResult ray = marchClouds(rayDirection(centre), land, random);
    imageStore(lightTarget, place, vec4(min(ray.light * frame.exposure.x, vec3(60000.0)), ray.through));
    imageStore(distanceTarget, place, vec4(ray.distance, land, 0.0, 0.0));
}
