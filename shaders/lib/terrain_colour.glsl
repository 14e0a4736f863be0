// The land's colour from metres to ranges: linear albedo whose luminances are those of real ground (meadow 0.2, forest
// 0.12, rock 0.25, snow 0.8). Every structure fades into its mean before it is finer than a pixel.
#ifndef LUFTPOST_TERRAIN_COLOUR_GLSL
#define LUFTPOST_TERRAIN_COLOUR_GLSL
#include "shaders/lib/terrain_cover.glsl"
GLSL_BEGIN

/// 1 while `size` metres span more than two pixels of `footprint` metres, 0 once they are less than one.
GLSL_FUNCTION float visibleShare(float size, float footprint) { return clamp(size / max(footprint, 1e-3f) - 1.0f, 0.0f, 1.0f); }

/// Noise of 2^k metres, faded out before it aliases, and not computed when it would not show.
GLSL_FUNCTION float detailNoise(ivec2 origin, vec2 offset, int k, uint seed, float footprint) {
    float share = visibleShare(0.5f * float(1 << k), footprint);
    return share > 0.0f ? share * landNoise(origin, offset, k, seed) : 0.0f;
}

/// The patchwork of fields: quarters of about a kilometre, each with its own direction, cut into strips and parcels.
/// rgb: albedo; a: 1 on a hedge, track or ditch between parcels.
GLSL_FUNCTION vec4 fieldColour(LandPoint p, float bend, float footprint) {
    LandCell quarter = landCell(p.origin, p.offset + vec2(170.0f * bend, -120.0f * bend), 10);
    uint h = landCellHash(quarter.x, quarter.y, 21u);
    float turn = lowShare(h);
    vec2 along = normalize(vec2(1.0f - turn, turn + 0.15f));
    float x = (quarter.fx - 0.5f) * 1024.0f;
    float y = (quarter.fy - 0.5f) * 1024.0f;
    float q = x * along.x + y * along.y + 700.0f;
    float r = y * along.x - x * along.y + 700.0f;
    float depth = 110.0f + 130.0f * highShare(h);
    float strip = floor(r / depth);
    uint stripHash = landHash(h + uint(int(strip)) * 0x9e3779b1u);
    float width = 60.0f + 190.0f * lowShare(stripHash);
    float shifted = q + 300.0f * highShare(stripHash);
    float parcel = floor(shifted / width);
    uint crop = landHash(stripHash + uint(int(parcel)) * 0x85ebca77u);
    float kind = lowShare(crop);
    vec3 colour = vec3(0.150f, 0.225f, 0.070f);                      // pasture
    if (kind > 0.42f) colour = vec3(0.205f, 0.240f, 0.085f);         // mown hay
    if (kind > 0.58f) colour = vec3(0.340f, 0.285f, 0.130f);         // ripe corn
    if (kind > 0.76f) colour = vec3(0.105f, 0.180f, 0.055f);         // maize, beet
    if (kind > 0.88f) colour = vec3(0.190f, 0.145f, 0.095f);         // ploughed
    colour = colour * (0.86f + 0.28f * highShare(crop));
    float edgeX = width * (0.5f - abs(shifted / width - parcel - 0.5f));
    float edgeY = depth * (0.5f - abs(r / depth - strip - 0.5f));
    float border = min(min(edgeX, edgeY), 1024.0f * (0.5f - max(abs(quarter.fx - 0.5f), abs(quarter.fy - 0.5f))));
    float line = (1.0f - clamp((border - 2.0f) / max(1.5f, footprint), 0.0f, 1.0f)) * clamp(5.0f / max(footprint, 1.0f), 0.0f, 1.0f);
    // Rows of the plough and of the mower.
    float rows = visibleShare(2.5f, footprint);
    if (rows > 0.0f) colour = colour * (1.0f + 0.10f * rows * sin(q * 1.2f + 6.0f * kind));
    float whole = visibleShare(150.0f, footprint);
    return vec4(mix(vec3(0.190f, 0.225f, 0.085f), colour, whole), line * whole);
}

struct LandColour {
    vec3 albedo;
    float bump;       // how much the fine relief tilts the normal
    float canopy;     // share of tree crowns
    float gloss;      // how much of a mirror it is when wet, 0..1
};

GLSL_FUNCTION LandColour landColour(LandPoint p, LandCover cover, float footprint) {
    float tufts = detailNoise(p.origin, p.offset, 1, 31u, footprint);
    float clumps = detailNoise(p.origin, p.offset, 3, 32u, footprint);
    float spots = detailNoise(p.origin, p.offset, 5, 33u, footprint);
    float broken = detailNoise(p.origin, p.offset, 6, 36u, footprint);
    // Half a metre: the same noise on a map four times as large.
    float blades = visibleShare(0.25f, footprint);
    if (blades > 0.0f) blades = blades * landNoise(ivec2(p.origin.x * 4, p.origin.y * 4), p.offset * 4.0f, 1, 37u);
    float fine = 0.45f * blades + 0.45f * tufts + 0.35f * clumps + 0.35f * spots;
    LandColour result;
    // Meadow, lush to dry, and paler alpine grass above the trees.
    vec3 lush = vec3(0.125f, 0.220f, 0.060f);
    vec3 dry = vec3(0.270f, 0.245f, 0.120f);
    float dryness = clamp(0.75f - cover.moisture + 0.30f * cover.middling + 0.12f * spots + 0.25f * landRamp(1500.0f, 2100.0f, p.altitude), 0.0f, 1.0f);
    vec3 colour = mix(lush, dry, dryness) * (1.0f + 0.22f * fine);
    result.bump = 0.10f;
    if (cover.fields > 0.01f) {
        vec4 field = fieldColour(p, cover.bend, footprint);
        vec3 fieldFace = mix(field.rgb * (1.0f + 0.12f * fine), vec3(0.060f, 0.100f, 0.035f), field.a * 0.85f);
        colour = mix(colour, fieldFace, cover.fields);
    }
    // Forest seen as a canopy: crowns 8 m across, light tops and dark gaps.
    float crowns = detailNoise(p.origin, p.offset, 3, 34u, footprint);
    float conifers = landRamp(500.0f, 1200.0f, p.altitude + 300.0f * cover.middling);
    vec3 canopy = mix(vec3(0.088f, 0.142f, 0.042f), vec3(0.050f, 0.095f, 0.045f), conifers) *
                  (1.0f + 0.55f * crowns + 0.30f * clumps + 0.28f * spots + 0.30f * broken + 0.16f * cover.middling);
    float wooded = clamp(cover.forest + (0.9f * spots + 0.7f * broken) * cover.forest * (1.0f - cover.forest) * 4.0f, 0.0f, 1.0f);
    colour = mix(colour, canopy, wooded);
    result.canopy = wooded;
    result.bump = mix(result.bump, 0.55f, wooded);
    // Rock in banks, scree below, grass on its ledges.
    float banks = detailNoise(p.origin, vec2(p.offset.x * 0.15f, p.altitude + 0.3f * p.offset.y), 4, 35u, footprint);
    vec3 rock = mix(vec3(0.250f, 0.235f, 0.215f), vec3(0.330f, 0.310f, 0.275f), 0.5f + 0.5f * cover.middling) * (1.0f + 0.30f * fine + 0.30f * banks + 0.35f * broken);
    colour = mix(colour, rock, cover.rock);
    result.bump = mix(result.bump, 0.45f, cover.rock);
    vec3 sand = vec3(0.320f, 0.285f, 0.215f) * (1.0f + 0.15f * fine);
    colour = mix(colour, sand, cover.sand);
    float snow = clamp(cover.snow + 0.35f * fine * cover.snow * (1.0f - cover.snow) * 4.0f, 0.0f, 1.0f);
    colour = mix(colour, vec3(0.780f, 0.805f, 0.850f) * (1.0f + 0.03f * fine), snow);
    result.bump = mix(result.bump, 0.08f, snow);
    result.canopy = result.canopy * (1.0f - snow);
    result.gloss = 0.25f * (1.0f - wooded) + 0.35f * cover.rock;
    result.albedo = max(colour, vec3(0.015f));
    return result;
}

GLSL_END
#endif
