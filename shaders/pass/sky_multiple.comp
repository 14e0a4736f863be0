#version 450 core
// Table two: light scattered more than once.
#include "shaders/lib/sky_tables.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) writeonly uniform image2D table;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(imageSize(table));
    vec2 argument = multipleArgument(size, (vec2(texel) + 0.5) / size);
    vec4 psi = multipleExact(sky.air, skyTransmittanceTable, vec2(textureSize(skyTransmittanceTable, 0)), argument.x,
                             argument.y, 8);
    imageStore(table, texel, psi);
}
