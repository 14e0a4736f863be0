// A ray through the shells of the clouds. GLSL alone.
//
// The ray is straight in the bent picture; every sample is taken back to the flat world by flatFromCurved. Between the
// layers it jumps to the next shell; in a shell it goes in cheap steps, that ask for outlines alone, until there may be
// a cloud, back to where that outline begins, then in full ones, whose length is bounded by optical depth and by distance,
// never by the length of the shell; after nine empty ones, two thirds as long, it is cheap again.
#ifndef LUFTPOST_CLOUD_MARCH_GLSL
#define LUFTPOST_CLOUD_MARCH_GLSL
#include "shaders/lib/camera.glsl"
#include "shaders/lib/cloud_light.glsl"
#include "shaders/lib/cloud_scene.glsl"
#include "shaders/lib/curvature.glsl"
#include "shaders/lib/sky_tables.glsl"

struct MarchResult {
    vec3 light;      // radiance
    float through;   // transmittance
    float distance;  // m, mean of where the light came from, weighted by what reached the eye
};

/// Both distances along the ray at which it crosses altitude `s`, nearer first; negative where it does not.
vec2 crossings(float h, float mu, float s) {
    float b = (kPlanetRadius + h) * mu;
    float c = (h - s) * (2.0 * kPlanetRadius + h + s);
    float square = b * b - c;
    if (square < 0.0) return vec2(-1.0);
    float q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(square));
    float other = c / q;
    return vec2(min(q, other), max(q, other));
}

/// Distance to the next face of a shell beyond `t`, or `end`.
float nextFace(float h, float mu, float t, float end) {
    float next = end;
    for (int layer = 0; layer < clouds.march.x; ++layer) {
        vec4 extent = clouds.shapes[layer].extent;
        if (extent.z < 0.5 || clouds.shapes[layer].look.z > 0.5) continue;
        vec2 low = crossings(h, mu, extent.x);
        vec2 high = crossings(h, mu, extent.y);
        if (low.x > t) next = min(next, low.x);
        if (low.y > t) next = min(next, low.y);
        if (high.x > t) next = min(next, high.x);
        if (high.y > t) next = min(next, high.y);
    }
    return next;
}

bool insideAnyShell(float y) {
    for (int layer = 0; layer < clouds.march.x; ++layer)
        if (layerReaches(layer, y)) return true;
    return false;
}

/// A direction of the world as it stands in the flat frame under the sample, whose up has turned with the Earth.
vec3 inFlatFrame(vec3 toward, vec3 direction, vec3 flatPlace) {
    float level = length(direction.xz);
    if (level < 1e-4) return toward;
    vec2 ahead = direction.xz / level;
    float arc = length(flatPlace.xz) / kCurvatureRadius;
    float along = dot(toward.xz, ahead);
    float up = toward.y + along * arc;
    return normalize(vec3(toward.xz - ahead * toward.y * arc, up).xzy);
}

/// The light that clouds are lit by: the sun, or the moon once the sun gives less.
struct KeyLight {
    vec3 toward;      // world, unit
    vec3 above;       // irradiance above the air
    float radius;
};
KeyLight keyLight() {
    bool sunlit = sky.lights.sun.y > -0.14;
    return sunlit ? KeyLight(sky.lights.sun.xyz, sky.lights.sunLight.rgb, sky.lights.sun.w)
                  : KeyLight(sky.lights.moon.xyz, sky.lights.moonLight.rgb, sky.lights.moon.w);
}

/// Light of the upper and the lower half of the sphere at altitude `y`, mean radiances.
void diffuseAt(float y, float mu, vec3 above, out vec3 fromAbove, out vec3 fromBelow) {
    vec2 size = vec2(textureSize(skyMultipleTable, 0));
    vec3 mean = multipleScattering(skyMultipleTable, size, y, mu) * above;
    fromBelow = frame.groundIrradiance.rgb / 3.14159265;
    fromAbove = max(2.0 * mean - 0.7 * fromBelow, 0.6 * mean) + 0.5 * sky.airglow.rgb;
}

/// Light that falls on a place, clouds left out. It changes slowly: a ray asks anew every few kilometres.
struct LightThere {
    float asked;  // m along the ray
    vec3 toward;  // in the flat frame
    vec3 beam;    // irradiance
    vec3 fromAbove;
    vec3 fromBelow;
};

LightThere lightThere(vec3 p, vec3 direction, float t, KeyLight key) {
    LightThere there;
    there.asked = t;
    there.toward = inFlatFrame(key.toward, direction, p);
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    there.beam = key.above * lightThroughAir(skyTransmittanceTable, size, p.y, there.toward.y, key.radius);
    diffuseAt(p.y, there.toward.y, key.above, there.fromAbove, there.fromBelow);
    return there;
}

/// Radiance per optical depth at a sample. `first`: m, the nearest stretch of its way to the light.
vec3 lightAt(vec3 p, LightThere there, CloudSample here, float cosine, float lod, float first) {
    vec3 toward = there.toward;
    vec3 beam = there.beam;
    float overhead = depthOfLayersAbove(p, toward);
    vec3 light = vec3(0.0);
    if (max(beam.r, max(beam.g, beam.b)) > 1e-9) {
        float toLight = depthToward(p, toward, first, lod) + overhead;
        light = beam * litByBeam(cosine, clouds.light.x, toLight, here.depth, here.bulk, clouds.light.y);
    }
    return light + litByDiffuse(there.fromAbove, there.fromBelow, here.above + 0.5 * overhead, here.below, clouds.light.x);
}

/// A sheet of fibres where the ray crosses the middle of its layer.
MarchResult sheetAt(int layer, vec3 direction, float t, KeyLight key) {
    vec3 p = flatFromCurved(direction * t, frame.cameraWorld.y);
    float altitude = p.y + frame.cameraWorld.y;
    float coarse;
    LayerColumn column = columnAt(layer, p.xz, coarse);
    vec3 place = vec3(p.x, altitude, p.z);
    float slope = max(abs(inFlatFrame(direction, direction, place).y), 0.03);
    float lod = log2(max(t * frame.projection.w / slope * clouds.shapes[layer].fibre.w * 128.0, 1.0));
    float straight = sheetDepth(place, column, clouds.shapes[layer], cloudCurlNoise, lod);
    if (coarse > 0.0) straight = mix(straight, 0.4 * smoothstep(-0.4, 0.4, column.cover - column.rank) *
                                                   column.water * clouds.shapes[layer].look.w * (column.top - column.base), coarse);
    LightThere there = lightThere(place, direction, t, key);
    float toLight = 0.5 * straight / max(abs(there.toward.y), 0.1);
    float depth = straight / slope;
    vec3 light = there.beam * litByBeam(dot(direction, key.toward), 0.8 * clouds.light.x, toLight, straight, 2.0 * straight, 0.0) +
                 litByDiffuse(there.fromAbove, there.fromBelow, 0.0, 0.0, clouds.light.x);
    MarchResult result;
    result.through = exp(-depth);
    result.light = light * (1.0 - result.through);
    result.distance = t;
    return result;
}

/// Puts what lies nearer before what lies farther.
MarchResult merged(MarchResult near, MarchResult far) {
    if (near.distance > far.distance) {
        MarchResult swap = near;
        near = far;
        far = swap;
    }
    MarchResult result;
    result.light = near.light + near.through * far.light;
    result.through = near.through * far.through;
    float weightNear = 1.0 - near.through;
    float weightFar = near.through * (1.0 - far.through);
    float weight = weightNear + weightFar;
    result.distance = weight > 1e-4 ? (near.distance * weightNear + far.distance * weightFar) / weight : far.distance;
    return result;
}

MarchResult withSheets(MarchResult ray, vec3 direction, float end, KeyLight key) {
    float h = frame.cameraWorld.y;
    for (int layer = 0; layer < clouds.march.x; ++layer) {
        vec4 extent = clouds.shapes[layer].extent;
        if (extent.z < 0.5 || clouds.shapes[layer].look.z < 0.5) continue;
        vec2 cross = crossings(h, direction.y, 0.5 * (extent.x + extent.y));
        for (int k = 0; k < 2; ++k)
            if (cross[k] > 0.0 && cross[k] < end) ray = merged(ray, sheetAt(layer, direction, cross[k], key));
    }
    return ray;
}

const float kSearch = 0.65;       // full steps that look for a face, as a share of the longest: at most,
const float kShortSearch = 0.25;  // and at least
const float kOpaque = 0.025;      // transmittance that counts as none
const int kEmptySteps = 9;        // of these until they are cheap again

/// Where between `outside` and `inside` a cloud begins, so that neighbouring rays find the same face.
float faceBetween(float outside, float inside, vec3 direction, float h, float lod) {
    for (int i = 0; i < 4; ++i) {
        float middle = 0.5 * (outside + inside);
        vec3 p = flatFromCurved(direction * middle, h);
        if (cloudAt(p + vec3(0.0, h, 0.0), lod).extinction > 0.0) inside = middle;
        else outside = middle;
    }
    return inside;
}

/// The same of outlines, asked without volumes; the last place found outside. Neighbouring rays so begin their full steps
/// side by side, and meet or miss the same thin turret.
float outlineBetween(float outside, float inside, vec3 direction, float h) {
    if (inside - outside < 1.0) return inside;
    for (int i = 0; i < 4; ++i) {
        float middle = 0.5 * (outside + inside);
        vec3 p = flatFromCurved(direction * middle, h);
        if (cloudMayBeAt(p + vec3(0.0, h, 0.0))) inside = middle;
        else outside = middle;
    }
    return outside;
}

/// Where a ray stands between its samples.
struct Walk {
    float t;
    float face;    // where it came into the shells
    float stride;  // m, of the next step
    bool full;     // full steps, else cheap ones
    int empty;     // full steps without cloud since the last one with
    int left;      // thirds of steps that may still be taken
};

float longestStep(float t) { return clouds.step.x + clouds.step.y * t; }
float lodAt(float t, float length) {
    return max(log2(max(t * frame.projection.w, 0.25 * length) * clouds.shapes[0].anchor.w * 128.0), 0.0);
}
vec3 placeAt(vec3 direction, float t, float h) {
    vec3 p = flatFromCurved(direction * t, h);
    return vec3(p.x, p.y + h, p.z);
}

/// Goes on to the next cloud; false when the ray ends first. Its own loop: rays that have found one wait for the rest,
/// and then all do the costly part at once.
bool findCloud(vec3 direction, float h, float end, inout Walk walk, out CloudSample here, out vec3 p) {
    here = noCloud();
    p = vec3(0.0);
    while (walk.t < end && walk.left > 0) {
        walk.left -= 3;
        p = placeAt(direction, walk.t, h);
        float longest = longestStep(walk.t);
        if (!insideAnyShell(p.y)) {
            walk.face = nextFace(h, direction.y, walk.t, end) + 0.5;
            walk.t = walk.face;
            walk.stride = 0.0;
            walk.full = false;
        } else if (!walk.full) {
            if (cloudMayBeAt(p)) {
                walk.full = true;
                walk.t = outlineBetween(walk.t - walk.stride, walk.t, direction, h);
                walk.stride = min(kSearch * longest, walk.t - walk.face);
                walk.empty = walk.stride > 1.0 ? 1 : 0;
            } else {
                walk.stride = (walk.t > walk.face ? 2.0 : 1.5) * longest;
                walk.t += walk.stride;
            }
        } else {
            here = cloudAt(p, lodAt(walk.t, walk.stride));
            if (here.extinction > 0.0) return true;
            // On to the face, whose distance is known to first order: short steps where a turret may be missed.
            float share = clamp(0.8 * here.outside / longest, kShortSearch, kSearch);
            walk.left += 3 - int(3.0 * share);  // charged by its length
            walk.stride = share * longest;
            walk.t += walk.stride;
            if (++walk.empty >= kEmptySteps) {
                walk.full = false;
                walk.stride = 0.0;  // all behind is known: nowhere to go back to
            }
        }
    }
    return false;
}

/// Layers with a body.
MarchResult marchBodies(vec3 direction, float end, KeyLight key) {
    float h = frame.cameraWorld.y;
    MarchResult ray = MarchResult(vec3(0.0), 1.0, 0.0);
    float weights = 0.0;
    float cosine = dot(direction, key.toward);
    Walk walk = Walk(0.0, 0.0, 0.0, false, 0, 3 * clouds.march.y);
    LightThere there;
    there.asked = -1.0e6;
    CloudSample here;
    vec3 p;
    while (ray.through > kOpaque && findCloud(direction, h, end, walk, here, p)) {
        float longest = longestStep(walk.t);
        float shortest = max(10.0, 0.0015 * walk.t);
        float lod = lodAt(walk.t, walk.stride);
        if (walk.empty > 0) {
            walk.t = faceBetween(walk.t - walk.stride, walk.t, direction, h, lod);
            p = placeAt(direction, walk.t, h);
            here = cloudAt(p, lod);
            walk.stride = min(2.0 * shortest, longest);
            walk.empty = 0;
        }
        // The step's middle stands for it. An eye inside a cloud starts with no stride behind it.
        float depth = mix(1.8, 0.8, ray.through);  // what little still reaches the eye needs no fine steps
        float length = min(max(walk.stride, shortest), max(depth / max(here.extinction, 1e-5), shortest));
        float middle = walk.t + 0.5 * length;
        p = placeAt(direction, middle, h);
        here = cloudAt(p, lod);
        if (here.extinction > 0.0) {
            float kept = exp(-here.extinction * length);
            float weight = ray.through * (1.0 - kept);
            if (middle > there.asked + 2000.0 + 0.1 * middle) there = lightThere(p, direction, middle, key);
            float first = clamp(max(0.5 * length, 1.5 * middle * frame.projection.w), 18.0, 240.0);
            ray.light += weight * lightAt(p, there, here, cosine, lod, first);
            ray.distance += weight * middle;
            weights += weight;
            ray.through *= kept;
        }
        walk.t += length;
        walk.stride = min(length * 1.5, longest);
    }
    ray.distance = weights > 1e-5 ? ray.distance / weights : min(end, clouds.step.z);
    if (ray.through <= kOpaque) {
        ray.light /= 1.0 - ray.through;
        ray.through = 0.0;
    }
    return ray;
}

MarchResult marchClouds(vec3 direction, float land) {
    KeyLight key = keyLight();
    float end = min(land, clouds.step.z);
    MarchResult ray = marchBodies(direction, end, key);
    return withSheets(ray, direction, land, key);
}
#endif
