// Vertices of the shared grid meshes. Between levels odd vertices of the mesh in use move to the mean of their even
// neighbours (CDLOD: Strugar, "Continuous Distance-Dependent Level of Detail for Rendering Heightmaps", 2009); the mean
// is taken after the bend round the Earth, so that the finer edge lies exactly on the coarser one.
#ifndef LUFTPOST_TERRAIN_MESH_GLSL
#define LUFTPOST_TERRAIN_MESH_GLSL
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/terrain.glsl.h"
#include "shaders/lib/curvature.glsl"

layout(binding = 0) uniform sampler2D chunkSamples;  // height above sea level, normal

// One chunk: plain uniforms, since they change with every draw.
uniform vec4 chunkPlace;    // xy: south-west corner from the camera, m east and north; z: m per cell; w: samples per cell, 1 / step
uniform ivec4 chunkOrigin;  // xy: south-west corner, whole m east and north of the world's origin; z: stride of the mesh, cells; w: bits of coarser sides
uniform vec4 chunkMorph;    // x: distance where it begins; y: 1 / the distance over which it ends; z: 1 / samples a side

const float kLandItself = -1.0e6;

/// A vertex of the chunk relative to the camera, flat: of the land itself, or of a level `surface` (m above sea level).
vec3 flatVertex(ivec2 cell, float surface) {
    float height = surface > kLandItself ? surface : texelFetch(chunkSamples, ivec2(vec2(cell) * chunkPlace.w + 0.5), 0).x;
    vec2 offset = chunkPlace.xy + vec2(cell) * chunkPlace.z;
    return vec3(offset.x, height - land.levels.w, -offset.y);
}
vec3 bentVertex(ivec2 cell, float surface) { return curvedFromFlat(flatVertex(cell, surface), land.levels.w); }

/// 0: the vertex of its own level; 1: of the next coarser one.
float morphOf(ivec2 cell, vec3 flatPosition) {
    float distance = sqrt(flatPosition.x * flatPosition.x + flatPosition.z * flatPosition.z + land.levels.z * land.levels.z);
    float morph = clamp((distance - chunkMorph.x) * chunkMorph.y, 0.0, 1.0);
    int sides = chunkOrigin.w;
    bool onCoarserSide = (cell.x == 0 && (sides & 1) != 0) || (cell.x == 240 && (sides & 2) != 0) ||
                         (cell.y == 0 && (sides & 4) != 0) || (cell.y == 240 && (sides & 8) != 0);
    return onCoarserSide ? 1.0 : morph;
}

/// Where the vertex is drawn. `place`: metres east and north of the chunk's corner.
vec3 meshVertex(ivec2 cell, float surface, out vec2 place) {
    int stride = chunkOrigin.z;
    ivec2 odd = (cell / stride) & 1;
    vec3 flatPosition = flatVertex(cell, surface);
    vec3 bent = curvedFromFlat(flatPosition, land.levels.w);
    place = vec2(cell) * chunkPlace.z;
    if (odd == ivec2(0)) return bent;
    float morph = morphOf(cell, flatPosition);
    if (morph <= 0.0) return bent;
    vec3 mean = 0.5 * (bentVertex(cell - odd * stride, surface) + bentVertex(cell + odd * stride, surface));
    return mix(bent, mean, morph);
}
#endif
