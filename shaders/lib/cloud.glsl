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
// A cumulonimbus is two bodies over one rank: its towers, heaps whose walls lean in, so that a cell reaches as high as it is wide at its
// foot: weak ones end as congestus, strong ones meet the tropopause. There their ice spreads out beyond the cover, an anvil in streaks
// along the wind, thick at the tower and thin at the rim; a cell that does not come so high has next to none. It asks for the rank upwind
// of where it is, at two places, so that it lies downwind of its tower, and long.
// The density never falls as the margin grows, so a threshold of the rank (weather/cloud_column's table) puts right what
// the noise takes from the cover.
// Perlin-Worley and Worley billows, and the turn from wisps to billows, are Schneider's (GPU Pro 7, chapter 4).
#ifndef LUFTPOST_CLOUD_GLSL
#define LUFTPOST_CLOUD_GLSL
#include "shaders/lib/noise.glsl"
#include "shaders/shared/cloud.glsl.h"
#include "shaders/shared/sampler3d.glsl.h"
GLSL_BEGIN

// Whether a layer may have towers and an anvil. They are half of the density's price: passes have a second program without them,
// for skies that hold none (render/cloud_program).
#ifndef CLOUD_TOWERS
#define CLOUD_TOWERS true
#endif
GLSL_FUNCTION bool hasTowers(LayerShape s) { return CLOUD_TOWERS && s.body.z > 0.0f; }

GLSL_CONST float kCurlPeriod = 2048.0f;   // m, at scale 1: curl, fray
GLSL_CONST float kShapePeriod = 4096.0f;  // m
GLSL_CONST float kDetailPeriod = 512.0f;  // m

// What is found at a point: extinction in 1/m; about how far outside the nearest face it lies, m, below 0 inside; and what the
// light asks for, as optical depths: how deep it lies below the nearest face, how wide the cloud around it is in the
// plane, and how much of it stands above and below; and the extinction inside the cloud at that height, 1/m, its soft faces left out.
struct CloudSample {
    float extinction;
    float outside;
    float depth;
    float wide;
    float above;
    float below;
    float core;
};

GLSL_FUNCTION CloudSample noCloud() {
    CloudSample none;
    none.extinction = 0.0f;
    none.outside = 1.0e6f;
    none.depth = 0.0f;
    none.wide = 0.0f;
    none.above = 0.0f;
    none.below = 0.0f;
    none.core = 0.0f;
    return none;
}

// Curl and fray of the plane: signed, about -1..1.
GLSL_FUNCTION vec4 planeNoise(planeSampler curl, LayerShape s, vec3 p, float lod) {
    float scale = s.anchor.w * (kShapePeriod / kCurlPeriod);
    vec4 v = textureLod(curl, vec2((p.x + s.anchor.x) * scale, (p.z + s.anchor.z) * scale), lod);
    return v * 2.0f - vec4(1.0f);
}

// 0 at an empty and at a closed cover, 1 between: outlines fray only where there are outlines.
GLSL_FUNCTION float frayWindow(float cover) { return clamp(8.0f * cover * (1.0f - cover), 0.0f, 1.0f); }

// How far inside its outline the layer is over a point, in rank: below 0 there is none of it.
GLSL_FUNCTION float layerMargin(LayerColumn c, LayerShape s, float fray) {
    return c.cover - c.rank + fray * s.look.y * frayWindow(c.cover);
}

GLSL_CONST float kMostAnvil = 0.45f;  // cover, from which on no more of it is anvil

// By how much of the rank an anvil reaches beyond its towers; the wider its layer's cover, the less of it.
GLSL_FUNCTION float anvilReach(float cover, LayerShape s) { return s.body.z * clamp(cover, 0.0f, kMostAnvil); }

GLSL_CONST float kTowerInset = 2300.0f;  // m, by how much a tower's wall stands further in at its top than at its foot
GLSL_CONST float kTowerTaper = 0.75f;    // the same, of half the width of the widest, at most

// m in the plane from the middle of the strongest storm to where the rank is `rank`: what the pattern's distribution makes of its value,
// turned back. Between two ranks it is the same way in weak storms and strong ones, for they differ in how deep they begin.
GLSL_FUNCTION float stormWay(float rank, LayerShape s) {
    float u = max(rank, 0.0f);
    return s.body.x * (1.7f * sqrt(u) - 0.425f * u + 1.2f * max(u - 0.7f, 0.0f));
}

// The threshold of the rank under which the towers of a layer stand.
GLSL_FUNCTION float towerCover(float cover, LayerShape s) { return cover - anvilReach(cover, s); }

// By how much of the rank the streaks of an anvil reach beyond the outline of what is thick enough to count as cover, at most.
GLSL_FUNCTION float anvilFray(float cover) { return 0.7f * clamp(cover, 0.0f, kMostAnvil) * frayWindow(cover); }

// m by which a tower's wall stands further in at a share of its height than at its foot: a broad foot, steep walls, a dome. What is
// narrow ends low. Where towers are few and narrow, the strongest still reach their full height.
GLSL_FUNCTION float mostInset(float cover, LayerShape s) { return clamp(kTowerTaper * stormWay(cover, s), 300.0f, kTowerInset); }
GLSL_FUNCTION float insetAt(float share, float most) {
    float s = share - 0.5f;
    return most * (0.5f + s * (0.6f + 1.6f * s * s));
}

// Share of the layer's height that a cloud reaches at a margin, where the threshold is `cover`: a dome with steep but no upright sides.
GLSL_FUNCTION float riseAt(float margin, float cover, LayerShape s) {
    if (hasTowers(s)) {
        float x = clamp((stormWay(cover, s) - stormWay(cover - margin, s)) / mostInset(cover, s), 0.0f, 1.0f);
        float past = x - 0.5f;  // insetAt's inverse, by Newton
        for (int i = 0; i < 2; ++i) past -= (past * (0.6f + 1.6f * past * past) - x + 0.5f) / (0.6f + 4.8f * past * past);
        return past + 0.5f;
    }
    float x = 1.0f - clamp(margin / s.form.x, 0.0f, 1.0f);
    return 1.0f - x * x;
}

// Optical depth, straight down, of a sheet of fibres.
GLSL_FUNCTION float sheetDepth(vec3 p, LayerColumn c, LayerShape s, planeSampler curl, float lod) {
    float x = p.x + s.anchor.x;
    float z = p.z + s.anchor.z;
    vec4 bend = textureLod(curl, vec2(x * s.fibre.z * 0.31f, z * s.fibre.z * 0.31f), lod) * 2.0f - vec4(1.0f);
    float along = (x * s.fibre.x + z * s.fibre.y) * s.fibre.z + 0.06f * bend.x;
    float across = (z * s.fibre.x - x * s.fibre.y) * s.fibre.w + 0.22f * bend.y;
    float grain = textureLod(curl, vec2(along, across), lod).w * 2.0f - 1.0f;
    float thread = textureLod(curl, vec2(along * 2.0f, across * 3.0f), lod + 1.5f).z * 2.0f - 1.0f;
    float margin = layerMargin(c, s, 0.5f * (grain + thread));
    if (margin <= 0.0f) return 0.0f;
    // A veil that just counts as cover, and in it strands that gather toward the middle.
    float full = c.water * s.look.w * (c.top - c.base);
    float strand = clamp(0.5f + 0.9f * grain + 0.7f * thread, 0.0f, 1.4f);
    float body = smoothstep(0.0f, 1.6f * s.form.x, margin);
    return 0.07f * smoothstep(0.0f, 0.15f, margin) + full * body * mix(0.5f, strand * strand, s.form.y);
}

// From this lod on the fine things are left out: fraying of the outlines, and the detail, whose mean is taken.
GLSL_CONST float kCoarseLod = 2.5f;

// The envelope of a layer over a point: heights above its base, m, and the slope of its top against the plane.
struct Envelope {
    float low;
    float high;
    float steep;
};

GLSL_FUNCTION Envelope envelopeAt(float margin, float width, float thickness, float lower, LayerShape s) {
    float x = clamp(1.0f - margin / width, 0.0f, 2.0f);  // over 1: outside, where the side goes on down
    float rise = (1.0f - x * x) * lower;
    Envelope e;
    e.high = rise * thickness;
    e.low = s.form.y * (1.0f - rise) * thickness;
    e.steep = 2.0f * x * lower * thickness / (width * s.body.x);
    return e;
}

// Share by which the clouds of a layer stay below its top, each its own, as what is left of the height.
GLSL_FUNCTION float heightShare(vec3 p, LayerShape s, planeSampler curl) {
    if (s.extent.w <= 0.0f) return 1.0f;
    float scale = s.anchor.w * (kShapePeriod / 12288.0f);
    float even = hasTowers(s) ? 3.0f : 1.0f;  // what changes over less than a tower's width would furrow its walls
    float vary = textureLod(curl, vec2((p.x + s.anchor.x) * scale, (p.z + s.anchor.z) * scale), even).w;
    return 1.0f - s.extent.w * ramp(vary, 0.7f, 0.3f);
}

// The lesser of two depths, rounded where they are alike to `round` m: faces meet in a shoulder, not in an edge.
GLSL_FUNCTION float roundedMin(float a, float b, float round) {
    float h = max(round - abs(a - b), 0.0f) / round;
    return min(a, b) - 0.25f * round * h * h;
}

// m of a cloud's full extinction on a way of `m` in from a face where it begins softly, over `soft` m.
GLSL_FUNCTION float softDepth(float m, float soft) { return m < soft ? 0.5f * m * m / soft : m - 0.5f * soft; }
GLSL_CONST float kSoftFace = 0.2f;  // of an edge's softness, what light finds of it

// What the fine noise takes from the faces, 0..1: wisps at the base, billows above, as `share` of the height goes from 0
// to a fifth. What is four times finer is the first to go with the lod.
GLSL_FUNCTION float fineCarve(vec3 q, LayerShape s, vec4 plane, float share, sampler3D detail, float lod) {
    vec3 turned = (q + vec3(s.detail) - vec3(s.anchor) + 60.0f * vec3(plane.x, 0.0f, plane.y) * (1.0f - share)) * s.detail.w;
    float wisps = textureLod(detail, turned, lod + min(lod, 1.0f)).x;
    return mix(wisps, 1.0f - wisps, clamp(share * 5.0f, 0.0f, 1.0f));
}

GLSL_CONST float kTowerRound = 900.0f;   // m, of the shoulder between a tower's wall and its top
GLSL_CONST float kTurrets = 1.0f;        // of a layer's carving, how deep it goes between the turrets of a tower
GLSL_CONST float kKnobs = 0.6f;          // and between the billows on them
GLSL_CONST float kShed = 140.0f;         // m, what is thinner than that beside a tower is none of it
GLSL_CONST float kDeepestCarve = 0.3f;   // of half a tower's width, at most as a layer's carving

// How far outside a point is as far as a step tells; where that is certain, the rest is not asked for. On a processor the function
// ends there; on a GPU, and in software GL, which skips nothing, the rest is worked out all the same and not taken: one by one the
// textures would each be waited for.
#ifdef __cplusplus
#define LEAVE_OUTSIDE(value) result.outside = (value); if (result.outside >= reaches) return result
#else
#define LEAVE_OUTSIDE(value) result.outside = left ? result.outside : (value); left = left || result.outside >= reaches
#endif

// A layer with a body, its anvil apart.
GLSL_FUNCTION CloudSample bodySample(vec3 p, LayerColumn c, LayerShape s, sampler3D shape, sampler3D detail,
                                     planeSampler curl, float lod) {
    float thickness = c.top - c.base;
    float above = p.y - c.base;
    CloudSample result = noCloud();
    LayerColumn towers = c;
    towers.cover = towerCover(c.cover, s);
    float blur = lod > 0.0f ? 16.0f * (exp2(lod) - 1.0f) : 0.0f;  // m; half of it reaches outside
    float reaches = 0.5f * blur;
    bool left = false;
    LEAVE_OUTSIDE((c.rank - towers.cover - s.look.y) * s.body.x);
    vec4 plane = planeNoise(curl, s, p, lod) * clamp(kCoarseLod - lod, 0.0f, 1.0f);
    float margin = layerMargin(towers, s, plane.z);
    LEAVE_OUTSIDE(-margin * s.body.x);

    // Metres inside the envelope's faces.
    float lower = heightShare(p, s, curl);
    Envelope e = envelopeAt(margin, s.form.x, thickness, lower, s);
    float belowTop = (e.high - above) / sqrt(1.0f + e.steep * e.steep);
    float radius = 0.0f;  // m, half the width of a tower at this height
    if (hasTowers(s)) {
        // The wall of a tower is as near as it stands in the plane.
        float top = lower * thickness;
        e.high = top * riseAt(margin, towers.cover, s);
        radius = stormWay(towers.cover, s) - insetAt(min(above / top, 1.0f), mostInset(towers.cover, s));
        belowTop = roundedMin(top + kShed - above, radius - stormWay(towers.cover - margin, s), kTowerRound);
    }
    LEAVE_OUTSIDE(-belowTop);
    float lens = s.form.y;
    float aboveBase = (above - e.low) / sqrt(1.0f + lens * lens * e.steep * e.steep);

    // What the noise takes from them.
    vec3 q = p + vec3(s.anchor) - vec3(s.wind.z, 0.0f, s.wind.w) * above;
    float reach = min(s.form.z, 0.25f * thickness);
    float carve = reach * (1.0f - textureLod(shape, q * s.anchor.w, min(lod, 3.5f)).x);
    if (hasTowers(s)) {  // turrets upon turrets; never so deep that a narrow tower would break into pieces
        float turrets = 1.0f - textureLod(shape, q * (s.anchor.w / 3.0f), max(min(lod, 3.5f) - 1.0f, 0.0f)).x;
        carve = (kKnobs * carve + kTurrets * reach * turrets) * min(kDeepestCarve * radius / reach, 1.0f) + kShed;
    }
    float ripple = min(s.form.w, 0.1f * thickness);
    float soft = min(s.look.x, 0.3f * thickness);
    float baseShare = clamp(3.0f * lens, 0.2f, 1.0f);
    float shoulder = min(120.0f, 0.2f * thickness);
    float inside = roundedMin(belowTop - carve, aboveBase - baseShare * carve, shoulder);
    LEAVE_OUTSIDE(-inside);
    float eat = 0.5f;
    if (!left && lod < kCoarseLod && inside < ripple + soft) eat = fineCarve(q, s, plane, above / thickness, detail, lod);
    inside = roundedMin(belowTop - carve - ripple * eat, aboveBase - baseShare * (carve + ripple * eat), shoulder);

    if (!left) result.outside = -inside;
    float edge = clamp((inside + reaches) / (soft + blur), 0.0f, 1.0f);
    if (left || edge <= 0.0f) return result;
    float full = c.water * s.look.w;
    inside = max(inside, 0.0f);
    float softFace = max(kSoftFace * soft, 1e-3f);
    result.depth = full * softDepth(inside, softFace + kSoftFace * blur);
    // What leaves through its sides its neighbours catch: the more, the more of the sky they cover. A closed layer has no sides.
    float square = towers.cover * towers.cover, open = 1.0f - square * square * square * square;
    result.wide = full * 2.0f * max(margin, 0.0f) * s.body.x / (sqrt(sqrt(sqrt(max(1.0f - towers.cover, 0.02f)))) * max(open, 0.02f));
    result.core = full * mix(0.55f, 1.1f, above / thickness);
    float crease = 0.196f * carve + 0.508f * ripple * eat;  // m, what the billows around stand higher
    result.above = full * (0.8f * softDepth(max(e.high - above - carve, 0.0f), softFace) + crease);
    result.below = full * (0.8f * softDepth(max(above - e.low, 0.0f), softFace) + crease);

    float floorHeight = min(45.0f, 0.1f * thickness);
    float floorSoft = clamp((above - e.low - 0.27f * floorHeight * (1.0f + plane.w)) / floorHeight, 0.0f, 1.0f);
    result.extinction = edge * floorSoft * result.core;
    return result;
}

// ------------------------------------------------------------------------------------------------------- the anvil

// Of the layer's height: where the anvil's underside meets the tower, where it lies beside it, and where its top is. What is
// above are the tops that shoot over.
GLSL_CONST float kAnvilFoot = 0.66f;
GLSL_CONST float kAnvilRim = 0.84f;
GLSL_CONST float kAnvilTop = 0.94f;
GLSL_CONST float kAnvilIce = 0.065f;  // extinction beside the tower, of that in it: 0.15 g/m3 of crystals of 35 um for 1.2 g/m3 of drops of 15 um

// The ways along which streaks can lie so that they repeat with the anchor: (1, 0), (2, 1), (1, 1), (1, 2), and the same a
// quarter turn on. `k`: 0..8, east by south.
GLSL_FUNCTION vec2 latticeWay(int k) {
    int m = k - (k / 4) * 4;
    vec2 way = vec2(m < 3 ? float(1 + (m & 1)) : 1.0f, m < 2 ? float(m) : float(m - 1));
    return (k / 4) % 2 == 0 ? way : vec2(-way.y, way.x);
}

// Streaks of the plane along one of them, -1..1: about 2 km long, and 340 m and 110 m wide.
GLSL_FUNCTION float streaksAlong(vec3 p, int k, LayerShape s, planeSampler curl, float lod) {
    vec2 way = latticeWay(k);
    float unit = s.anchor.w * (1.0f / 3.0f);  // 1/m: the anchor repeats after three periods of the shape
    float x = (p.x + s.anchor.x) * unit;
    float z = (p.z + s.anchor.z) * unit;
    float along = x * way.x + z * way.y;
    float across = z * way.x - x * way.y;
    float narrow = floor(7.0f / length(way) + 0.5f);
    vec4 bend = textureLod(curl, vec2(x, z), max(lod, 2.0f)) * 2.0f - vec4(1.0f);
    float broad = textureLod(curl, vec2(along, across * narrow + 0.04f * bend.y), lod).w;
    float fine = textureLod(curl, vec2(along * 2.0f, across * narrow * 3.0f + 0.06f * bend.x), lod + 1.0f).z;
    return 1.2f * broad + 0.8f * fine - 1.0f;
}

// Streaks along the layer's wind: between two ways of the lattice they pass over from the one to the other.
GLSL_FUNCTION float anvilStreaks(vec3 p, LayerShape s, planeSampler curl, float lod) {
    int k = int(floor(s.body.w));
    float next = smoothstep(0.35f, 0.65f, s.body.w - float(k));
    float streaks = next < 1.0f ? (1.0f - next) * streaksAlong(p, k, s, curl, lod) : 0.0f;
    return next > 0.0f ? streaks + next * streaksAlong(p, k + 1, s, curl, lod) : streaks;
}

// The rank that an anvil has at a place: `near` and `far` are the layer's where its ice came from, LayerShape's fibre.z and all of its
// fibre.xy upwind; `weaker` is its fibre.w.
GLSL_FUNCTION float anvilRank(float near, float far, float weaker) { return roundedMin(near, far + weaker, max(1.6f * weaker, 1e-3f)); }

// How far within an anvil's rim a rank lies: 0 there, 1 where its tower reaches its full height, evenly with the way in the plane.
GLSL_FUNCTION float anvilShare(float rank, float cover, LayerShape s) {
    float rim = stormWay(cover, s);
    float towers = towerCover(cover, s);
    return (rim - stormWay(rank, s)) / max(rim - stormWay(towers, s) + mostInset(towers, s), 1.0f);
}

GLSL_FUNCTION CloudSample anvilSample(vec3 p, LayerColumn c, LayerShape s, sampler3D shape, planeSampler curl, float lod) {
    float thickness = c.top - c.base;
    float above = p.y - c.base;
    CloudSample result = noCloud();
    float blur = lod > 0.0f ? 16.0f * (exp2(lod) - 1.0f) : 0.0f;
    float reaches = 0.5f * blur;
    float fray = anvilFray(c.cover);
    result.outside = max((c.anvil - c.cover - fray) * s.body.x, max(kAnvilFoot * thickness - above, above - kAnvilTop * thickness));
    if (result.outside >= reaches) return result;
    float streaks = anvilStreaks(p, s, curl, max(lod - 0.5f, 0.0f));
    float margin = c.cover - c.anvil + fray * (0.35f + 0.65f * streaks);
    result.outside = -margin * s.body.x;
    if (result.outside >= reaches) return result;

    float near = clamp(anvilShare(c.cover - margin, c.cover, s), 0.0f, 1.0f);
    float level = clamp(anvilShare(c.anvil - 0.35f * fray, c.cover, s), 0.0f, 1.0f);  // without the streaks, which would furrow its rim
    // A wedge under a level top, its underside in soft bags (mamma); it sinks once more where it meets the tower.
    float towers = towerCover(c.cover, s);
    float flare = clamp((stormWay(towers, s) - stormWay(c.rank, s)) / mostInset(towers, s), 0.0f, 1.0f);  // 0 over the rim of its foot
    // The bags are a surface: asked in the plane, they take the same from the cover at whatever height it lies.
    vec3 q = vec3(p.x + s.anchor.x, 0.0f, p.z + s.anchor.z);
    float lumps = 0.012f * streaks + 0.035f * (textureLod(shape, q * (s.anchor.w * (4.0f / 3.0f)), min(lod + 0.5f, 3.5f)).x - 0.5f);
    float high = (kAnvilTop + 0.008f * streaks - 0.015f * (1.0f - level)) * thickness;
    float low = (mix(kAnvilTop - 0.015f, kAnvilRim, level * level) - lumps * (1.0f - flare) - (kAnvilRim - kAnvilFoot) * flare * flare) * thickness;
    float inside = min(above - low, high - above);
    result.outside = -inside;
    if (result.outside >= reaches) return result;
    float soft = 0.02f * thickness;
    float edge = clamp((inside + reaches) / (soft + blur), 0.0f, 1.0f);
    float strand = clamp(1.0f + 0.9f * streaks, 0.0f, 1.7f);
    float ice = c.water * s.look.w * kAnvilIce * near * near * mix(strand, 1.0f, near);
    result.outside = -inside;
    inside = max(inside, 0.0f);
    result.depth = ice * inside;
    result.wide = ice * 2.0f * max(margin, 0.0f) * s.body.x;
    result.above = 0.8f * ice * max(high - above, 0.0f);
    result.below = 0.8f * ice * max(above - low, 0.0f);
    result.core = ice;
    result.extinction = edge * ice;
    return result;
}

// Two bodies at one point.
GLSL_FUNCTION CloudSample together(CloudSample a, CloudSample b) {
    CloudSample sum = a;
    sum.outside = min(a.outside, b.outside);
    if (b.extinction <= 0.0f) return sum;
    float share = b.extinction / (a.extinction + b.extinction);
    sum.depth = max(a.depth, b.depth);
    sum.wide = max(a.wide, b.wide);
    sum.above = mix(a.above, b.above, share);
    sum.below = mix(a.below, b.below, share);
    sum.core = mix(a.core, b.core, share);
    sum.extinction = a.extinction + b.extinction;
    return sum;
}

// A layer with a body at one point. `p`: m east and south from the frame's origin, y above sea level. `lod` 0 is the whole truth;
// at lod n faces are blurred as what is 32 m 2^n wide sees them.
GLSL_FUNCTION CloudSample solidSample(vec3 p, LayerColumn c, LayerShape s, sampler3D shape, sampler3D detail,
                                      planeSampler curl, float lod) {
    float share = (p.y - c.base) / (c.top - c.base);
    if (share <= 0.0f || share >= 1.0f) return noCloud();
    CloudSample result = bodySample(p, c, s, shape, detail, curl, lod);
    if (hasTowers(s)) result = together(result, anvilSample(p, c, s, shape, curl, lod));
    return result;
}

// Any layer at one point, sheets of fibres too.
GLSL_FUNCTION CloudSample layerSample(vec3 p, LayerColumn c, LayerShape s, sampler3D shape, sampler3D detail,
                                      planeSampler curl, float lod) {
    if (s.look.z <= 0.5f) return solidSample(p, c, s, shape, detail, curl, lod);
    CloudSample result = noCloud();
    float thickness = c.top - c.base;
    float share = (p.y - c.base) / thickness;
    if (share > 0.0f && share < 1.0f) result.extinction = sheetDepth(p, c, s, curl, lod) * 6.0f * share * (1.0f - share) / thickness;
    return result;
}

// Optical depth of one layer's envelope on a straight way through it, `up` the sine of the way's elevation: no noise, so
// cheap; for what is far from the eye. A slanting way passes many clouds and gaps: what gets through nears their mean.
GLSL_FUNCTION float envelopeDepth(LayerColumn c, LayerShape s, float up) {
    float thickness = c.top - c.base;
    bool sheet = s.look.z > 0.5f;
    float towers = towerCover(c.cover, s);
    float margin = towers - c.rank;
    float full = 0.6f * c.water * s.look.w * thickness / up;
    float here = margin <= 0.0f ? 0.0f : full * (sheet ? ramp(margin, 0.0f, s.form.x) : riseAt(margin, towers, s));
    float near = hasTowers(s) ? clamp(anvilShare(c.anvil, c.cover, s), 0.0f, 1.0f) : 0.0f;
    here += full * kAnvilIce * (kAnvilTop - kAnvilFoot) * near * near * near;
    float share = clamp(towers, 0.0f, 0.99f);
    float mean = -log(1.0f - share + share * exp(-min(0.7f * full, 40.0f)));
    return mix(here, mean, clamp(thickness * sqrt(1.0f - up * up) / (up * 3000.0f), 0.0f, 1.0f));
}

GLSL_CONST float kFarSoft = 0.2f;   // of the rank, half of what a face is wide
GLSL_CONST float kFarDome = 0.7f;   // share of the height by which tops are domes

// Beyond the reach of 3D detail: the mean of many clouds. The rank is then the coarse one, and the share of the ground
// under cloud rises softly where it passes below the cover. A way through clouds of chord k that cover the share c meets
// one every k (1 - c) / c; the thin ones end lower.
GLSL_FUNCTION float distantExtinction(float y, LayerColumn c, LayerShape s) {
    float h = (y - c.base) / (c.top - c.base);
    float cover = clamp(c.cover - s.body.y, 0.0f, 1.0f);
    if (h <= 0.0f || h >= 1.0f || cover <= 0.0f) return 0.0f;
    float margin = cover - c.rank;
    float parted = min(4.0f * cover * (1.0f - cover), 1.0f);  // a closed layer is not
    float share = mix(cover, smoothstep(-kFarSoft, kFarSoft, margin), parted);
    float met = share / (1.2f * s.body.x * (1.02f - share));
    float x = 1.0f - clamp((margin + kFarSoft) / (s.form.x + kFarSoft), 0.0f, 1.0f);
    float reaching = clamp(4.0f * (1.0f - kFarDome * parted * x * x - h), 0.0f, 1.0f);
    return min(met * reaching, 0.3f * c.water * s.look.w);
}

// Extinction of all the clouds at a point, 1/m.
GLSL_FUNCTION float density(vec3 p, CloudColumn c, CloudShape s, sampler3D shape, sampler3D detail, planeSampler curl,
                            float lod) {
    float sum = 0.0f;
    for (int i = 0; i < kCloudLayers; ++i)
        sum += layerSample(p, c.layers[i], s.layers[i], shape, detail, curl, lod).extinction;
    return sum;
}

GLSL_END
#endif
