// The density of clouds: the one function that the march, the shadows, the reference, the plan, and on the CPU the
// visibility in a cloud and the icing ask.
//
// PROBLEM. A report says: so many eighths of cumulus, base here, top there. We want a cloud that covers just that
// share of the ground, with a flat base and cauliflower tops, sharp where it grows, without a map of noise that one
// has to fiddle with until the share looks right.
//
// METHOD. Over every point of the plane stands a rank u, uniform on 0..1 (weather/cloud_pattern). Cloud stands where
// u < cover: the share is right by construction. How far u lies below the cover, the margin, says how far inside the
// outline one is, and so how high the cloud rises there: domes for cumulus, a slab for stratus. Inside that envelope
// f falls from 1 at the base to 0 at the top; 3D noise takes its share from f, much near the top and the sides, where
// f is small, and nothing from the base, so a column may be thinned but is never carved through. What is left of f,
// against the softness of the genus, is the density.
// The remapping of billows by Perlin-Worley noise and the turn from wisps at the base to billows above are Schneider's
// (GPU Pro 7, chapter 4).
#ifndef LUFTPOST_CLOUD_GLSL
#define LUFTPOST_CLOUD_GLSL
#include "shaders/lib/noise.glsl"
#include "shaders/shared/cloud.glsl.h"
#include "shaders/shared/sampler3d.glsl.h"
GLSL_BEGIN

GLSL_CONST float kCurlPeriod = 2048.0f;   // m, at scale 1: curl, fray
GLSL_CONST float kShapePeriod = 4096.0f;  // m
GLSL_CONST float kDetailPeriod = 512.0f;  // m

// What is found at a point: extinction in 1/m, and what the light asks for: how deep in the cloud it lies, as optical
// depth to the nearest face, and how much cloud of the envelope stands above and below, as optical depth.
struct CloudSample {
    float extinction;
    float depth;
    float above;
    float below;
};

GLSL_FUNCTION CloudSample noCloud() {
    CloudSample none;
    none.extinction = 0.0f;
    none.depth = 0.0f;
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

// How far inside its outline the layer is over a point, in rank: below 0 there is none of it.
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
    float along = (x * s.fibre.x + z * s.fibre.y) * s.fibre.z + 0.045f * bend.x;
    float across = (z * s.fibre.x - x * s.fibre.y) * s.fibre.w + 0.10f * bend.y;
    float grain = textureLod(curl, vec3(along, across, 0.5f), lod).w * 2.0f - 1.0f;
    float thread = textureLod(curl, vec3(along * 2.0f, across * 3.0f, 0.5f), lod + 1.5f).z * 2.0f - 1.0f;
    float margin = layerMargin(c, s, grain);
    if (margin <= 0.0f) return 0.0f;
    float full = c.water * s.look.w * (c.top - c.base);
    float strand = clamp(0.5f + 0.8f * grain + 0.6f * thread, 0.05f, 1.5f);
    float body = ramp(margin, 0.0f, s.form.x);
    return 0.055f * ramp(margin, 0.0f, 0.03f) + full * body * body * strand;
}

// The shape volume as one number, 0..1 over the whole of its range: 1 on the billows, 0 in the creases.
GLSL_FUNCTION float billowOf(vec4 noise) {
    return clamp((0.30f * noise.x + 0.22f * noise.y + 0.26f * noise.z + 0.22f * noise.w - 0.30f) * 2.4f, 0.0f, 1.0f);
}

// From this lod on the fine things are left out: fraying of the outlines, and the detail, whose mean is taken.
GLSL_CONST float kCoarseLod = 2.5f;

// One layer at one point. `p`: m east and south from the frame's origin, y above sea level. `lod` 0 is the whole truth.
GLSL_FUNCTION CloudSample layerSample(vec3 p, LayerColumn c, LayerShape s, sampler3D shape, sampler3D detail,
                                      sampler3D curl, float lod) {
    float thickness = c.top - c.base;
    float above = p.y - c.base;
    CloudSample result = noCloud();
    if (above <= 0.0f || above >= thickness || c.cover - c.rank + s.look.y <= 0.0f) return result;
    if (s.look.z > 0.5f) {
        float share = above / thickness;
        result.extinction = sheetDepth(p, c, s, curl, lod) * 6.0f * share * (1.0f - share) / thickness;
        return result;
    }
    vec4 plane = vec4(0.0f);
    if (lod < kCoarseLod) plane = planeNoise(curl, s, p, lod);
    float margin = layerMargin(c, s, plane.z);
    if (margin <= 0.0f) return result;

    // Billows: strong toward the top and the sides, none at the base.
    vec3 q = p + vec3(s.anchor) - vec3(s.wind.z, 0.0f, s.wind.w) * above;
    float billow = billowOf(textureLod(shape, q * s.anchor.w, min(lod, 3.0f)));
    float lift = smoothstep(0.0f, 260.0f, above);

    // The envelope: between which heights cloud may stand here. Billows push its sides in and out; clouds of a layer are
    // not all of one height.
    float rise = riseAt(max(margin + 0.7f * s.form.x * s.form.z * (billow - 0.6f) * lift, 0.0f), s.form.x);
    if (s.extent.w > 0.0f) {
        float scale = s.anchor.w * (kShapePeriod / 12288.0f);
        float vary = textureLod(curl, vec3((p.x + s.anchor.x) * scale, (p.z + s.anchor.z) * scale, 0.5f), 1.0f).w;
        rise *= 1.0f - s.extent.w * ramp(vary, 0.7f, 0.3f);
    }
    float least = min(45.0f / thickness, 1.0f);
    float low = s.form.y * (1.0f - rise);
    float high = min(max(max(rise, least), low + least), 1.0f);
    float h = above / thickness;
    float within = (h - low) / (high - low);
    if (within <= 0.0f || within >= 1.0f) return result;

    float guard = smoothstep(0.0f, 0.35f, within);
    float f = 1.0f - within - s.form.z * (1.0f - billow) * guard;
    if (f <= 0.0f) return result;
    // Edges: wisps below, billows above. The nearer a face, the more they take.
    float eat = 0.45f;
    if (lod < kCoarseLod && f < 0.5f) {
        vec3 turned = q + vec3(s.detail) - vec3(s.anchor) + 60.0f * vec3(plane.x, 0.0f, plane.y) * (1.0f - within);
        vec4 fine = textureLod(detail, turned * s.detail.w, lod);
        float wisps = 0.5f * fine.x + 0.3f * fine.y + 0.2f * fine.z;
        eat = mix(wisps, 1.0f - wisps, clamp(within * 4.0f, 0.0f, 1.0f));
    }
    f -= s.form.w * eat * guard * (1.0f - clamp(2.0f * f, 0.0f, 1.0f));
    float edge = clamp(f / s.look.x, 0.0f, 1.0f);
    if (edge <= 0.0f) return result;
    float full = c.water * s.look.w;
    float tall = (high - low) * thickness;
    result.depth = full * min(f, 0.5f * rise) * tall;
    result.above = full * max(1.0f - s.form.z * 0.4f - within, 0.0f) * tall;
    result.below = full * within * tall;

    float floorSoft = clamp((above - low * thickness - 12.0f * (1.0f + plane.w)) / 45.0f, 0.0f, 1.0f);
    result.extinction = edge * floorSoft * full * mix(0.55f, 1.1f, h);
    return result;
}

// Optical depth, straight down, of one layer's envelope over a point: no noise, so cheap; for what is far from the eye.
GLSL_FUNCTION float envelopeDepth(LayerColumn c, LayerShape s) {
    float margin = c.cover - c.rank;
    if (margin <= 0.0f) return 0.0f;
    float thickness = c.top - c.base;
    return 0.6f * c.water * s.look.w * thickness * (s.look.z > 0.5f ? ramp(margin, 0.0f, s.form.x) : riseAt(margin, s.form.x));
}

// Beyond the reach of 3D detail: mean cover and optical depth. The rank is then the coarse one, and the share of the
// ground under cloud rises softly where it passes below the cover.
GLSL_FUNCTION float distantExtinction(float y, LayerColumn c, LayerShape s) {
    float thickness = c.top - c.base;
    float h = (y - c.base) / thickness;
    if (h <= 0.0f || h >= 1.0f) return 0.0f;
    float share = smoothstep(-0.4f, 0.4f, c.cover - c.rank) * clamp(8.0f * c.cover, 0.0f, 1.0f);
    return 0.08f * share * share * c.water * s.look.w * clamp(4.0f * h, 0.0f, 1.0f) * (1.0f - h * (1.0f - share));
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
