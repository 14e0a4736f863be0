// What falls from the layers and what light does in it: the block of the pass that draws it. vec4s alone.
#ifndef LUFTPOST_FALLING_GLSL_H
#define LUFTPOST_FALLING_GLSL_H
#include "shaders/shared/block.glsl.h"
#include "shaders/shared/cloud.glsl.h"
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

// What falls from one layer.
struct LayerFall {
    vec4 shower;  // x: root of the rate where its heaviest shower is heaviest, (mm/h)^1/2, 0: none; y: what a drop loses of it, (mm/h)^1/2 per
                  // m2 of squared depth; z: m above sea level, from where on down it loses; w: 1 for a cumulonimbus
    vec4 lag;     // xy: 1/m, east and south: of fallLag
    vec4 root;    // x: that root at the camera; yz: its slope, per m east and south: it rains more on one side
};

struct FallAll {
    vec4 melting;  // x: m above sea level, freezing level; y: liquid share at the ground, 0..1; z: m above sea level, ground;
                   // w: mm/h that the visibility of the air already has in it
};

// A flash of lightning at one moment: light in its cloud, and for some a channel to the ground. Places: m east and south of the camera,
// and above sea level.
struct Stroke {
    vec4 source;   // xyz: middle of the light, where the channel leaves the cloud; w: radiant intensity, sun's irradiance x m2 / sr
    vec4 ground;   // xyz: where the channel ends; w: 1 = there is one
    vec4 form;     // x: what the channel's bends are hashed from, a whole number
};

GLSL_CONST int kMostStrokes = 4;
GLSL_CONST int kFallBlockBinding = 8;
GLSL_CONST int kPhaseUnit = 26;

UNIFORM_BLOCK(FallBlock, 8) {
    LayerFall falls[kCloudLayers];
    FallAll fallAll;
    vec4 optics;                   // x: 1 = something falls; y: m above sea level, altitude over which nothing falls; z: strokes; w: unused
    Stroke strokes[kMostStrokes];
} BLOCK_NAME(falling);

GLSL_END
#endif
