#version 450 core
// The pixels that are not marched in this frame: the ray that saw a pixel's cloud before is found again through the cloud's
// own distance and drift. Pixels that no ray is found for ask for one.
#include "shaders/lib/cloud_rays.glsl"
#include "shaders/lib/cloud_store.glsl"
#include "shaders/lib/groups.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 1) uniform sampler2D oldLight;
layout(binding = 2) uniform sampler2D oldFacts;
layout(binding = 3) uniform sampler2D marchedFacts;  // the new facts: of the rays of this frame, for their distance
layout(binding = 0, rgba16f) uniform writeonly image2D newLight;
layout(binding = 1, rgba16f) uniform writeonly image2D newFacts;
uniform float historyValid;    // 0: there is none
uniform float exposureRatio;   // preExposure now / then

const float kNear = 0.25;  // pixels: a ray that went through nearer to the centre is as good as any
const float kFar = 0.8;  // pixels: one that went through farther from the centre does not stand for the pixel

/// How far the clouds at altitude `y` have drifted since the frame before.
vec3 driftedAt(float y) {
    vec2 wind = vec2(0.0);
    for (int layer = clouds.march.x - 1; layer >= 0; --layer)
        if (clouds.shapes[layer].extent.z > 0.5 && y < clouds.shapes[layer].extent.y + 200.0) wind = clouds.shapes[layer].wind.xy;
    return vec3(wind.x, 0.0, wind.y) * clouds.step.w;
}

/// Where the pixel's centre would have been in the old picture, in pixels of its own size, at a distance along its ray: clip = along * m + from.
struct Before {
    vec4 along;
    vec4 from;
};

vec2 pixelBefore(Before before, float distance) {
    vec4 clip = before.along * distance + before.from;
    return clip.w > 0.0 ? (clip.xy / clip.w * 0.5 + 0.5) * vec2(textureSize(oldFacts, 0)) : vec2(-1.0e4);
}

/// The old ray nearest to where the pixel was, each taken by its own distance; its texel, x below 0 when there is none. The texel
/// into which it fell comes first: at rest it is the pixel's own, and the others need not be asked.
ivec2 nearestRay(Before before, vec2 around, float land, out CloudFacts found) {
    ivec2 size = textureSize(oldFacts, 0);
    vec2 larger = frame.viewport.xy / vec2(size);
    ivec2 corner = ivec2(floor(around - 0.5));
    ivec2 first = ivec2(floor(around)) - corner;
    ivec2 best = ivec2(-1);
    float nearest = 1.0e9;
    int k = 0;
    do {
        ivec2 texel = corner + (ivec2(k & 1, k >> 1) ^ first);
        bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
        CloudFacts facts = unpackedFacts(texelFetch(oldFacts, clamp(texel, ivec2(0), size - 1), 0));
        vec2 offset = isGuess(facts) ? vec2(kGuess) : (vec2(texel) + 0.5 + facts.offset - pixelBefore(before, facts.distance)) * larger;
        float apart = dot(offset, offset);
        if (inside && apart < nearest && sameLand(land, facts.land)) {
            nearest = apart;
            best = texel;
            found = CloudFacts(facts.distance, land, offset);
        }
        ++k;
    } while (k < 4 && nearest > kNear * kNear);
    return best;
}

void main() {
    ivec2 pixel = strewnPixel();
    ivec2 size = ivec2(frame.viewport.xy);
    if (any(greaterThanEqual(pixel, size))) return;
    ivec2 block = pixel / clouds.march.w;
    ivec2 marched = min(marchedPixel(block), size - 1);
    if (marched == pixel) return;
    vec2 centre = vec2(pixel) + 0.5;
    float land = distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, centre);
    vec3 direction = rayDirection(centre);
    float guess = unpackedFacts(texelFetch(marchedFacts, marched, 0)).distance;
    Before before;
    before.along = frame.previousClipFromWorld * vec4(direction, 0.0);
    before.from = frame.previousClipFromWorld * vec4(-driftedAt(direction.y * guess + frame.cameraWorld.y), 1.0);
    CloudFacts found;
    ivec2 texel = historyValid > 0.5 ? nearestRay(before, pixelBefore(before, guess), land, found) : ivec2(-1);
    // Software GL takes both ways of a branch: one pair of stores, whatever was found.
    bool known = texel.x >= 0;
    if (!known) found = CloudFacts(guess, land, vec2(kGuess));
    vec4 light = texelFetch(oldLight, max(texel, ivec2(0)), 0);
    imageStore(newLight, pixel, known ? vec4(light.rgb * exposureRatio, light.a) : vec4(0.0, 0.0, 0.0, 1.0));
    imageStore(newFacts, pixel, packedFacts(found));
    if (dot(found.offset, found.offset) > kFar * kFar) askRay(pixel);
}
