// What grows or lies where: one answer for the land's colour (GLSL) and for where trees stand (C++).
#ifndef LUFTPOST_TERRAIN_COVER_GLSL
#define LUFTPOST_TERRAIN_COVER_GLSL
#include "shaders/shared/language.glsl.h"
#include "shaders/lib/terrain_noise.glsl"
GLSL_BEGIN

/// Where a point lies. `origin` + `offset` metres east and north; heights in metres.
struct LandPoint {
    ivec2 origin;
    vec2 offset;
    float altitude;     // above sea level
    float aboveWater;   // above the lakes' level
    float flatness;     // the normal's upward part
    float sunward;      // the normal's southward part: snow melts there first
    float clearing;     // m outside the home airfield's grounds, 0 within: nothing tall grows there
    float snowLine;     // m above sea level
};

GLSL_CONST vec3 kSnowAlbedo = vec3(0.780f, 0.805f, 0.850f);

/// Shares 0..1; each covers what comes before it in this order: meadow, fields, forest, rock, sand, snow.
struct LandCover {
    float fields, forest, rock, sand, snow;
    float moisture;     // 0 dry .. 1 lush
    float middling;     // noise of 2^7 m, -1..1, for whoever shades
    float patchy;       // noise of 2^9 m
    float bend;         // slow noise, -1..1, that lets straight things follow the land
};

GLSL_FUNCTION float landRamp(float from, float to, float x) {
    float t = clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

GLSL_CONST float kTreeLine = 1750.0f;  // m above sea level

/// `footprint`: metres that one answer stands for; smaller structure is left out.
GLSL_FUNCTION LandCover landCover(LandPoint p, float footprint) {
    float broad = landNoise(p.origin, p.offset, 13, 11u);
    float wide = landNoise(p.origin, p.offset, 11, 12u);
    float patchy = landNoise(p.origin, p.offset, 9, 13u);
    float middling = footprint < 256.0f ? landNoise(p.origin, p.offset, 7, 14u) * (1.0f - landRamp(64.0f, 256.0f, footprint)) : 0.0f;
    float steep = 1.0f - p.flatness;
    LandCover cover;
    cover.middling = middling;
    cover.patchy = patchy;
    cover.bend = wide;
    cover.moisture = clamp(0.55f + 0.45f * broad + 0.15f * wide - 0.00015f * p.aboveWater, 0.0f, 1.0f);
    // Woods: on slopes too steep to plough, in patches on the flat, up to the tree line.
    float treeLine = kTreeLine + 160.0f * wide + 70.0f * patchy;
    float wooded = 0.62f * wide + 0.55f * patchy + 0.30f * middling + 0.7f * landRamp(0.008f, 0.05f, steep) + 0.5f * (cover.moisture - 0.62f);
    cover.forest = landRamp(0.155f, 0.205f, wooded) * (1.0f - landRamp(treeLine - 120.0f, treeLine + 20.0f, p.altitude)) *
                   (1.0f - landRamp(0.24f, 0.33f, steep)) * landRamp(1.5f, 4.0f, p.aboveWater) * landRamp(120.0f, 260.0f, p.clearing);
    cover.fields = (1.0f - landRamp(0.006f, 0.014f, steep + 0.002f * middling)) * (1.0f - landRamp(850.0f, 1100.0f, p.altitude + 120.0f * wide)) *
                   landRamp(3.0f, 8.0f, p.aboveWater + 3.0f * patchy) * landRamp(100.0f, 220.0f, p.clearing);
    float crag = steep + 0.05f * middling + 0.035f * patchy + 0.06f * landRamp(1500.0f, 2300.0f, p.altitude);
    cover.rock = landRamp(0.215f, 0.30f, crag);
    cover.sand = 1.0f - landRamp(0.3f, 1.0f, p.aboveWater + 0.35f * middling);
    float snowFrom = p.snowLine + 130.0f * wide + 60.0f * patchy + 25.0f * middling + 260.0f * p.sunward;
    cover.snow = landRamp(snowFrom - 60.0f, snowFrom + 160.0f, p.altitude) * (1.0f - landRamp(0.30f, 0.42f, steep + 0.04f * middling));
    return cover;
}

GLSL_END
#endif
