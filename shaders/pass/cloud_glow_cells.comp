#version 450 core
// What the cells of the glow hold: reduced extinction and the beam that reaches them, from the inner grid of optical depth. What was
// known of a cell's light is where its neighbours begin again.
#include "shaders/lib/cloud_glow.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image3D glowCells;
uniform int firstRow;
uniform int anew;  // 1: nothing is known

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID) + ivec3(0, firstRow, 0);
    vec3 toward = keyLight().toward;
    // The grids take a low light to stand at kLowestLight: its ways still go up.
    float slope = max(toward.y, kLowestLight);
    vec3 way = vec3(toward.x / slope, 1.0, toward.z / slope) * glowStep();
    vec3 p = glowPlace(at.xy, at.z);
    vec2 onPlane = onDepthPlane(p, toward);
    int grid = gridOver(onPlane);
    float low = 0.0, high = 0.0;
    if (grid < 2) {
        low = griddedDepth(grid, p - 0.5 * way, onPlane);
        high = griddedDepth(grid, p + 0.5 * way, onPlane);
    }
    float share = reducedShare();
    float met = share * max(low - high, 0.0);
    float beam = exp(-share * high) * (met > 1e-3 ? (1.0 - exp(-met)) / met : 1.0 - 0.5 * met);
    vec2 known = anew > 0 ? vec2(0.0, 0.5) : imageLoad(glowCells, at).xy;
    imageStore(glowCells, at, vec4(known, met / glowStep() * slope, beam));
}
