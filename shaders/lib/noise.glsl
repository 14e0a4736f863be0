// Noise on integer hashes, the same numbers in C++ and GLSL: no sin(), so no driver has a say in where clouds stand.
// Lattices wrap: a noise of `period` cells repeats after that many, in every direction, negative cells included.
#ifndef LUFTPOST_NOISE_GLSL
#define LUFTPOST_NOISE_GLSL
#include "shaders/shared/language.glsl.h"

GLSL_BEGIN

// PCG-RXS-M-XS of 32 bits (O'Neill 2014; found best of the cheap ones by Jarzynski and Olano, JCGT 9(3), 2020).
GLSL_FUNCTION uint hashOf(uint value) {
    uint state = value * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

GLSL_FUNCTION uint hashOf2(int x, int y, uint seed) { return hashOf(uint(x) + hashOf(uint(y) + seed)); }

GLSL_FUNCTION uint hashOf3(int x, int y, int z, uint seed) {
    return hashOf(uint(x) + hashOf(uint(y) + hashOf(uint(z) + seed)));
}

// 0 <= result < 1, from the top 24 bits, so that float holds it exactly.
GLSL_FUNCTION float unitFromHash(uint hash) { return float(int(hash >> 8u)) * (1.0f / 16777216.0f); }

// The cell of the wrapped lattice, 0 <= result < period, for negative cells too; |cell| < 2^24. Divides as float, which
// vector units can, and puts right a quotient that is one off.
GLSL_FUNCTION int wrapCell(int cell, int period) {
    int rest = cell - period * int(float(cell) / float(period));
    rest = rest < 0 ? rest + period : rest;
    return rest >= period ? rest - period : rest;
}

// 6t^5 - 15t^4 + 10t^3 (Perlin 2002): first and second derivative vanish at both ends.
GLSL_FUNCTION float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

GLSL_FUNCTION float lerpOf(float a, float b, float t) { return a + (b - a) * t; }

// (v - low) / (high - low) carried to 0..1.
GLSL_FUNCTION float ramp(float v, float low, float high) { return clamp((v - low) / (high - low), 0.0f, 1.0f); }

// Dot product of `offset` with one of the twelve edge directions of a cube (Perlin 2002).
GLSL_FUNCTION float edgeGradient(uint hash, vec3 offset) {
    uint h = hash & 15u;
    float a = h < 8u ? offset.x : offset.y;
    float b = h < 4u ? offset.y : ((h == 12u || h == 14u) ? offset.x : offset.z);
    return ((h & 1u) == 0u ? a : -a) + ((h & 2u) == 0u ? b : -b);
}

// Gradient noise in three dimensions, about -1..1, 0 on the lattice. `p` in cells.
GLSL_FUNCTION float gradientNoise(vec3 p, int period, uint seed) {
    vec3 corner = floor(p);
    vec3 f = p - corner;
    float sum = 0.0f;
    for (int k = 0; k < 8; ++k) {
        int dx = k & 1;
        int dy = (k >> 1) & 1;
        int dz = k >> 2;
        uint hash = hashOf3(wrapCell(int(corner.x) + dx, period), wrapCell(int(corner.y) + dy, period),
                            wrapCell(int(corner.z) + dz, period), seed);
        vec3 offset = vec3(f.x - float(dx), f.y - float(dy), f.z - float(dz));
        float weight = (dx == 1 ? fade(f.x) : 1.0f - fade(f.x)) * (dy == 1 ? fade(f.y) : 1.0f - fade(f.y)) *
                       (dz == 1 ? fade(f.z) : 1.0f - fade(f.z));
        sum += weight * edgeGradient(hash, offset);
    }
    return sum;
}

// Distance to the nearest feature point, one per cell (Worley 1996), in cells: 0..1.73, seldom over 1.
GLSL_FUNCTION float worleyDistance(vec3 p, int period, uint seed) {
    vec3 corner = floor(p);
    vec3 f = p - corner;
    float nearest = 4.0f;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                uint hash = hashOf3(wrapCell(int(corner.x) + dx, period), wrapCell(int(corner.y) + dy, period),
                                    wrapCell(int(corner.z) + dz, period), seed);
                float x = float(dx) + float(hash & 1023u) * (1.0f / 1024.0f) - f.x;
                float y = float(dy) + float((hash >> 10u) & 1023u) * (1.0f / 1024.0f) - f.y;
                float z = float(dz) + float((hash >> 20u) & 1023u) * (1.0f / 1024.0f) - f.z;
                nearest = min(nearest, x * x + y * y + z * z);
            }
    return sqrt(nearest);
}

// Billows: 1 at the feature points, 0 between them.
GLSL_FUNCTION float billows(vec3 unit, int period, uint seed) {
    return clamp(1.0f - worleyDistance(unit * float(period), period, seed), 0.0f, 1.0f);
}

// floor() as a whole number: no call into the C library, which costs more than the rest of a cell.
GLSL_FUNCTION int cellOf(float v) {
    int cell = int(v);
    return v < float(cell) ? cell - 1 : cell;
}

// Unit vector after `turns` >= 0 of a full circle, from a quintic that is 0.0002 off the sine at most and smooth where the
// quarters meet. Plain arithmetic: the same bits in every build, since the air asks for the pattern too.
GLSL_FUNCTION float waveOf(float turns) {
    float t = turns - float(int(turns));                         // 0..1
    float s = t < 0.5f ? 4.0f * t - 1.0f : 3.0f - 4.0f * t;      // triangle, -1..1
    float s2 = s * s;
    return s * (1.5697f - s2 * (0.6394f - 0.0697f * s2));
}
GLSL_FUNCTION vec2 turned(float turns) { return vec2(-waveOf(turns), -waveOf(turns + 0.75f)); }

// Gradient noise in the plane whose gradients turn with time, each at its own rate ("flow noise", Perlin and Neyret
// 2001): it evolves and its distribution does not, which a slice through a 3D lattice cannot say. About -0.7..0.7.
GLSL_INLINE float flowNoise(vec2 p, ivec2 period, float turns, uint seed) {
    ivec2 corner = ivec2(cellOf(p.x), cellOf(p.y));
    vec2 f = p - vec2(corner);
    int x0 = wrapCell(corner.x, period.x);
    int x1 = x0 + 1 == period.x ? 0 : x0 + 1;
    int y0 = wrapCell(corner.y, period.y);
    int y1 = y0 + 1 == period.y ? 0 : y0 + 1;
    uint row0 = hashOf(uint(y0) + seed);
    uint row1 = hashOf(uint(y1) + seed);
    uint h00 = hashOf(uint(x0) + row0);
    uint h10 = hashOf(uint(x1) + row0);
    uint h01 = hashOf(uint(x0) + row1);
    uint h11 = hashOf(uint(x1) + row1);
    vec2 g00 = turned(unitFromHash(h00) + turns * (0.6f + 0.8f * float(int(h00 & 255u)) / 255.0f));
    vec2 g10 = turned(unitFromHash(h10) + turns * (0.6f + 0.8f * float(int(h10 & 255u)) / 255.0f));
    vec2 g01 = turned(unitFromHash(h01) + turns * (0.6f + 0.8f * float(int(h01 & 255u)) / 255.0f));
    vec2 g11 = turned(unitFromHash(h11) + turns * (0.6f + 0.8f * float(int(h11 & 255u)) / 255.0f));
    float n00 = g00.x * f.x + g00.y * f.y;
    float n10 = g10.x * (f.x - 1.0f) + g10.y * f.y;
    float n01 = g01.x * f.x + g01.y * (f.y - 1.0f);
    float n11 = g11.x * (f.x - 1.0f) + g11.y * (f.y - 1.0f);
    float u = fade(f.x);
    return lerpOf(lerpOf(n00, n10, u), lerpOf(n01, n11, u), fade(f.y));
}

// There and back between 0 and 1 once a turn, at an even pace, so that every place is as likely as another.
GLSL_FUNCTION float shuttle(float turns) { return abs(2.0f * (turns - float(int(turns))) - 1.0f); }

// How far from a cell's edge its point stays, and how far it wanders: nearly at will, and a little more evenly spaced.
GLSL_CONST vec2 kFreeRoom = vec2(0.06f, 0.88f);
GLSL_CONST vec2 kEvenRoom = vec2(0.12f, 0.76f);

// Square of the distance from `f` to the feature point of the cell with hash `h`, whose corner is at `corner`. In cells.
GLSL_FUNCTION float wandererSquare(uint h, vec2 corner, vec2 f, float turns, vec2 room) {
    float pace = turns * (0.6f + 0.8f / 255.0f * float(int(h & 255u)));
    float px = corner.x + room.x + room.y * shuttle(float(int((h >> 8u) & 4095u)) * (1.0f / 4096.0f) + pace) - f.x;
    float py = corner.y + room.x + room.y * shuttle(float(int(h >> 20u)) * (1.0f / 4096.0f) + pace) - f.y;
    return px * px + py * py;
}

// The nearest of three neighbours in a row of cells, squared; `x`: their wrapped places.
GLSL_FUNCTION float wanderersSquare(ivec3 x, uint row, float y, vec2 f, float turns) {
    float west = wandererSquare(hashOf(uint(x.x) + row), vec2(-1.0f, y), f, turns, kFreeRoom);
    float here = wandererSquare(hashOf(uint(x.y) + row), vec2(0.0f, y), f, turns, kFreeRoom);
    float east = wandererSquare(hashOf(uint(x.z) + row), vec2(1.0f, y), f, turns, kFreeRoom);
    return min(west, min(here, east));
}

// Distance to the nearest feature point in the plane; the points wander in their cells, evenly spread at any moment.
// In cells, 0..1.3. Written out, not looped, so that the loop over many points becomes vector code.
GLSL_INLINE float flowWorley(vec2 p, ivec2 period, float turns, uint seed) {
    ivec2 corner = ivec2(cellOf(p.x), cellOf(p.y));
    vec2 f = p - vec2(corner);
    int x0 = wrapCell(corner.x - 1, period.x);
    int x1 = x0 + 1 == period.x ? 0 : x0 + 1;
    int x2 = x1 + 1 == period.x ? 0 : x1 + 1;
    int y0 = wrapCell(corner.y - 1, period.y);
    int y1 = y0 + 1 == period.y ? 0 : y0 + 1;
    int y2 = y1 + 1 == period.y ? 0 : y1 + 1;
    ivec3 x = ivec3(x0, x1, x2);
    float north = wanderersSquare(x, hashOf(uint(y0) + seed), -1.0f, f, turns);
    float middle = wanderersSquare(x, hashOf(uint(y1) + seed), 0.0f, f, turns);
    float south = wanderersSquare(x, hashOf(uint(y2) + seed), 1.0f, f, turns);
    return sqrt(min(north, min(middle, south)));
}

// Distance to the point of a cell whose corner is at `corner`, and how much later than the strongest it begins: of every four cells one is
// strong, the others begin by a fifth of a cell later and more. Dealt so, not at will, each square of 2 x 2 cells holds about as much as
// the next; none of the strong one's neighbours is the next in strength more often than another, lest the plane have a grain.
// All swell and fade a little as they wander; the middle of each is round, lest it be drawn as a needle.
GLSL_FUNCTION float unevenWanderer(int x, int y, vec2 corner, vec2 f, float turns, uint seed) {
    uint deal = hashOf2(x / 2, y / 2, seed + 23u);
    int place = ((x & 1) + 2 * (y & 1)) ^ int(deal & 3u);
    int weaker = place > 0 ? 1 + (place + int((deal >> 2u) & 255u)) % 3 : 0;
    uint h = hashOf(uint(x) + hashOf(uint(y) + seed));
    float later = (weaker > 0 ? 0.16f + 0.04f * float(weaker) : 0.0f) + 0.03f * shuttle(unitFromHash(hashOf(h)) + turns);
    return sqrt(wandererSquare(h, corner, f, turns, kEvenRoom) + 0.04f) + later;
}

GLSL_FUNCTION float unevenWanderers(ivec3 x, int y, float row, vec2 f, float turns, uint seed) {
    float west = unevenWanderer(x.x, y, vec2(-1.0f, row), f, turns, seed);
    float here = unevenWanderer(x.y, y, vec2(0.0f, row), f, turns, seed);
    float east = unevenWanderer(x.z, y, vec2(1.0f, row), f, turns, seed);
    return min(west, min(here, east));
}

// flowWorley with points of unequal strength: the stronger, the larger and deeper its cell. What lies two cells away is not asked, so
// nothing may be further off than the nearest of that can be.
GLSL_INLINE float unevenWorley(vec2 at, ivec2 period, float turns, uint seed) {
    // The lattice's own place is another in every pattern: nothing may stand nearer the origin than elsewhere.
    vec2 p = at + vec2(float(int(hashOf(seed) & 4095u)), float(int(hashOf(seed + 1u) & 4095u))) * (2.0f / 4096.0f);
    ivec2 corner = ivec2(cellOf(p.x), cellOf(p.y));
    vec2 f = p - vec2(corner);
    int x0 = wrapCell(corner.x - 1, period.x);
    int x1 = x0 + 1 == period.x ? 0 : x0 + 1;
    int x2 = x1 + 1 == period.x ? 0 : x1 + 1;
    int y0 = wrapCell(corner.y - 1, period.y);
    int y1 = y0 + 1 == period.y ? 0 : y0 + 1;
    int y2 = y1 + 1 == period.y ? 0 : y1 + 1;
    ivec3 x = ivec3(x0, x1, x2);
    float north = unevenWanderers(x, y0, -1.0f, f, turns, seed);
    float middle = unevenWanderers(x, y1, 0.0f, f, turns, seed);
    float south = unevenWanderers(x, y2, 1.0f, f, turns, seed);
    return min(min(north, min(middle, south)), 1.06f);
}

// What the volumes hold. `unit` runs over one period, 0..1 each way; every octave wraps at its end.
// Ranges are those that the noise really has (measured, docs/clouds.md), carried to 0..1, so that a remap never
// reaches for values that do not occur.
GLSL_FUNCTION float gradientFbm(vec3 unit, int period, uint seed) {
    float sum = 0.0f;
    float amplitude = 1.0f;
    int cells = period;
    for (int octave = 0; octave < 4; ++octave) {
        sum += amplitude * gradientNoise(unit * float(cells), cells, seed + uint(octave) * 101u);
        amplitude *= 0.5f;
        cells *= 2;
    }
    return sum;
}

// r: Perlin-Worley, connected like Perlin noise and billowy like Worley's; g, b, a: Worley octaves, each a sum of
// finer and finer billows (Schneider, GPU Pro 7, chapter 4).
GLSL_FUNCTION vec4 shapeNoise(vec3 unit, uint seed) {
    float w4 = billows(unit, 4, seed + 11u);
    float w8 = billows(unit, 8, seed + 12u);
    float w16 = billows(unit, 16, seed + 13u);
    float w32 = billows(unit, 32, seed + 14u);
    float coarse = 0.625f * w4 + 0.25f * w8 + 0.125f * w16;
    float middle = 0.625f * w8 + 0.25f * w16 + 0.125f * w32;
    float fine = 0.75f * w16 + 0.25f * w32;
    float connected = ramp(gradientFbm(unit, 4, seed), -0.95f, 0.95f);
    float perlinWorley = ramp(connected, 0.72f * (1.0f - coarse) - 0.2f, 1.0f);
    return vec4(ramp(perlinWorley, 0.05f, 0.8f), ramp(coarse, 0.12f, 0.8f), ramp(middle, 0.12f, 0.8f),
                ramp(fine, 0.08f, 0.8f));
}

// Their sum as the clouds take it, 0..1 over the whole of its range: 1 on the billows, 0 in the creases.
GLSL_FUNCTION float billowNoise(vec3 unit, uint seed) {
    vec4 noise = shapeNoise(unit, seed);
    return clamp((0.20f * noise.x + 0.32f * noise.y + 0.28f * noise.z + 0.20f * noise.w - 0.25f) * 2.0f, 0.0f, 1.0f);
}

// The wisps of the edges, 0..1 over the whole of its range: Worley octaves, and the same four times finer.
GLSL_FUNCTION float detailNoise(vec3 unit, uint seed) {
    vec3 fine = unit * 4.0f;
    return clamp(0.69f * billows(unit, 2, seed + 21u) + 0.72f * billows(unit, 4, seed + 22u) + 0.65f * billows(unit, 8, seed + 23u) +
                     0.13f * billows(unit, 16, seed + 24u) + 0.34f * billows(fine, 2, seed + 21u) + 0.34f * billows(fine, 4, seed + 22u) +
                     0.12f * billows(fine, 8, seed + 23u) - 0.855f, 0.0f, 1.0f);
}

// Potential of the curl field: the field has no divergence because it is a curl.
GLSL_FUNCTION float curlPotential(vec2 unit, uint seed) {
    float sum = 0.0f;
    float amplitude = 1.0f;
    int cells = 4;
    for (int octave = 0; octave < 3; ++octave) {
        sum += amplitude * flowNoise(unit * float(cells), ivec2(cells), 0.0f, seed + 31u + uint(octave));
        amplitude *= 0.4f;
        cells *= 2;
    }
    return sum;
}

// xy: curl of the potential, about -1..1. zw: two fields of fine detail in the plane, mean 0, about -1..1:
// z frays the outlines of clouds, w is the grain of fibres.
GLSL_FUNCTION vec4 curlNoise(vec2 unit, uint seed) {
    float e = 1.0f / 512.0f;
    float dx = curlPotential(vec2(unit.x + e, unit.y), seed) - curlPotential(vec2(unit.x - e, unit.y), seed);
    float dy = curlPotential(vec2(unit.x, unit.y + e), seed) - curlPotential(vec2(unit.x, unit.y - e), seed);
    float fray = 0.0f;
    float grain = 0.0f;
    float amplitude = 1.0f;
    int cells = 8;
    for (int octave = 0; octave < 4; ++octave) {
        fray += amplitude * flowNoise(unit * float(cells), ivec2(cells), 0.0f, seed + 41u + uint(octave));
        grain += amplitude * flowNoise(unit * float(cells), ivec2(cells), 0.0f, seed + 51u + uint(octave));
        amplitude *= 0.6f;
        cells *= 2;
    }
    float slope = 1.0f / (2.0f * e * 10.0f);
    return vec4(dy * slope, -dx * slope, fray, grain);
}

GLSL_END
#endif
