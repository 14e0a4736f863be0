#version 450 core
// What is asked for beyond the budget: guessed from the rays around until there is one.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/cloud_rays.glsl"
#include "shaders/lib/cloud_store.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 0, rgba16f) uniform image2D newLight;
layout(binding = 1, rgba16f) uniform image2D newFacts;

const int kReach = 3;  // pixels: in every block of four there is a ray

void main() {
    ivec2 pixel = askedPixel(rayList.fillGroups.w + gl_GlobalInvocationID.x, 0xffffffffu);
    if (pixel.x < 0) return;
    float land = distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, vec2(pixel) + 0.5);
    vec4 light = vec4(0.0);
    float nearness = 0.0, weights = 0.0;
    for (int y = -kReach; y <= kReach; ++y)
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 place = clamp(pixel + ivec2(x, y), ivec2(0), imageSize(newLight) - 1);
            CloudFacts facts = unpackedFacts(imageLoad(newFacts, place));
            vec4 there = imageLoad(newLight, place);
            vec2 apart = vec2(x, y) + facts.offset;
            // What is solid before both lands hides them alike.
            bool same = sameLand(land, facts.land) || (there.a < 0.02 && facts.distance < land);
            float weight = isGuess(facts) ? 0.0 : exp(-0.3 * dot(apart, apart)) * (same ? 1.0 : 1.0e-6);
            light += weight * there;
            nearness += weight / facts.distance;
            weights += weight;
        }
    if (weights <= 0.0) return;
    imageStore(newLight, pixel, light / weights);
    imageStore(newFacts, pixel, packedFacts(CloudFacts(weights / nearness, land, vec2(kGuess))));
}
