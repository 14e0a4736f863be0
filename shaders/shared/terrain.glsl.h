// What the land tells its shaders once a frame: block 6.
#ifndef LUFTPOST_TERRAIN_GLSL_H
#define LUFTPOST_TERRAIN_GLSL_H
#include "shaders/shared/language.glsl.h"
#include "shaders/shared/block.glsl.h"
GLSL_BEGIN

UNIFORM_BLOCK(LandBlock, 6) {
    vec4 levels;        // x: water level, m above sea level; y: snow line, m; z: camera's height over the ground (levelDistance); w: camera's altitude, m
    vec4 runway;        // xy: unit vector east, north along the runway; z: length; w: width, m
    vec4 home;          // xy: the origin's east and north from the camera, m; z: the airfield's altitude; w: 1 when near enough to matter
    vec4 shadow;        // xy: south-west corner of the shadow map from the camera (east, north), m; z: 1 / its width, 1/m; w: 1 when there is one
} BLOCK_NAME(land);

GLSL_END
#endif
