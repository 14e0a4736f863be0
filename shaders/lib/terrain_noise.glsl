// Noise for the land's face, anchored to the world at any distance from its origin: a place is a whole number of metres
// (`origin`, the chunk's south-west corner) plus an offset in metres; cells are powers of two wide, so that both split
// exactly. Integer hashes: the same in every language and on every machine.
#ifndef LUFTPOST_TERRAIN_NOISE_GLSL
#define LUFTPOST_TERRAIN_NOISE_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_FUNCTION uint landHash(uint x) {
    x = (x ^ (x >> 15u)) * 0x2c1b3c6du;
    x = (x ^ (x >> 13u)) * 0x297a2d39u;
    return x ^ (x >> 16u);
}
GLSL_FUNCTION uint landCellHash(int x, int y, uint seed) {
    return landHash(uint(x) * 0x9e3779b1u + uint(y) * 0x85ebca77u + seed);
}
/// 0..1 of the low or high half of a hash.
GLSL_FUNCTION float lowShare(uint h) { return float(h & 0xffffu) * (1.0f / 65536.0f); }
GLSL_FUNCTION float highShare(uint h) { return float(h >> 16u) * (1.0f / 65536.0f); }

/// A place in cells of 2^k metres: whole cell and the rest 0..1.
struct LandCell {
    int x, y;
    float fx, fy;
};
GLSL_FUNCTION LandCell landCell(ivec2 origin, vec2 offset, int k) {
    float scale = 1.0f / float(1 << k);
    float px = (float(origin.x & ((1 << k) - 1)) + offset.x) * scale;
    float py = (float(origin.y & ((1 << k) - 1)) + offset.y) * scale;
    float wx = floor(px);
    float wy = floor(py);
    LandCell cell;
    cell.x = (origin.x >> k) + int(wx);
    cell.y = (origin.y >> k) + int(wy);
    cell.fx = px - wx;
    cell.fy = py - wy;
    return cell;
}

GLSL_FUNCTION float cornerSlope(uint h, float x, float y) {
    return (lowShare(h) - 0.5f) * x + (highShare(h) - 0.5f) * y;
}
/// Gradient noise, about -1..1, cells 2^k metres wide.
GLSL_FUNCTION float landNoise(ivec2 origin, vec2 offset, int k, uint seed) {
    LandCell c = landCell(origin, offset, k);
    float a = cornerSlope(landCellHash(c.x, c.y, seed), c.fx, c.fy);
    float b = cornerSlope(landCellHash(c.x + 1, c.y, seed), c.fx - 1.0f, c.fy);
    float d = cornerSlope(landCellHash(c.x, c.y + 1, seed), c.fx, c.fy - 1.0f);
    float e = cornerSlope(landCellHash(c.x + 1, c.y + 1, seed), c.fx - 1.0f, c.fy - 1.0f);
    float u = c.fx * c.fx * (3.0f - 2.0f * c.fx);
    float v = c.fy * c.fy * (3.0f - 2.0f * c.fy);
    return 3.4f * mix(mix(a, b, u), mix(d, e, u), v);
}

GLSL_END
#endif
