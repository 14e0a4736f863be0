// Clouds as C++ and GLSL share them: what stands over a point, what a layer looks like, and the block of the passes.
// Metres above sea level, 1/m, kg/m3. The structs of the block hold vec4s alone: std140 and C++ lay them out alike.
#ifndef LUFTPOST_CLOUD_GLSL_H
#define LUFTPOST_CLOUD_GLSL_H
#include "shaders/shared/block.glsl.h"
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_CONST int kCloudLayers = 4;

// One layer over one point.
struct LayerColumn {
    float rank;   // u, 0..1: cloud where it is below `cover`
    float cover;  // the threshold of the rank: the layer's cover, calibrated (weather/cloud_column)
    float base;
    float top;
    float water;  // kg/m3 in the core
    float anvil;  // the rank of which its anvil is made: lib/cloud's anvilRank, where there is an anvil
};

// What stands over one point. Layers beyond the weather's have cover -1 and no extent.
struct CloudColumn {
    LayerColumn layers[kCloudLayers];
    float rain;   // mm/h on the ground below
};

// What a layer looks like, wherever it stands: its genus' form, and where its noise lies.
struct LayerShape {
    vec4 form;    // x: margin of the rank at which a top reaches full height; y: share by which thin parts rise from the
                  // base, of a sheet how far strands stand out of its veil, 0..1; z: m, how far billows push the faces in; w: m, how far the detail does
    vec4 look;    // x: m, softness of edges; y: fraying of outlines in rank; z: 1 = sheet of fibres; w: m2/kg, extinction
                  // of one kg/m3
    vec4 body;    // x: m in the plane over which the rank changes by 1; y: by how much the threshold is above the cover; z: share of a
                  // small cover on which no tower stands, 0: there is no anvil; w: 0..8, along which of lib/cloud's ways the anvil's streaks lie
    vec4 anchor;  // xyz: m, add to a position to come to the frame that drifts with the layer (wrapped); w: 1/m, periods
                  // of the shape volume
    vec4 detail;  // the same of the detail volume, which drifts a little faster
    vec4 fibre;   // of a sheet xy: unit vector along fibres, east and south; z: 1/m along them; w: 1/m across. Of what has an anvil xy: m east and
                  // south, how far it is carried; z: share of that by which all of it is; w: how much weaker in rank it is there
    vec4 wind;    // xy: m/s east and south; zw: m of skew per m of height, east and south
    vec4 extent;  // x: lowest base; y: highest top in the map; z: 1 = a layer at all; w: how much lower the lowest tops
                  // are, share of the height
};

struct CloudShape {
    LayerShape layers[kCloudLayers];
};

// How a layer's column changes around the camera: a plane fitted to the field, held between what was found. Each vec4:
// threshold of the rank, base, top, water.
struct LayerField {
    vec4 centre;
    vec4 eastward;   // per m
    vec4 southward;  // per m
    vec4 low;
    vec4 high;
};

GLSL_CONST int kCloudMapLevels = 3;
GLSL_CONST int kCloudMapSize = 512;
GLSL_CONST int kCloudBlockBinding = 5;

UNIFORM_BLOCK(CloudBlock, 5) {
    LayerShape shapes[kCloudLayers];
    LayerField fields[kCloudLayers];
    vec4 mapPlaces[12];       // [level * 4 + layer] xy: m, add to a place (east, south of the camera) to come to the map's
                              // corner; z: 1 / its width; w: slice + 1, 0 = there is no such map
    vec4 shadowPlace;         // xy: m, add to a place to come to the shadow map's corner; z: 1 / its width; w: altitude of
                              // the plane on which it lies
    vec4 depthPlaces[2];      // of the inner and the outer grid of optical depth toward the light: xy: m, add to a place on its plane to
                              // come to the world modulo the grid's width; z: 1 / its width; w: m, the width
    vec4 depthHeights;        // x, y: altitudes of the lowest and the highest slice; z: of the plane; w: 1 = there are grids
    vec4 light;               // x: asymmetry g; y: powder; z: 1 = shadows fall
    ivec4 march;              // x: layers; y: most steps; z: which ray of each block is marched; w: side of the blocks, pixels: 1, 2 or 4
    vec4 step;                // x: m, shortest step; y: step per distance; z: m, reach; w: s of the weather's clock since the frame before
} BLOCK_NAME(clouds);

GLSL_END
#endif
