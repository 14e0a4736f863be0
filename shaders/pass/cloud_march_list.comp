#version 450 core
// The rays that were asked for because nothing was known of their pixels: what has come into the picture and from behind
// something.
#include "shaders/lib/cloud_ray.glsl"
#include "shaders/lib/cloud_rays.glsl"
layout(local_size_x = 64) in;

void main() {
    ivec2 pixel = askedPixel(gl_GlobalInvocationID.x, rayList.fillGroups.w);
    if (pixel.x < 0) return;
    marchPixel(pixel);
}
