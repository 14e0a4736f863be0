#version 450 core
// The plane that the build made with C++, made anew for another seed (weather/noise_volume.cpp is its twin).
#include "shaders/lib/noise.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba8) uniform writeonly image2D plane;
uniform uint seed;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 unit = (vec2(texel) + 0.5) / 128.0;
    imageStore(plane, texel, curlNoise(unit, seed) * 0.5 + 0.5);
}
