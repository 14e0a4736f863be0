#version 450 core
// One ray of each block through the clouds: what it gathers of light, what it lets through, and how far away that is.
#include "shaders/lib/cloud_ray.glsl"
#include "shaders/lib/cloud_rays.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
    ivec2 pixel = marchedPixel(ivec2(gl_GlobalInvocationID.xy));
    if (any(greaterThanEqual(pixel, ivec2(frame.viewport.xy)))) return;
    marchPixel(pixel);
}
