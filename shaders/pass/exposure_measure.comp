#version 450 core
// The histogram of luminance over every fourth pixel of every fourth row; the middle of the picture counts double.
#include "shaders/lib/exposure.glsl"
#include "shaders/shared/exposure_block.glsl.h"
#include "shaders/shared/frame.glsl.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D colour;
shared uint counts[256];

void main() {
    for (uint i = gl_LocalInvocationIndex; i < 256u; i += 64u) counts[i] = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) * 4 + 1;
    if (all(lessThan(pixel, textureSize(colour, 0)))) {
        vec3 radiance = texelFetch(colour, pixel, 0).rgb / frame.exposure.x;
        vec2 fromMiddle = vec2(pixel) * frame.viewport.zw - 0.5;
        uint weight = dot(fromMiddle, fromMiddle) < 0.1 ? 2u : 1u;
        float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
        if (luminance > 0.0) atomicAdd(counts[exposureBin(luminance)], weight);
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < 256u; i += 64u)
        if (counts[i] > 0u) atomicAdd(measured.bins[i], counts[i]);
}
