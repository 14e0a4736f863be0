#version 450 core
// Rays through the clouds: what they gather of light, what they let through, and how far away that is. One of each block; or those
// that were asked for because nothing was known of their pixels: what has come into the picture and from behind something. One
// program does both: it is the largest there is, and a compiler's longest work.
#include "shaders/lib/cloud_ray.glsl"
#include "shaders/lib/cloud_rays.glsl"
#include "shaders/lib/groups.glsl"
layout(local_size_x = MARCH_GROUP) in;
uniform int asked;  // 1: the rays of the list

/// Of 32 x 16 blocks, or the first 8 x 8 of them, so that the rays that a processor takes together, be it 8 or 32, lie close together.
ivec2 blockOf(uint index) {
    return ivec2(index & 3u | index >> 1 & 4u | index >> 3 & 24u, index >> 2 & 1u | index >> 3 & 6u | index >> 5 & 8u);
}

void main() {
    ivec2 pixel = asked > 0 ? askedPixel(gl_GlobalInvocationID.x, rayList.fillGroups.w)
                            : marchedPixel(ivec2(strewnGroup()) * (blockOf(MARCH_GROUP - 1) + 1) + blockOf(gl_LocalInvocationIndex));
    if (pixel.x < 0 || any(greaterThanEqual(pixel, ivec2(frame.viewport.xy)))) return;
    marchPixel(pixel);
}
