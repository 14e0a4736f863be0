#version 450 core
// One ray of each block through the clouds: what it gathers of light, what it lets through, and how far away that is.
#include "shaders/lib/cloud_ray.glsl"
#include "shaders/lib/cloud_rays.glsl"
#include "shaders/lib/groups.glsl"
layout(local_size_x = 64) in;

/// Of 8 x 8 blocks, so that the rays that a processor takes together, be it 8 or 32, lie close together.
ivec2 blockOf(uint index) {
    return ivec2(index & 3u | index >> 1 & 4u, index >> 2 & 1u | index >> 3 & 6u);
}

void main() {
    ivec2 pixel = marchedPixel(ivec2(strewnGroup()) * 8 + blockOf(gl_LocalInvocationIndex));
    if (any(greaterThanEqual(pixel, ivec2(frame.viewport.xy)))) return;
    marchPixel(pixel);
}
