// A ray through the shells of the clouds. GLSL alone.
//
// The ray is straight in the bent picture; every sample is taken back to the flat world by flatFromCurved. Between the
// layers it jumps to the next shell; in a shell it goes in cheap steps, that ask for outlines alone, until there may be
// a cloud, back half a step, then in full ones, whose length is bounded by optical depth and by distance, never by the
// length of the shell; after six empty ones it is cheap again.
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

const int kRayOfBlock[16] = int[16](0, 10, 2, 8, 5, 15, 7, 13, 1, 11, 3, 9, 4, 14, 6, 12);

/// The pixel whose ray stands for `place` of the marched picture: itself, or one of its 4 x 4 block, each in its turn.
ivec2 marchedPixel(ivec2 place) {
    if (clouds.march.w == 1) return place;
    int ray = kRayOfBlock[clouds.march.z];
    return place * 4 + ivec2(ray & 3, ray >> 2);
}

/// Interleaved gradient noise (Jimenez 2014), moved from frame to frame: neighbours differ as much as they can.
float randomOf(ivec2 pixel) {
    return fract(52.9829189 * fract(0.06711056 * float(pixel.x) + 0.00583715 * float(pixel.y)) + clouds.step.w);
}

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

/// Radiance per optical depth at a sample.
vec3 lightAt(vec3 p, vec3 direction, CloudSample here, KeyLight key, float lod, float stepLength) {
    vec3 toward = inFlatFrame(key.toward, direction, p);
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    vec3 beam = key.above * lightThroughAir(skyTransmittanceTable, size, p.y, toward.y, key.radius);
    float overhead = depthOfLayersAbove(p, toward);
    vec3 light = vec3(0.0);
    if (max(beam.r, max(beam.g, beam.b)) > 1e-9) {
        float toLight = depthToward(p, toward, clamp(0.5 * stepLength, 18.0, 120.0), lod) + overhead;
        light = beam * litByBeam(dot(direction, key.toward), clouds.light.x, toLight, here.depth, clouds.light.y);
    }
    vec3 fromAbove, fromBelow;
    diffuseAt(p.y, toward.y, key.above, fromAbove, fromBelow);
    return light + litByDiffuse(fromAbove, fromBelow, here.above + 0.5 * overhead, here.below, clouds.light.x);
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
    vec3 toward = inFlatFrame(key.toward, direction, place);
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    vec3 beam = key.above * lightThroughAir(skyTransmittanceTable, size, altitude, toward.y, key.radius);
    float toLight = 0.5 * straight / max(abs(toward.y), 0.1);
    float depth = straight / slope;
    vec3 fromAbove, fromBelow;
    diffuseAt(altitude, toward.y, key.above, fromAbove, fromBelow);
    vec3 light = beam * litByBeam(dot(direction, key.toward), 0.8 * clouds.light.x, toLight, straight, 0.0) +
                 litByDiffuse(fromAbove, fromBelow, 0.0, 0.0, clouds.light.x);
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

/// Layers with a body. `land`: distance of what stops the ray.
MarchResult marchBodies(vec3 direction, float end, float random, KeyLight key) {
    float h = frame.cameraWorld.y;
    MarchResult ray = MarchResult(vec3(0.0), 1.0, 0.0);
    float weights = 0.0;
    float t = 0.0;
    if (!insideAnyShell(h)) t = nextFace(h, direction.y, 0.0, end) + 0.5;
    t += random * (clouds.step.x + clouds.step.y * t);
    bool full = false;
    int empty = 0;
    float length = 0.0;
    for (int i = 0; i < clouds.march.y && t < end && ray.through > 0.005; ++i) {
        vec3 p = flatFromCurved(direction * t, h);
        p.y += h;
        float longest = clouds.step.x + clouds.step.y * t;
        if (!insideAnyShell(p.y)) {
            t = nextFace(h, direction.y, t, end) + 0.5 + 0.3 * random * longest;
            full = false;
            continue;
        }
        if (!full) {
            if (!cloudMayBeAt(p)) {
                t += 2.0 * longest;
                continue;
            }
            full = true;
            empty = 0;
            length = 0.5 * longest;
            t = max(t - longest, 0.0);
            continue;
        }
        float lod = max(log2(max(t * frame.projection.w, 0.25 * length) * clouds.shapes[0].anchor.w * 128.0), 0.0);
        CloudSample here = cloudAt(p, lod);
        if (here.extinction <= 0.0) {
            length = longest;
            t += length;
            if (++empty >= 6) full = false;
            continue;
        }
        float shortest = max(8.0, 0.0015 * t);
        if (empty > 0 || here.extinction * length > 1.2) length = clamp(0.8 / here.extinction, shortest, longest);
        empty = 0;
        float kept = exp(-here.extinction * length);
        float weight = ray.through * (1.0 - kept);
        ray.light += weight * lightAt(p, direction, here, key, lod + 0.5, length);
        ray.distance += weight * t;
        weights += weight;
        ray.through *= kept;
        t += length;
        length = min(length * 1.3, longest);
    }
    ray.distance = weights > 1e-5 ? ray.distance / weights : min(end, clouds.step.z);
    if (ray.through <= 0.005) ray.through = 0.0;
    return ray;
}

MarchResult marchClouds(vec3 direction, float land, float random) {
    KeyLight key = keyLight();
    float end = min(land, clouds.step.z);
    MarchResult ray = marchBodies(direction, end, random, key);
    return withSheets(ray, direction, land, key);
}
#endif
