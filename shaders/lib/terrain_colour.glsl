// The land's colour from metres to ranges: linear albedo whose luminances are those of real ground (meadow 0.2, forest
// 0.12, rock 0.25, snow 0.8). Every structure fades into its mean before it is finer than a pixel.
#ifndef LUFTPOST_TERRAIN_COLOUR_GLSL
#define LUFTPOST_TERRAIN_COLOUR_GLSL
#include "shaders/lib/terrain_cover.glsl"
GLSL_BEGIN

/// 1 while `size` metres span more than one and a half pixels of `footprint` metres, 0 once they are less than 0.7.
GLSL_FUNCTION float visibleShare(float size, float footprint) { return clamp(1.4f * size / max(footprint, 1e-3f) - 1.0f, 0.0f, 1.0f); }

/// Noise of 2^k metres, faded out before it aliases, and not computed when it would not show.
GLSL_FUNCTION float detailNoise(ivec2 origin, vec2 offset, int k, uint seed, float footprint) {
    float share = visibleShare(0.5f * float(1 << k), footprint);
    return share > 0.0f ? share * landNoise(origin, offset, k, seed) : 0.0f;
}

/// Where a point lies in the patchwork of fields: quarters of about a kilometre, each with its own direction, cut into
/// strips and those into parcels; all bend with the land. Roads run between quarters, hedges along some parcels.
struct FieldPlace {
    float along;     // m along the parcel's rows
    float border;    // m to the next parcel
    float road;      // m to the middle of a road, 1000 where there is none
    uint crop;       // hash of the parcel
    bool hedged;     // the border beside it carries a hedge
};

GLSL_FUNCTION FieldPlace fieldPlace(LandPoint p, LandCover cover) {
    vec2 bent = p.offset + vec2(170.0f * cover.bend + 70.0f * cover.patchy, 85.0f * cover.patchy - 120.0f * cover.bend) +
                vec2(9.0f, -7.0f) * cover.middling;
    LandCell quarter = landCell(p.origin, bent, 10);
    uint h = landCellHash(quarter.x, quarter.y, 21u);
    float turn = lowShare(h);
    vec2 along = normalize(vec2(1.0f - turn, turn + 0.15f));
    float x = (quarter.fx - 0.5f) * 1024.0f;
    float y = (quarter.fy - 0.5f) * 1024.0f;
    float q = x * along.x + y * along.y + 700.0f;
    float r = y * along.x - x * along.y + 700.0f;
    // Some quarters are cut into narrow strips, some into large parcels.
    float coarse = 0.55f + 1.1f * lowShare(landHash(h + 5u));
    float depth = (80.0f + 150.0f * highShare(h)) * coarse;
    float strip = floor(r / depth);
    uint stripHash = landHash(h + uint(int(strip)) * 0x9e3779b1u);
    float width = (70.0f + 260.0f * lowShare(stripHash)) * coarse;
    float shifted = q + 300.0f * highShare(stripHash);
    float parcel = floor(shifted / width);
    float edgeX = width * (0.5f - abs(shifted / width - parcel - 0.5f));
    float edgeY = depth * (0.5f - abs(r / depth - strip - 0.5f));
    float toQuarter = 1024.0f * (0.5f - max(abs(quarter.fx - 0.5f), abs(quarter.fy - 0.5f)));
    FieldPlace place;
    place.along = q;
    place.crop = landHash(stripHash + uint(int(parcel)) * 0x85ebca77u);
    place.border = min(min(edgeX, edgeY), toQuarter);
    // A border belongs to the cell on its far side too: its hedge and road are told by the grid line.
    int column = quarter.x + (quarter.fx > 0.5f ? 1 : 0);
    int row = quarter.y + (quarter.fy > 0.5f ? 1 : 0);
    bool eastWest = abs(quarter.fy - 0.5f) > abs(quarter.fx - 0.5f);
    uint line = eastWest ? landCellHash(quarter.x, row, 22u) : landCellHash(column, quarter.y, 23u);
    place.road = lowShare(line) < 0.6f ? toQuarter : 1000.0f;
    place.hedged = toQuarter < min(edgeX, edgeY) ? lowShare(line) > 0.75f : highShare(landHash(stripHash + 3u)) < (edgeY < edgeX ? 0.45f : 0.15f);
    return place;
}

GLSL_CONST float kHedgeWidth = 2.5f;  // m, half
GLSL_CONST float kRoadWidth = 2.6f;   // m, half

/// Albedo of fields with their hedges and roads.
GLSL_FUNCTION vec3 fieldColour(FieldPlace place, LandCover cover, float fine, float footprint) {
    vec3 pasture = vec3(0.140f, 0.180f, 0.068f);
    // What is grown goes with the soil: whole tracts of pasture, others of corn.
    float kind = lowShare(place.crop) + 0.30f * cover.bend - 0.35f * (cover.moisture - 0.55f);
    vec3 colour = pasture;
    if (kind > 0.45f) colour = vec3(0.190f, 0.205f, 0.085f);  // mown hay
    if (kind > 0.62f) colour = vec3(0.265f, 0.235f, 0.120f);  // ripening corn
    if (kind > 0.78f) colour = vec3(0.115f, 0.165f, 0.060f);  // maize, beet
    if (kind > 0.92f) colour = vec3(0.148f, 0.134f, 0.090f);  // ploughed
    colour = colour * (0.88f + 0.24f * highShare(place.crop)) * (1.0f + 0.07f * cover.middling);
    // Rows of the plough and of the mower.
    float rows = visibleShare(1.5f, footprint);
    if (rows > 0.0f) colour = colour * (1.0f + 0.09f * rows * sin(place.along * 2.1f + 6.0f * kind));
    colour = colour * (1.0f + 0.22f * fine);
    float half_ = 0.5f * max(footprint, 0.5f);
    float strip = 1.0f - clamp((place.border - 0.6f) / max(1.0f, footprint), 0.0f, 1.0f);  // a grass verge
    colour = mix(colour, pasture * 0.9f, 0.6f * strip * clamp(3.0f / max(footprint, 1.0f), 0.0f, 1.0f));
    float hedge = place.hedged ? clamp((kHedgeWidth + half_ - place.border) / (2.0f * half_), 0.0f, 1.0f) * min(2.0f * kHedgeWidth / (2.0f * half_), 1.0f) : 0.0f;
    colour = mix(colour, vec3(0.055f, 0.085f, 0.032f) * (1.0f + 0.3f * fine), 0.9f * hedge);
    float road = clamp((kRoadWidth + half_ - place.road) / (2.0f * half_), 0.0f, 1.0f) * min(kRoadWidth / half_, 1.0f);
    colour = mix(colour, vec3(0.215f, 0.205f, 0.190f), 0.85f * road);
    float whole = visibleShare(110.0f, footprint);
    return mix(vec3(0.170f, 0.195f, 0.078f) * (1.0f + 0.10f * cover.middling), colour, whole);
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
    vec3 lush = vec3(0.128f, 0.176f, 0.062f);
    vec3 dry = vec3(0.245f, 0.225f, 0.120f);
    float dryness = clamp(0.75f - cover.moisture + 0.30f * cover.middling + 0.12f * spots + 0.25f * landRamp(1500.0f, 2100.0f, p.altitude), 0.0f, 1.0f);
    vec3 colour = mix(lush, dry, clamp(dryness + 0.25f * fine, 0.0f, 1.0f)) * (1.0f + 0.30f * fine);
    result.bump = 0.10f;
    if (cover.fields > 0.01f) {
        colour = mix(colour, fieldColour(fieldPlace(p, cover), cover, fine, footprint), cover.fields);
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
    float ledges = detailNoise(p.origin, vec2(p.offset.x * 0.2f, 2.0f * p.altitude + 0.2f * p.offset.y), 6, 38u, 1.3f * footprint);
    vec3 rock = mix(vec3(0.250f, 0.235f, 0.215f), vec3(0.330f, 0.310f, 0.275f), 0.5f + 0.5f * cover.middling) * (1.0f + 0.30f * fine + 0.30f * banks + 0.35f * broken);
    // Its edge is broken at every scale that shows: ribs and ledges, not a veil.
    float ragged = 0.45f * broken + 0.40f * spots + 0.30f * clumps + 0.35f * banks;
    float bare = landRamp(0.32f, 0.62f, cover.rock + 0.8f * ragged * clamp(4.0f * cover.rock * (1.0f - cover.rock) + 0.15f * cover.rock, 0.0f, 1.0f));
    rock = rock * (1.0f + 0.35f * clamp(ledges, -1.0f, 1.0f));
    colour = mix(colour, rock, bare);
    result.bump = mix(result.bump, 0.85f, bare);
    vec3 sand = vec3(0.320f, 0.285f, 0.215f) * (1.0f + 0.15f * fine);
    colour = mix(colour, sand, cover.sand);
    float drift = 0.5f * broken + 0.4f * spots + 0.3f * clumps + 0.2f * tufts;
    float snow = landRamp(0.30f, 0.62f, cover.snow + 0.9f * drift * clamp(4.0f * cover.snow * (1.0f - cover.snow), 0.0f, 1.0f) - 0.5f * bare * (1.0f - cover.snow));
    snow = snow * (1.0f - 0.62f * wooded);  // it falls through the crowns, and off them
    colour = mix(colour, kSnowAlbedo * (1.0f + 0.03f * fine), snow);
    result.bump = mix(result.bump, 0.08f, snow);
    result.canopy = result.canopy * (1.0f - snow);
    result.gloss = 0.25f * (1.0f - wooded) + 0.35f * cover.rock;
    result.albedo = max(colour, vec3(0.015f));
    return result;
}

GLSL_END
#endif
