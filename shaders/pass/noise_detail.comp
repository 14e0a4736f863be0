#version 450 core
// The volume that the build made with C++, made anew for another seed (weather/noise_volume.cpp is its twin).
#include "shaders/lib/noise.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r8) uniform writeonly image3D volume;
uniform uint seed;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    vec3 unit = (vec3(texel) + 0.5) / vec3(64.0);
    imageStore(volume, texel, vec4(detailNoise(unit, seed)));
}
