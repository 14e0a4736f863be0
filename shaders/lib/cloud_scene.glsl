// The clouds around the camera as passes see them: samplers, columns, density, the way toward the light. GLSL alone.
// Places are flat: x east and z south of the camera, y above sea level.
//
// Loops that sample clouds ask at their end whether to go on: software GL skips nothing but the way back, so that a loop which asks at
// its head runs its whole body once for nothing.
#ifndef LUFTPOST_CLOUD_SCENE_GLSL
#define LUFTPOST_CLOUD_SCENE_GLSL
#include "shaders/lib/cloud.glsl"
#include "shaders/lib/cloud_light.glsl"

layout(binding = 10) uniform sampler2DArray cloudMap;    // ranks, [level * 4 + layer]
layout(binding = 11) uniform sampler3D cloudShapeNoise;
layout(binding = 12) uniform sampler3D cloudDetailNoise;
layout(binding = 13) uniform planeSampler cloudCurlNoise;
layout(binding = 17) uniform sampler3D cloudGlow;        // light that is scattered again and again, upright columns over the inner grid
layout(binding = 16) uniform sampler3D cloudDepthGrid;   // optical depth toward the light, two grids of slices one upon the other

const float kDeepest = 1000.0;        // optical depth toward a light that counts as all: more than a cumulonimbus has
const int kDepthSlices = 32;        // of each grid
const int kGlowSlices = 32;
const float kLowestLight = 0.06;    // sine of the elevation: a lower light is taken to stand here

/// Rank and how much of it is the outer level's coarse one.
vec2 rankAt(int layer, vec2 place) {
    vec2 sum = vec2(0.0);
    float left = 1.0;
    for (int level = 0; level < kCloudMapLevels && left > 0.0; ++level) {
        vec4 map = clouds.mapPlaces[level * kCloudLayers + layer];
        if (map.w < 0.5) continue;
        vec2 uv = (place + map.xy) * map.z;
        vec2 border = abs(uv - 0.5) * 2.0;
        bool outer = level == kCloudMapLevels - 1;
        float inside = outer ? 1.0 : 1.0 - smoothstep(0.80, 0.92, max(border.x, border.y));
        float weight = left * inside;
        if (weight <= 0.0) continue;
        sum += weight * vec2(textureLod(cloudMap, vec3(uv, map.w - 1.0), 0.0).r, outer ? 1.0 : 0.0);
        left -= weight;
    }
    return left < 1.0 ? sum / (1.0 - left) : vec2(1.0, 0.0);
}

/// The layer's column over a place; `coarse`: share of the outer level in it.
LayerColumn columnAt(int layer, vec2 place, out float coarse) {
    LayerField field = clouds.fields[layer];
    vec4 v = clamp(field.centre + field.eastward * place.x + field.southward * place.y, field.low, field.high);
    vec2 rank = rankAt(layer, place);
    coarse = hasTowers(clouds.shapes[layer]) ? 0.0 : rank.y;  // what has an anvil is large enough to be drawn whole anywhere
    return LayerColumn(rank.x, v.x, v.y, v.z, v.w, rank.x);
}

/// The same with the rank of its anvil, where it has one: two more are read.
LayerColumn withAnvil(LayerColumn c, int layer, vec2 place) {
    LayerShape s = clouds.shapes[layer];
    if (hasTowers(s)) c.anvil = anvilRank(rankAt(layer, place - s.fibre.z * s.fibre.xy).x, rankAt(layer, place - s.fibre.xy).x, s.fibre.w);
    return c;
}

/// Whether a layer's anvil may lie at an altitude, `reach` m of blur around it.
bool anvilReaches(LayerColumn c, int layer, float y, float reach) {
    return hasTowers(clouds.shapes[layer]) && y > c.base + kAnvilFoot * (c.top - c.base) - reach;
}

/// Of a layer with a body.
CloudSample layerAt(int layer, vec3 p, float lod) {
    float coarse;
    LayerColumn column = columnAt(layer, p.xz, coarse);
    if (anvilReaches(column, layer, p.y, 16.0 * exp2(lod))) column = withAnvil(column, layer, p.xz);
    CloudSample near = noCloud();
    if (coarse < 1.0)
        near = solidSample(p, column, clouds.shapes[layer], cloudShapeNoise, cloudDetailNoise, cloudCurlNoise, lod);
    if (coarse <= 0.0) return near;
    float far = distantExtinction(p.y, column, clouds.shapes[layer]);
    near.extinction = mix(near.extinction, far, coarse);
    float h = (p.y - column.base) / (column.top - column.base);
    near.depth = mix(near.depth, 0.5, coarse);
    near.wide = mix(near.wide, 30.0, coarse);
    float whole = clamp(0.5 * column.water * clouds.shapes[layer].look.w * (column.top - column.base), 8.0, 40.0);
    near.above = mix(near.above, whole * (1.0 - h), coarse);
    near.below = mix(near.below, whole * h, coarse);
    near.core = mix(near.core, column.water * clouds.shapes[layer].look.w, coarse);
    return near;
}

/// The layers with a body that reach into what lies between two altitudes, one bit each.
int layersBetween(float low, float high) {
    int bits = 0;
    for (int layer = 0; layer < kCloudLayers; ++layer) {
        vec4 extent = clouds.shapes[layer].extent;
        bits |= extent.z > 0.5 && clouds.shapes[layer].look.z < 0.5 && high > extent.x && low < extent.y ? 1 << layer : 0;
    }
    return bits;
}
int layersAt(float y) { return layersBetween(y, y); }

/// The layers of `bits` (not the sheets of fibres) at a place; depths weighted by extinction.
CloudSample cloudOf(int bits, vec3 p, float lod) {
    CloudSample sum = noCloud();
    if (bits != 0) do {
        sum = together(sum, layerAt(findLSB(bits), p, lod));
        bits &= bits - 1;
    } while (bits != 0);
    return sum;
}
CloudSample cloudAt(vec3 p, float lod) { return cloudOf(layersAt(p.y), p, lod); }

const float kDomeSlope = 0.3;  // of a height over a dome's face, how far that face may be

/// About how far a place lies outside the outlines of the layers, m: what the rank says in the plane, or the height over a dome or under a
/// lens; 0 or less: there may be cloud. No volumes are read.
float outsideOutlines(int bits, vec3 p) {
    float outside = 1.0e6;
    if (bits != 0) do {
        int layer = findLSB(bits);
        float coarse;
        LayerColumn c = columnAt(layer, p.xz, coarse);
        LayerShape s = clouds.shapes[layer];
        float thickness = c.top - c.base;
        float share = (p.y - c.base) / thickness;
        float towers = towerCover(c.cover, s);
        float margin = towers - c.rank + s.look.y * frayWindow(towers) + 0.4 * coarse;
        float rise = riseAt(margin, towers, s);
        float past = max(share - rise, s.form.y * (1.0 - rise) - share);  // of the thickness
        past = max(coarse > 0.0 ? -1.0 : kDomeSlope * past, max(-share, share - 1.0));
        outside = min(outside, max(-margin * s.body.x, past * thickness));
        if (hasTowers(s)) {
            float rim = (withAnvil(c, layer, p.xz).anvil - c.cover - anvilFray(c.cover)) * s.body.x;
            outside = min(outside, max(rim, max(kAnvilFoot - share, share - kAnvilTop - 0.01) * thickness));
        }
        bits &= bits - 1;
    } while (bits != 0 && outside > 0.0);
    return outside;
}

/// Optical depths of the layers that lie wholly above a place, where a way along `toward` passes them.
struct LayersAbove {
    float sheets;  // of fibres: depthToward does not meet them
    float all;
};
LayersAbove layersAbove(vec3 p, vec3 toward) {
    LayersAbove sum = LayersAbove(0.0, 0.0);
    int bits = 0;
    for (int layer = 0; layer < kCloudLayers; ++layer) {
        vec4 extent = clouds.shapes[layer].extent;
        bits |= extent.z > 0.5 && extent.x >= p.y ? 1 << layer : 0;
    }
    if (bits != 0) do {
        int layer = findLSB(bits);
        vec4 extent = clouds.shapes[layer].extent;
        float coarse;
        float up = max(toward.y, 0.08);
        vec2 there = p.xz + toward.xz * ((0.5 * (extent.x + extent.y) - p.y) / up);
        LayerColumn c = withAnvil(columnAt(layer, there, coarse), layer, there);
        float depth = envelopeDepth(c, clouds.shapes[layer], up);
        sum.all += depth;
        sum.sheets += clouds.shapes[layer].look.z > 0.5 ? depth : 0.0;
        bits &= bits - 1;
    } while (bits != 0);
    return sum;
}

/// Altitude over which no layer with a body reaches.
float highestTop() {
    float top = -1.0e5;
    for (int layer = 0; layer < clouds.march.x; ++layer)
        if (clouds.shapes[layer].look.z < 0.5) top = max(top, clouds.shapes[layer].extent.y);
    return top;
}

/// Whether a grid covers a place, whose point on the grids' plane is `onPlane`; 2 when neither does.
int gridOver(vec2 onPlane) {
    float far = max(abs(onPlane.x), abs(onPlane.y));
    return far < 0.46 * clouds.depthPlaces[0].w ? 0 : far < 0.46 * clouds.depthPlaces[1].w ? 1 : 2;
}

/// Where the light that passes a place meets the grids' plane.
vec2 onDepthPlane(vec3 p, vec3 toward) { return p.xz - toward.xz * ((p.y - clouds.depthHeights.z) / max(toward.y, kLowestLight)); }

/// Optical depth from a place to where no cloud is, read from grid `grid`.
float griddedDepth(int grid, vec3 p, vec2 onPlane) {
    vec4 place = clouds.depthPlaces[grid];
    float height = clamp((p.y - clouds.depthHeights.x) / (clouds.depthHeights.y - clouds.depthHeights.x), 0.0, 1.0);
    float slice = 0.5 * float(grid) + (height * (float(kDepthSlices) - 1.0) + 0.5) / (2.0 * float(kDepthSlices));
    return p.y < clouds.depthHeights.y ? textureLod(cloudDepthGrid, vec3((onPlane + place.xy) * place.z, slice), 0.0).r : 0.0;
}

/// Share of the extinction that is left when turns are even.
float reducedShare() { return 1.0 - meanCosine(clouds.light.x); }

/// m from slice to slice of the glow.
float glowStep() { return (clouds.depthHeights.y - clouds.depthHeights.x) / float(kGlowSlices); }

/// Where a place lies in the glow's textures.
vec3 glowUnit(vec3 p) {
    vec4 place = clouds.depthPlaces[0];
    float slice = (p.y - clouds.depthHeights.x) / glowStep();
    return vec3((p.xz + place.xy) * place.z, clamp(slice, 0.5, float(kGlowSlices) - 0.5) / float(kGlowSlices));
}

/// The glow (lib/cloud_glow.glsl) at a place: x: of the light's beam, per unit of irradiance; y: of a sky of 1 above.
vec2 glowAt(vec3 p) { return textureLod(cloudGlow, glowUnit(p), 0.0).rg; }

/// How much of a place's light the glow knows: none beyond its columns.
float glowKnown(vec3 p) {
    float near = 1.0 - smoothstep(0.40, 0.46, max(abs(p.x), abs(p.z)) * clouds.depthPlaces[0].z);
    return clouds.depthHeights.w * near;
}

/// m of a way to the light between two slices of the grids: the lower the light, the longer.
float sliceWay(vec3 toward) {
    return (clouds.depthHeights.y - clouds.depthHeights.x) / ((float(kDepthSlices) - 1.0) * max(toward.y, kLowestLight));
}

const float kNearWay = 200.0;  // m: so far at least the way to the light is sampled, beyond it the grid knows
const float kConeGrowth = 2.4;  // of a stretch, over the one before it

/// Optical depth from `p` toward a light: samples in a widening cone, so far as billows count, then what the grid of optical depth
/// holds; beyond the grids samples all the way. The nearest sees the billows, as blurred as its stretch is long; the others see
/// neither fraying nor detail, so that a shadow has no steps.
float depthToward(vec3 p, vec3 toward, float first, float lod) {
    vec3 side = normalize(abs(toward.y) < 0.9 ? vec3(toward.z, 0.0, -toward.x) : vec3(1.0, 0.0, 0.0));
    vec3 other = cross(toward, side);
    vec2 onPlane = onDepthPlane(p, toward);
    int grid = clouds.depthHeights.w > 0.5 ? gridOver(onPlane) : 2;
    float leaves = (highestTop() - p.y) / max(toward.y, 1e-3);  // m, to where no cloud is
    if (grid < 2) leaves = min(leaves, max(kNearWay, 0.7 * sliceWay(toward)));
    float blur = log2(max(first * (1.0 / 32.0), 2.0));
    int bits = layersBetween(p.y, p.y + max(leaves, first) * max(toward.y, 0.0));
    float sum = cloudOf(bits, p + toward * (0.5 * first) + side * (0.06 * first), max(blur, lod)).extinction * first;
    float start = first;
    float stretch = kConeGrowth * first;
    int i = 1;
    if (start < leaves) do {
        if (grid == 2) stretch = min(stretch, leaves - start);  // the last one ends where the clouds do
        float at = start + 0.5 * stretch;
        float angle = 2.39996 * float(i);  // the golden angle strews them round the cone
        vec3 sideways = (side * cos(angle) + other * sin(angle)) * (0.12 * at);
        sum += cloudOf(bits, p + toward * at + sideways, kCoarseLod).extinction * stretch;
        start += stretch;
        stretch *= kConeGrowth;
        ++i;
    } while (i < 6 && start < leaves && sum < kDeepest);
    if (grid < 2) sum += griddedDepth(grid, p + toward * start, onPlane);
    return min(sum, kDeepest);
}
#endif
