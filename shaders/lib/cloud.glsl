// The density of clouds: the one function that the march, the shadows, the reference, the plan, and on the CPU the
// visibility in a cloud and the icing ask.
//
// PROBLEM. A report says: so many eighths of cumulus, base here, top there. We want a cloud that covers just that
// share of the ground, with a flat base and cauliflower tops, sharp where it grows, without a map of noise that one
// has to fiddle with until the share looks right.
//
// METHOD. Over every point of the plane stands a rank u, uniform on 0..1 (weather/cloud_pattern). Cloud stands where
// u < cover: the share is right by construction. How far u lies below the cover, the margin, says how far inside the
// outline one is, and so how high the cloud rises there: domes for cumulus, a slab for stratus. That is the envelope, and
// its shape tells, to first order, how many metres a point lies inside it: the height below the top over the steepness of
// the side. Billows of the 3D noise then push the face in by so many metres, cells in cells: round heads with creases
// between, which is what cauliflower is. Fine noise eats at what is left, wisps below and billows above. Metres, not
// shares of a height, so that a small cloud is as rough as a large one. What lies deeper than the edge's softness is
// cloud. A flat base is a face of its own that nothing pushes.
// The density never falls as the margin grows, so a threshold of the rank (weather/cloud_column's table) puts right what
// the noise takes from the cover.
// Perlin-Worley and Worley billows, and the turn from wisps to billows, are Schneider's (GPU Pro 7, chapter 4).
#ifndef LUFTPOST_CLOUD_GLSL
#define LUFTPOST_CLOUD_GLSL
#include "shaders/lib/noise.glsl"
#include "shaders/shared/cloud.glsl.h"
#include "shaders/shared/sampler3d.glsl.h"
GLSL_BEGIN

GLSL_CONST float kCurlPeriod = 2048.0f;   // m, at scale 1: curl, fray
GLSL_CONST float kShapePeriod = 4096.0f;  // m
GLSL_CONST float kDetailPeriod = 512.0f;  // m

// What is found at a point: extinction in 1/m; where there is none, about how far the nearest face is, m; and what the
// light asks for, as optical depths: how deep it lies below the nearest face, how large the cloud is around it, and how
// much of it stands above and below.
struct CloudSample {
    float extinction;
    float outside;
    float depth;
    float bulk;
    float above;
    float below;
};

GLSL_FUNCTION CloudSample noCloud() {
    CloudSample none;
    none.extinction = 0.0f;
    none.outside = 1.0e6f;
    none.depth = 0.0f;
    none.bulk = 0.0f;
    none.above = 0.0f;
    none.below = 0.0f;
    return none;
}

// Curl and fray of the plane: signed, about -1..1.
GLSL_FUNCTION vec4 planeNoise(sampler3D curl, LayerShape s, vec3 p, float lod) {
    float scale = s.anchor.w * (kShapePeriod / kCurlPeriod);
    vec4 v = textureLod(curl, vec3((p.x + s.anchor.x) * scale, (p.z + s.anchor.z) * scale, 0.5f), lod);
    return v * 2.0f - vec4(1.0f);
}

// 0 at an empty and at a closed cover, 1 between: outlines fray only where there are outlines.
GLSL_FUNCTION float frayWindow(float cover) { return clamp(8.0f * cover * (1.0f - cover), 0.0f, 1.0f); }

// How far inside its outline the layer is over a point, in rank: below 0 there is none of it. High up an anvil spreads.
GLSL_FUNCTION float layerMargin(LayerColumn c, LayerShape s, float fray) {
    return c.cover - c.rank + fray * s.look.y * frayWindow(c.cover);
}

// Share of the layer's height that a cloud reaches at a margin: a dome with steep but no upright sides.
GLSL_FUNCTION float riseAt(float margin, float width) {
    float x = 1.0f - clamp(margin / width, 0.0f, 1.0f);
    return 1.0f - x * x;
}

// Optical depth, straight down, of a sheet of fibres.
GLSL_FUNCTION float sheetDepth(vec3 p, LayerColumn c, LayerShape s, sampler3D curl, float lod) {
    float x = p.x + s.anchor.x;
    float z = p.z + s.anchor.z;
    vec4 bend = textureLod(curl, vec3(x * s.fibre.z * 0.31f, z * s.fibre.z * 0.31f, 0.5f), lod) * 2.0f - vec4(1.0f);
    float along = (x * s.fibre.x + z * s.fibre.y) * s.fibre.z + 0.06f * bend.x;
    float across = (z * s.fibre.x - x * s.fibre.y) * s.fibre.w + 0.22f * bend.y;
    float grain = textureLod(curl, vec3(along, across, 0.5f), lod).w * 2.0f - 1.0f;
    float thread = textureLod(curl, vec3(along * 2.0f, across * 3.0f, 0.5f), lod + 1.5f).z * 2.0f - 1.0f;
    float margin = layerMargin(c, s, 0.5f * (grain + thread));
    if (margin <= 0.0f) return 0.0f;
    // A veil that just counts as cover, and in it strands that gather toward the middle.
    float full = c.water * s.look.w * (c.top - c.base);
    float strand = clamp(0.5f + 0.9f * grain + 0.7f * thread, 0.0f, 1.4f);
    float body = smoothstep(0.0f, 1.6f * s.form.x, margin);
    return 0.07f * smoothstep(0.0f, 0.15f, margin) + full * body * mix(0.5f, strand * strand, s.form.y);
}

// The shape volume as one number, 0..1 over the whole of its range: 1 on the billows, 0 in the creases.
GLSL_FUNCTION float billowOf(vec4 noise) {
    return clamp((0.20f * noise.x + 0.32f * noise.y + 0.28f * noise.z + 0.20f * noise.w - 0.25f) * 2.0f, 0.0f, 1.0f);
}

// From this lod on the fine things are left out: fraying of the outlines, and the detail, whose mean is taken.
GLSL_CONST float kCoarseLod = 2.5f;

// The envelope of a layer over a point: heights above its base, m, and the slope of its top against the plane.
struct Envelope {
    float low;
    float high;
    float steep;
};

GLSL_FUNCTION Envelope envelopeAt(float margin, float thickness, float lower, LayerShape s) {
    float x = clamp(1.0f - margin / s.form.x, 0.0f, 2.0f);  // over 1: outside, where the side goes on down
    float rise = (1.0f - x * x) * lower;
    Envelope e;
    e.high = rise * thickness;
    e.low = s.form.y * (1.0f - rise) * thickness;
    e.steep = 2.0f * x * lower * thickness / (s.form.x * s.body.x);
    return e;
}

// Share by which the clouds of a layer stay below its top, each its own, as what is left of the height.
GLSL_FUNCTION float heightShare(vec3 p, LayerShape s, sampler3D curl) {
    if (s.extent.w <= 0.0f) return 1.0f;
    float scale = s.anchor.w * (kShapePeriod / 12288.0f);
    float vary = textureLod(curl, vec3((p.x + s.anchor.x) * scale, (p.z + s.anchor.z) * scale, 0.5f), 1.0f).w;
    return 1.0f - s.extent.w * ramp(vary, 0.7f, 0.3f);
}

// The lesser of two depths, rounded where they are alike to `round` m: faces meet in a shoulder, not in an edge.
GLSL_FUNCTION float roundedMin(float a, float b, float round) {
    float h = max(round - abs(a - b), 0.0f) / round;
    return min(a, b) - 0.25f * round * h * h;
}

// What the fine noise takes from the faces, 0..1: wisps at the base, billows above, as `share` of the height goes from 0
// to a fifth; a quarter of it is four times finer.
GLSL_FUNCTION float fineCarve(vec3 q, LayerShape s, vec4 plane, float share, sampler3D detail, float lod) {
    vec3 turned = (q + vec3(s.detail) - vec3(s.anchor) + 60.0f * vec3(plane.x, 0.0f, plane.y) * (1.0f - share)) * s.detail.w;
    vec4 fine = textureLod(detail, turned, lod);
    float wisps = 0.45f * fine.x + 0.3f * fine.y + 0.25f * fine.z;
    if (lod < 1.0f) {
        vec4 finer = textureLod(detail, turned * 4.0f, lod + 1.0f);
        wisps += (0.22f * finer.x + 0.14f * finer.y - 0.18f) * (1.0f - lod);
    }
    wisps = clamp(1.7f * wisps - 0.35f, 0.0f, 1.0f);
    return mix(wisps, 1.0f - wisps, clamp(share * 5.0f, 0.0f, 1.0f));
}

// One layer at one point. `p`: m east and south from the frame's origin, y above sea level. `lod` 0 is the whole truth;
// at lod n faces are blurred as what is 32 m 2^n wide sees them.
GLSL_FUNCTION CloudSample layerSample(vec3 p, LayerColumn c, LayerShape s, sampler3D shape, sampler3D detail,
                                      sampler3D curl, float lod) {
    float thickness = c.top - c.base;
    float above = p.y - c.base;
    CloudSample result = noCloud();
    if (above <= 0.0f || above >= thickness) return result;
    if (s.look.z > 0.5f) {
        float share = above / thickness;
        result.extinction = sheetDepth(p, c, s, curl, lod) * 6.0f * share * (1.0f - share) / thickness;
        return result;
    }
    float blur = lod > 0.0f ? 16.0f * (exp2(lod) - 1.0f) : 0.0f;  // m; half of it reaches outside
    float reaches = 0.5f * blur;
    result.outside = (c.rank - c.cover - s.look.y - s.body.z) * s.body.x;
    if (result.outside >= reaches) return result;
    vec4 plane = vec4(0.0f);
    if (lod < kCoarseLod) plane = planeNoise(curl, s, p, lod) * clamp(kCoarseLod - lod, 0.0f, 1.0f);
    float margin = layerMargin(c, s, plane.z) + s.body.z * smoothstep(0.62f, 0.92f, above / thickness);
    result.outside = -margin * s.body.x;
    if (result.outside >= reaches) return result;

    // Metres inside the envelope's faces.
    Envelope e = envelopeAt(margin, thickness, heightShare(p, s, curl), s);
    float belowTop = (e.high - above) / sqrt(1.0f + e.steep * e.steep);
    result.outside = -belowTop;
    if (result.outside >= reaches) return result;
    float lens = s.form.y;
    float aboveBase = (above - e.low) / sqrt(1.0f + lens * lens * e.steep * e.steep);

    // What the noise takes from them.
    vec3 q = p + vec3(s.anchor) - vec3(s.wind.z, 0.0f, s.wind.w) * above;
    float reach = min(s.form.z, 0.25f * thickness);
    float carve = reach * (1.0f - billowOf(textureLod(shape, q * s.anchor.w, min(lod, 3.5f))));
    float ripple = min(s.form.w, 0.1f * thickness);
    float soft = min(s.look.x, 0.3f * thickness);
    float baseShare = clamp(3.0f * lens, 0.2f, 1.0f);
    float shoulder = min(120.0f, 0.2f * thickness);
    float inside = roundedMin(belowTop - carve, aboveBase - baseShare * carve, shoulder);
    result.outside = -inside;
    if (result.outside >= reaches) return result;
    float eat = 0.5f;
    if (lod < kCoarseLod && inside < ripple + soft) eat = fineCarve(q, s, plane, above / thickness, detail, lod);
    inside = roundedMin(belowTop - carve - ripple * eat, aboveBase - baseShare * (carve + ripple * eat), shoulder);

    result.outside = max(-inside, 0.0f);
    float edge = clamp((inside + reaches) / (soft + blur), 0.0f, 1.0f);
    if (edge <= 0.0f) return result;
    float full = c.water * s.look.w;
    inside = max(inside, 0.0f);
    result.depth = full * inside;
    result.bulk = full * max(min(e.high - e.low, 2.0f * margin * s.body.x), 0.0f);
    float crease = 0.35f * carve + 0.9f * ripple * eat;  // m, what the billows around stand higher
    result.above = full * (0.8f * max(e.high - above - carve, 0.0f) + crease);
    result.below = full * (0.8f * max(above - e.low, 0.0f) + crease);

    float floorHeight = min(45.0f, 0.1f * thickness);
    float floorSoft = clamp((above - e.low - 0.27f * floorHeight * (1.0f + plane.w)) / floorHeight, 0.0f, 1.0f);
    result.extinction = edge * floorSoft * full * mix(0.55f, 1.1f, above / thickness);
    return result;
}

// Optical depth of one layer's envelope on a straight way through it, `up` the sine of the way's elevation: no noise, so
// cheap; for what is far from the eye. A slanting way passes many clouds and gaps: what gets through nears their mean.
GLSL_FUNCTION float envelopeDepth(LayerColumn c, LayerShape s, float up) {
    float thickness = c.top - c.base;
    float margin = c.cover - c.rank;
    bool sheet = s.look.z > 0.5f;
    float full = 0.6f * c.water * s.look.w * thickness / up;
    float here = margin <= 0.0f ? 0.0f : full * (sheet ? ramp(margin, 0.0f, s.form.x) : riseAt(margin, s.form.x));
    float share = clamp(c.cover, 0.0f, 0.99f);
    float mean = -log(1.0f - share + share * exp(-min(0.7f * full, 40.0f)));
    return mix(here, mean, clamp(thickness * sqrt(1.0f - up * up) / (up * 3000.0f), 0.0f, 1.0f));
}

// Beyond the reach of 3D detail: the mean of many clouds. The rank is then the coarse one, and the share of the ground
// under cloud rises softly where it passes below the cover. A way through clouds of chord k that cover the share c meets
// one every k (1 - c) / c; fewer reach far up.
GLSL_FUNCTION float distantExtinction(float y, LayerColumn c, LayerShape s) {
    float h = (y - c.base) / (c.top - c.base);
    float cover = clamp(c.cover - s.body.y, 0.0f, 1.0f);
    if (h <= 0.0f || h >= 1.0f || cover <= 0.0f) return 0.0f;
    float share = mix(cover, smoothstep(-0.45f, 0.45f, cover - c.rank), min(4.0f * cover * (1.0f - cover), 1.0f));
    float met = share / (1.2f * s.body.x * (1.02f - share));
    float reaching = 1.0f - h * (1.0f - 0.5f * share);
    return min(met * reaching * reaching, 0.3f * c.water * s.look.w);
}

// Extinction of all the clouds at a point, 1/m.
GLSL_FUNCTION float density(vec3 p, CloudColumn c, CloudShape s, sampler3D shape, sampler3D detail, sampler3D curl,
                            float lod) {
    float sum = 0.0f;
    for (int i = 0; i < kCloudLayers; ++i)
        sum += layerSample(p, c.layers[i], s.layers[i], shape, detail, curl, lod).extinction;
    return sum;
}

GLSL_END
#endif
