#version 450 core
// Table one: transmittance to the top of the air.
#include "shaders/lib/atmosphere.glsl"
#include "shaders/shared/sky_block.glsl.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) writeonly uniform image2D table;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(imageSize(table));
    vec2 argument = transmittanceArgument(size, (vec2(texel) + 0.5) / size);
    imageStore(table, texel, vec4(transmittanceToTopExact(sky.air, argument.x, argument.y), 1.0));
}
