#version 450 core
// Every cell looks round: what comes to it along sixteen ways, from what diffusion says of the cells on them.
#include "shaders/lib/cloud_glow.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler3D glowCells;  // sun, sky, k in 1/m, beam
layout(binding = 0, rg16f) uniform writeonly image3D glow;
uniform int firstRow;

const int kWays = 16;
const vec2 kSlopes = vec2(0.2113249, 0.7886751);  // sines of elevation: Gauss's two points of a half
const float kEnough = 3.0;                        // depth of k behind which nothing more is asked for
const int kMostSteps = 48;

vec3 wayOf(int i) {
    float up = (i & 4) == 0 ? kSlopes.x : kSlopes.y;
    float azimuth = 1.5707963 * (float(i & 3) + ((i & 4) == 0 ? 0.25 : 0.75));
    float level = sqrt(1.0 - up * up);
    return vec3(level * cos(azimuth), (i & 8) == 0 ? up : -up, level * sin(azimuth));
}

/// sun and sky that come along a way into a place.
vec2 comesAlong(vec3 p, vec3 way) {
    float stride = min(glowStep() / abs(way.y), 0.75 * glowWidth() / sqrt(1.0 - way.y * way.y));
    vec2 sum = vec2(0.0);
    float depth = 0.0;
    // The nearest half step is the cell's own.
    float at = 0.25 * stride, length = 0.5 * stride;
    int steps = 0;
    bool on = true;
    do {
        vec3 q = p + way * at;
        vec4 cell = textureLod(glowCells, glowUnit(q), 0.0);
        float met = cell.z * length;
        float kept = exp(-met);
        sum += exp(-depth) * (1.0 - kept) * vec2(cell.x + cell.w * kIsotropic, cell.y);
        depth += met;
        at += 0.5 * (length + stride);
        length = stride;
        ++steps;
        float y = p.y + way.y * at;
        on = depth < kEnough && steps < kMostSteps && y > clouds.depthHeights.x && y < clouds.depthHeights.y;
    } while (on);
    vec4 last = textureLod(glowCells, glowUnit(p + way * at), 0.0);
    bool left = depth < kEnough && steps < kMostSteps;
    vec2 beyond = left ? vec2(0.0, way.y > 0.0 ? 1.0 : 0.0) : last.xy;
    return sum + exp(-depth) * beyond;
}

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID) + ivec3(0, firstRow, 0);
    vec3 p = glowPlace(at.xy, at.z);
    vec4 cell = texelFetch(glowCells, at, 0);
    float near = 0.0;  // k around: where there is none, diffusion will do
    for (int side = 0; side < 6; ++side) {
        ivec3 there = at + ivec3(side == 0 ? 1 : side == 1 ? -1 : 0, side == 2 ? 1 : side == 3 ? -1 : 0, side == 4 ? 1 : side == 5 ? -1 : 0);
        there = ivec3(there.xy & (kGlowSide - 1), clamp(there.z, 0, kGlowSlices - 1));
        near = max(near, texelFetch(glowCells, there, 0).z);
    }
    vec2 found = cell.xy;
    int way = max(near, cell.z) > 1e-5 ? 0 : kWays;
    if (way < kWays) {
        found = vec2(0.0);
        do {
            found += comesAlong(p, wayOf(way)) * (1.0 / float(kWays));
            ++way;
        } while (way < kWays);
    }
    imageStore(glow, at, vec4(found, 0.0, 0.0));
}
