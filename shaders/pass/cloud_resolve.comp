#version 450 core
// The whole picture's clouds from a sixteenth of the rays: what the pixel saw before, found again through the cloud's own
// distance and drift, and kept where it fits what its neighbours see now.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/cloud_march.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 1) uniform sampler2D marchedLight;     // radiance * preExposure, transmittance; one of 4 x 4
layout(binding = 2) uniform sampler2D marchedDistance;  // m, of the cloud and of the land behind
layout(binding = 3) uniform sampler2D oldLight;
layout(binding = 4) uniform sampler2D oldFacts;         // 1 / distance, 1 / land (0: sky), age in frames, sureness
layout(binding = 0, rgba16f) uniform writeonly image2D newLight;
layout(binding = 1, rgba16f) uniform writeonly image2D newFacts;
uniform float historyValid;   // 0: there is none
uniform float exposureRatio;  // preExposure now / then

const float kSky = 1.0e8;

/// Two pixels see the same background when both see the sky or their lands are at about the same distance.
bool sameLand(float a, float b) {
    if (a > kSky || b > kSky) return a > kSky && b > kSky;
    return abs(a - b) < 0.12 * min(a, b) + 20.0;
}

struct Neighbours {
    vec4 light;      // mean
    vec4 low, high;  // bounds
    float distance;
    float weight;    // 0: none sees the same background
    float sureness;  // how near the nearest of them is: 1 on it, falling with the distance in pixels
};

/// The nine rays around the pixel that see the same background, weighted by nearness.
Neighbours neighboursOf(ivec2 pixel, float land) {
    ivec2 size = textureSize(marchedLight, 0);
    ivec2 block = pixel / 4;
    Neighbours n = Neighbours(vec4(0.0), vec4(1e9), vec4(-1e9), 0.0, 0.0, 0.0);
    float distances = 0.0;
    for (int k = 0; k < 9; ++k) {
        ivec2 place = clamp(block + ivec2(k % 3 - 1, k / 3 - 1), ivec2(0), size - 1);
        vec2 facts = texelFetch(marchedDistance, place, 0).rg;
        vec4 light = texelFetch(marchedLight, place, 0);
        bool before = light.a < 0.02 && facts.x < land;
        if (!before && !sameLand(land, facts.y)) continue;
        vec2 apart = vec2(marchedPixel(place) - pixel);
        float weight = exp(-dot(apart, apart) * 0.3);
        n.sureness = max(n.sureness, weight);
        n.light += weight * light;
        n.low = min(n.low, light);
        n.high = max(n.high, light);
        n.weight += weight;
        float solid = weight * (1.0 - light.a) + 1e-4 * weight;
        n.distance += solid * facts.x;
        distances += solid;
    }
    if (n.weight > 0.0) {
        n.light /= n.weight;
        n.distance /= distances;
    }
    return n;
}

/// The ray next to the pixel, whatever it saw: the last resort.
vec4 nearestRay(ivec2 pixel, out float distance) {
    ivec2 place = clamp(pixel / 4, ivec2(0), textureSize(marchedLight, 0) - 1);
    distance = texelFetch(marchedDistance, place, 0).r;
    return texelFetch(marchedLight, place, 0);
}

/// How far the clouds at altitude `y` have drifted since the frame before.
vec3 driftedAt(float y) {
    for (int layer = 0; layer < clouds.march.x; ++layer) {
        vec4 extent = clouds.shapes[layer].extent;
        if (extent.z < 0.5 || y > extent.y + 200.0) continue;
        vec2 wind = clouds.shapes[layer].wind.xy;
        return vec3(wind.x, 0.0, wind.y) * frame.time.y;
    }
    return vec3(0.0);
}

/// The old picture between its pixels by the Catmull-Rom spline (nine bilinear taps), which does not blur from frame to
/// frame as bilinear alone does; never beyond what the four pixels around hold.
vec4 oldBetween(vec2 uv) {
    vec2 size = frame.viewport.xy;
    vec2 place = uv * size;
    vec2 centre = floor(place - 0.5) + 0.5;
    vec2 f = place - centre;
    vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
    vec2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
    vec2 w3 = f * f * (-0.5 + 0.5 * f);
    vec2 w12 = w1 + w2;
    vec2 at[3] = vec2[3]((centre - 1.0) / size, (centre + w2 / w12) / size, (centre + 2.0) / size);
    vec2 weight[3] = vec2[3](w0, w12, w3);
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 9; ++k)
        sum += weight[k % 3].x * weight[k / 3].y * textureLod(oldLight, vec2(at[k % 3].x, at[k / 3].y), 0.0);
    vec4 low = vec4(1e9), high = vec4(-1e9);
    for (int k = 0; k < 4; ++k) {
        vec4 texel = texelFetch(oldLight, clamp(ivec2(centre) + ivec2(k & 1, k >> 1), ivec2(0), ivec2(size) - 1), 0);
        low = min(low, texel);
        high = max(high, texel);
    }
    return clamp(sum, low, high);
}

/// What the pixel's cloud looked like a frame ago and how many pixels it has moved since; gives its age (below 0
/// where nothing can be known) and its sureness.
vec2 oldAge(vec2 centre, float land, float distance, out vec4 light, out float moved) {
    light = vec4(0.0);
    moved = 1.0;
    if (historyValid < 0.5) return vec2(-1.0);
    vec3 here = rayDirection(centre) * distance;
    here -= driftedAt(here.y + frame.cameraWorld.y);
    vec4 clip = frame.previousClipFromWorld * vec4(here, 1.0);
    if (clip.w <= 0.0) return vec2(-1.0);
    vec2 uv = clip.xy / clip.w * 0.5 + 0.5;
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return vec2(-1.0);
    ivec2 texel = clamp(ivec2(uv * frame.viewport.xy), ivec2(0), ivec2(frame.viewport.xy) - 1);
    vec4 facts = texelFetch(oldFacts, texel, 0);
    float oldLand = facts.y > 0.0 ? 1.0 / facts.y : 1.0e9;
    if (!sameLand(land, oldLand)) return vec2(-1.0);
    moved = length(uv * frame.viewport.xy - centre);
    light = oldBetween(uv);
    light.rgb *= exposureRatio;
    return facts.zw;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(newLight)))) return;
    vec2 centre = vec2(pixel) + 0.5;
    float land = distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, centre);
    Neighbours around = neighboursOf(pixel, land);
    float distance = around.distance;
    vec4 light = around.light;
    if (around.weight <= 0.0) light = nearestRay(pixel, distance);
    vec4 old;
    float moved;
    vec2 known = oldAge(centre, land, distance, old, moved);
    float age = known.x;
    float sureness = around.sureness;
    bool fresh = marchedPixel(pixel / 4) == pixel;
    if (age >= 0.0) {
        // What has not moved was seen by its own ray and may differ from its neighbours; what has moved was put there by a
        // guess of its distance and must fit them.
        float still = 1.0 - clamp(2.0 * moved, 0.0, 1.0);
        vec4 slack = mix(0.15, 2.0, still) * (around.high - around.low) + mix(0.01, 0.2, still) * vec4(around.light.rgb, 1.0);
        vec4 kept = around.weight > 0.0 ? clamp(old, around.low - slack, around.high + slack) : old;
        bool clipped = any(greaterThan(abs(kept - old), 0.25 * slack + 1e-4));
        age = clipped ? 0.5 * age : age;
        known.y *= 1.0 - 0.03 * min(moved, 1.0);
        if (fresh) light = mix(kept, texelFetch(marchedLight, pixel / 4, 0), max(1.0 - 0.65 * known.y, 1.0 / (age / 16.0 + 1.0)));
        else light = mix(kept, light, sureness > known.y ? sureness / (sureness + known.y) : 0.0);
        sureness = max(sureness, known.y);
    } else if (fresh) {
        light = texelFetch(marchedLight, pixel / 4, 0);
    }
    imageStore(newLight, pixel, max(light, vec4(0.0)));
    imageStore(newFacts, pixel, vec4(1.0 / max(distance, 1.0), land > kSky ? 0.0 : 1.0 / land, min(age + 1.0, 200.0), fresh ? 1.0 : sureness));
}
