#version 450 core
// Table three: the sky's radiance by direction, of sun, moon and airglow together.
#include "shaders/lib/open_sky.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) writeonly uniform image2D table;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(table);
    if (any(greaterThanEqual(texel, size))) return;
    vec3 direction = skyDirection(sky.skyCamera.x, (vec2(texel) + 0.5) / vec2(size), sky.lights.sun.xyz);
    imageStore(table, texel, vec4(openSky(sky.air, sky.skyCamera.x, direction, 32), 1.0));
}
