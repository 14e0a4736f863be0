// A ray through the shells of the clouds. GLSL alone.
//
// The ray is straight in the bent picture; every sample is taken back to the flat world by flatFromCurved. Between the
// layers it jumps to the next shell; in a shell it goes in cheap steps, that ask for outlines alone, until there may be
// a cloud, back to where that outline begins, then in full ones to its face; through the cloud in steps whose length is
// bounded by optical depth and by distance, never by the length of the shell; after sixteen empty ones it is cheap again.
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

/// Light that falls on a place, the clouds of its own layers left out. It changes slowly: a ray asks anew every few kilometres.
struct LightThere {
    vec3 toward;  // in the flat frame
    vec3 beam;    // irradiance
    Around around;
    LayersAbove overhead;
};

/// What light the land has below a place, over its mean: as much of it lies in the shade as of four points around.
float landBelow(vec3 p, vec3 toward) {
    if (clouds.depthHeights.w < 0.5) return 1.0;
    float ground = sky.air.fog.z, away = 0.7 * (p.y - ground);
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 side = vec2((i & 1) == 0 ? away : -away, (i & 2) == 0 ? away : -away) * 0.7071;
        vec3 q = vec3(p.x + side.x, ground, p.z + side.y);
        vec2 onPlane = onDepthPlane(q, toward);
        int grid = gridOver(onPlane);
        lit += 0.25 * (grid < 2 ? mix(sky.land.x, sky.land.y, beamBehind(griddedDepth(grid, q, onPlane))) : 1.0);
    }
    return lit;
}

LightThere lightThere(vec3 p, vec3 direction, KeyLight key) {
    LightThere there;
    there.toward = inFlatFrame(key.toward, direction, p);
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    there.beam = key.above * lightThroughAir(skyTransmittanceTable, size, p.y, there.toward.y, key.radius);
    there.around = aroundAt(p.y);
    there.around.below *= landBelow(p, there.toward);
    there.overhead = layersAbove(p, there.toward);
    return there;
}

const float kThinnest = 0.005;  // 1/m: in thinner cloud the glow is asked for as near as in such one

// m from slice to slice of the glow: where storms stand so high that slices are thick, what is lower than a few of them is lost in them.
const float kFineSlices = 150.0, kThickSlices = 250.0;

/// Radiance per optical depth at a sample. `first`: m, the nearest stretch of its way to the light.
vec3 lightAt(vec3 p, LightThere there, CloudSample here, vec3 direction, RayPhase phase, float lod, float first) {
    vec3 toward = there.toward;
    float toLight = depthToward(p, toward, first, lod) + there.overhead.sheets;
    float s = reducedShare(), ahead = glowAhead(phase.g);
    float core = max(here.core, kThinnest), height = (here.above + here.below) / core;
    float known = glowKnown(p) * mix(1.0, smoothstep(2.0, 6.0, height / glowStep()), smoothstep(kFineSlices, kThickSlices, glowStep()));
    float up = abs(toward.y), narrow = narrowness(here.wide / core);
    float deeper = clamp(-ahead * direction.y, -here.above, here.below);
    vec2 grid = glowAt(p + direction * (ahead / core));
    vec2 closed = closedGlow(max(toLight - ahead * phase.cosine, 0.0), here.above + deeper, here.below - deeper, here.wide, here.depth, up, s);
    closed *= vec2(diffused(there.overhead.all, s), diffused(0.5 * there.overhead.all, s));
    vec2 glow = mix(closed, grid * vec2(gridContrast(toLight, here.depth, narrow, up, s), diffused(0.5 * there.overhead.sheets, s)), known);
    return there.beam * (litByBeam(phase, toLight, glow.x) * (1.0 - clouds.light.y * exp(-2.0 * here.depth))) +
           litBySky(there.around.above, there.around.below, glow.y);
}

/// The sheets of fibres, a bit each.
int sheetLayers() {
    int bits = 0;
    for (int layer = 0; layer < clouds.march.x; ++layer)
        bits |= clouds.shapes[layer].extent.z > 0.5 && clouds.shapes[layer].look.z > 0.5 ? 1 << layer : 0;
    return bits;
}

/// `share` of a sheet of fibres where the ray crosses it.
MarchResult sheetAt(int layer, vec3 direction, float t, float share, KeyLight key) {
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
    LightThere there = lightThere(place, direction, key);
    float toLight = 0.5 * straight / max(abs(there.toward.y), 0.1);
    float depth = share * straight / slope;
    float g = kIceShare * clouds.light.x, s = 1.0 - meanCosine(g);
    vec2 glow = vec2(slabGlow(0.5 * s * straight, s * straight, max(abs(there.toward.y), 0.1)), 0.5);
    vec3 light = there.beam * litByBeam(rayPhase(dot(direction, key.toward), g), toLight, glow.x) +
                 litBySky(there.around.above, there.around.below, glow.y);
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

/// The part of a sheet between two altitudes, wherever the ray crosses the middle between them.
MarchResult withPart(MarchResult ray, int layer, vec2 altitudes, float share, vec3 direction, float end, KeyLight key) {
    vec2 cross = crossings(frame.cameraWorld.y, direction.y, 0.5 * (altitudes.x + altitudes.y));
    int left = (cross.x > 0.0 && cross.x < end ? 1 : 0) | (cross.y > 0.0 && cross.y < end ? 2 : 0);
    if (left != 0) do {
        ray = merged(ray, sheetAt(layer, direction, cross[findLSB(left)], share, key));
        left &= left - 1;
    } while (left != 0);
    return ray;
}

/// From within a layer its fibres lie above and below, most in its middle: 6 s (1 - s), as layerSample has it. Two bits a layer say
/// which of its parts there are: the same for every ray.
MarchResult withSheets(MarchResult ray, vec3 direction, float end, KeyLight key) {
    int sheets = sheetLayers();
    int parts = 0;
    for (int layer = 0; layer < clouds.march.x; ++layer) {
        vec4 extent = clouds.shapes[layer].extent;
        bool sheet = (sheets >> layer & 1) != 0;
        parts |= sheet && frame.cameraWorld.y < extent.y ? 1 << 2 * layer : 0;
        parts |= sheet && frame.cameraWorld.y > extent.x ? 2 << 2 * layer : 0;
    }
    if (parts != 0) do {
        int part = findLSB(parts);
        int layer = part / 2;
        vec4 extent = clouds.shapes[layer].extent;
        float eye = clamp(frame.cameraWorld.y, extent.x, extent.y);
        float below = smoothstep(extent.x, extent.y, eye);
        bool upper = part % 2 == 0;
        ray = withPart(ray, layer, upper ? vec2(eye, extent.y) : vec2(extent.x, eye), upper ? 1.0 - below : below, direction, end, key);
        parts &= parts - 1;
    } while (parts != 0);
    return ray;
}

const float kSearch = 2.0;        // full steps that look for a face, as a share of the longest: at most,
const float kShortSearch = 0.7;   // and at least
const float kShortOutline = 1.2;  // the same of those that look for an outline, at least
const float kLongOutline = 6.0;   // and at most
const float kStepGrowth = 1.35;   // of a step in a cloud, over the one before it, at most
const float kOpaque = 0.06;       // transmittance that counts as none
const int kEmptySteps = 16;       // of these until they are cheap again
const float kUnknownGap = 30.0;   // m, from a place outside to the face, where the way there was not asked for

float longestStep(float t) { return clouds.step.x + clouds.step.y * t; }
float lodAt(float t, float length) {
    return max(log2(max(t * frame.projection.w, 0.25 * length) * clouds.shapes[0].anchor.w * 128.0), 0.0);
}
vec3 placeAt(vec3 direction, float t, float h) {
    vec3 p = flatFromCurved(direction * t, h);
    return vec3(p.x, p.y + h, p.z);
}

/// Where a ray stands between its samples. Between two faces of shells it is in the same layers all the way.
struct Walk {
    float t;
    float end;     // the next face of a shell, or the ray's end
    float stride;  // m, of the step that led here; 0: nothing is known of what is behind
    int layers;    // that reach where it is
    int left;      // thirds of steps that may still be taken
};

// The loops stand one after the other, each with little in it: rays that are through with one wait for the rest, and then all do
// the next together. What was found between two steps is narrowed down in the same loop: there is one place where it asks.
const int kHalves = 1;  // of an outline, which only says yes or no

/// In cheap steps on to where there may be cloud, to the last place found outside; false when the stretch between two faces ends before.
/// Neighbouring rays so begin their full steps side by side, and meet or miss the same thin turret.
bool findOutline(vec3 direction, float h, inout Walk walk) {
    bool found = false;
    int halves = kHalves;
    float outside = walk.t, inside = walk.t, at = walk.t;
    bool on = walk.t < walk.end && walk.left > 0;
    if (on) do {
        float away = outsideOutlines(walk.layers, placeAt(direction, at, h));
        bool cloud = away <= 0.0;
        if (found) {
            --halves;
            inside = cloud ? at : inside;
            outside = cloud ? outside : at;
        } else {
            --walk.left;  // a third of a full one's price
            found = cloud;
            inside = walk.t;
            outside = walk.t - walk.stride;
            if (!found) {
                float longest = longestStep(walk.t);
                walk.stride = clamp(0.8 * away, kShortOutline * longest, kLongOutline * longest);
                walk.t += walk.stride;
            }
        }
        at = found ? 0.5 * (outside + inside) : walk.t;
        on = found ? halves > 0 : walk.t < walk.end && walk.left > 0;
    } while (on);
    if (!found) {
        walk.t = min(walk.t, walk.end);
        return false;
    }
    walk.stride = walk.stride > 0.0 ? min(kSearch * longestStep(walk.t), outside - walk.t + walk.stride) : 0.0;
    walk.t = outside;
    return true;
}

/// From shell to shell to the next outline; false when the ray ends before.
bool nextOutline(vec3 direction, float h, float end, inout Walk walk) {
    bool found = false;
    bool on = walk.t < end && walk.left > 0;
    if (on) do {
        if (walk.t >= walk.end) {
            walk.t += walk.end > 0.0 ? 0.5 : 0.0;
            walk.end = nextFace(h, direction.y, walk.t, end);
            walk.layers = layersAt(placeAt(direction, 0.5 * (walk.t + walk.end), h).y);
            walk.stride = 0.0;
        }
        if (walk.layers == 0) walk.t = walk.end;
        else found = findOutline(direction, h, walk);
        on = !found && walk.t < end && walk.left > 0;
    } while (on);
    return found;
}

/// Where a face lies between a place `gap` m outside it and one `deep` m within, as a share of the way from the first to the second.
float faceBetween(float gap, float deep) { return clamp(gap / max(gap + deep, 1e-3), 0.0, 1.0); }

/// In full steps on to a cloud's face, so that neighbouring rays find the same one; false when there is none for some of them. What
/// is found between two steps is asked for once more where it should be, and then drawn in (regula falsi).
bool findFace(vec3 direction, float h, inout Walk walk) {
    int empty = 0;
    bool found = false, near = false;
    float lod = 0.0, outside = walk.t, at = walk.t;
    float gap = kUnknownGap, deep = 0.0;
    bool on = walk.t < walk.end && walk.left > 0;
    if (on) do {
        lod = found ? lod : lodAt(walk.t, walk.stride);
        CloudSample here = cloudOf(walk.layers, placeAt(direction, at, h), lod);
        bool cloud = here.extinction > 0.0;
        near = found;
        if (cloud) {
            outside = found ? outside : walk.t - walk.stride;
            walk.t = at;
            deep = -here.outside;
        } else {
            outside = at;
            gap = here.outside;
        }
        if (!cloud && !found) {
            // On to the face, whose distance is known to first order: short steps where a turret may be missed.
            float longest = longestStep(walk.t);
            float share = clamp(0.9 * here.outside / longest, kShortSearch, kSearch);
            walk.left -= int(3.0 * share);  // charged by its length
            walk.stride = share * longest;
            walk.t += walk.stride;
            ++empty;
        }
        found = found || cloud;
        at = found ? mix(outside, walk.t, clamp(faceBetween(gap, deep), 0.15, 0.85)) : walk.t;
        on = found ? !near && walk.stride > 0.0 : empty < kEmptySteps && walk.t < walk.end && walk.left > 0;
    } while (on);
    if (!found) {
        walk.stride = 0.0;  // all behind is known: nowhere to go back to
        walk.t = min(walk.t, walk.end);
        return false;
    }
    if (near) walk.t = mix(outside, walk.t, faceBetween(gap, deep));
    return true;
}

/// What a ray has gathered of bodies: `distance` is a sum until it is divided by `weights`.
struct Gathered {
    MarchResult ray;
    float weights;
};

/// Through the cloud whose face the ray has come to, until it is out of it or nothing more gets through. The middle of a step
/// stands for it, and says how long the next one may be.
void passCloud(vec3 direction, float h, KeyLight key, inout Walk walk, inout Gathered sum) {
    LightThere there = lightThere(placeAt(direction, walk.t, h), direction, key);
    RayPhase phase = rayPhase(dot(direction, key.toward), clouds.light.x);
    float shortest = max(10.0, 0.0015 * walk.t);
    float length = min(walk.stride > 0.0 ? 2.0 * shortest : shortest, longestStep(walk.t));
    bool inside = true;
    float far = min(walk.end, walk.t + 2000.0 + 0.1 * walk.t);  // until the light has to be asked anew
    bool on = walk.t < far && walk.left > 0;
    if (on) do {
        walk.left -= 3;
        float middle = walk.t + 0.5 * length;
        vec3 p = placeAt(direction, middle, h);
        CloudSample here = cloudOf(walk.layers, p, lodAt(walk.t, length));
        inside = here.extinction > 0.0;
        float kept = exp(-here.extinction * length);
        float weight = sum.ray.through * (1.0 - kept);
        // What little still reaches the eye needs no near billows on its way to the light.
        float first = clamp(1.5 * middle * frame.projection.w / max(sum.ray.through, 0.25), 25.0, 240.0);
        if (inside) sum.ray.light += weight * lightAt(p, there, here, direction, phase, lodAt(walk.t, length), first);
        sum.ray.distance += weight * middle;
        sum.weights += weight;
        sum.ray.through *= kept;
        walk.t += length;
        walk.stride = length;
        shortest = max(10.0, 0.0015 * walk.t);
        float depth = mix(2.8, 1.2, sum.ray.through);  // what little still reaches the eye needs no fine steps
        length = min(min(length * kStepGrowth, longestStep(walk.t)), max(depth / max(here.extinction, 1e-5), shortest));
        on = inside && sum.ray.through > kOpaque && walk.t < far && walk.left > 0;
    } while (on);
    if (inside) walk.stride = 0.0;  // no face behind
}

/// Layers with a body.
MarchResult marchBodies(vec3 direction, float end, KeyLight key) {
    float h = frame.cameraWorld.y;
    Gathered sum = Gathered(MarchResult(vec3(0.0), 1.0, 0.0), 0.0);
    Walk walk = Walk(0.0, 0.0, 0.0, 0, 3 * clouds.march.y);
    bool face = false;
    bool on = walk.t < end && walk.left > 0;
    if (on) do {
        bool outline = face || nextOutline(direction, h, end, walk);
        face = outline && findFace(direction, h, walk);
        if (face) passCloud(direction, h, key, walk, sum);
        on = sum.ray.through > kOpaque && walk.t < end && walk.left > 0;
    } while (on);
    MarchResult ray = sum.ray;
    ray.light *= 1.0 - kThinLess * ray.through;
    ray.distance = sum.weights > 1e-5 ? ray.distance / sum.weights : min(end, clouds.step.z);
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
