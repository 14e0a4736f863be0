#version 450 core
// The glow diffuses: a column up and down at once, its four neighbours as they are; red columns, then black ones, each carried on
// beyond what it asks for (successive over-relaxation by lines).
#include "shaders/lib/cloud_glow.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image3D glowCells;  // sun, sky, k in 1/m, beam
uniform int firstRow;
uniform int colour;  // 0: red columns, 1: black

const float kBeyond = 1.7;
const float kFreeWay = 400.0;  // m: a third of it is the most that light diffuses by

/// What lets the flux through between two places `apart` m, of which each has its own k, over the width of a cell.
float conductance(float k, float other, float apart) { return 1.0 / ((1.5 * (k + other) + 1.0 / kFreeWay) * apart * apart); }

/// The same from the middle of the outermost cell, `high` m high, into a half-space from which nothing comes back (Marshak's condition).
float outward(float k, float high) { return 1.0 / (((1.5 * k + 0.5 / kFreeWay) * high + 2.0) * high); }

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
    int x = 2 * at.x + ((at.y + colour) & 1);
    ivec2 column = ivec2(x, at.y);
    ivec2 around[4] = ivec2[4](ivec2(x + 1, at.y) & (kGlowSide - 1), ivec2(x - 1, at.y) & (kGlowSide - 1),
                               ivec2(x, at.y + 1) & (kGlowSide - 1), ivec2(x, at.y - 1) & (kGlowSide - 1));
    float high = glowStep(), wide = glowWidth();
    vec4 here = imageLoad(glowCells, ivec3(column, 0));
    float below = outward(here.z, high), passed = 0.0;
    vec2 enters = vec2(0.0);
    float share[kGlowSlices];
    vec2 rest[kGlowSlices];
    float shareBelow = 0.0;
    vec2 restBelow = vec2(0.0);
    for (int k = 0; k < kGlowSlices; ++k) {
        bool top = k == kGlowSlices - 1;
        vec4 next = imageLoad(glowCells, ivec3(column, min(k + 1, kGlowSlices - 1)));
        float above = top ? outward(here.z, high) : conductance(here.z, next.z, high);
        float sum = below + above;
        vec2 comes = vec2(here.z * here.w * kIsotropic, top ? above : 0.0);
        for (int side = 0; side < 4; ++side) {
            vec4 there = imageLoad(glowCells, ivec3(around[side], k));
            float through = conductance(here.z, there.z, wide);
            sum += through;
            comes += through * there.xy;
        }
        float pivot = 1.0 / (sum - passed * shareBelow);
        restBelow = (comes + passed * restBelow) * pivot;
        shareBelow = top ? 0.0 : above * pivot;
        share[k] = shareBelow;
        rest[k] = restBelow;
        passed = below = above;
        here = next;
    }
    vec2 solved = vec2(0.0);
    for (int k = kGlowSlices - 1; k >= 0; --k) {
        vec4 cell = imageLoad(glowCells, ivec3(column, k));
        solved = rest[k] + share[k] * solved;
        imageStore(glowCells, ivec3(column, k), vec4(max(mix(cell.xy, solved, kBeyond), vec2(0.0)), cell.zw));
    }
}
