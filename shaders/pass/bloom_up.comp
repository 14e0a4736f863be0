#version 450 core
// Adds a coarser level of the bloom, blurred by a tent, to this one.
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D coarser;
layout(binding = 0, rgba16f) uniform image2D result;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(result);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 uv = (vec2(texel) + 0.5) / vec2(size);
    vec2 offset = 0.5 / vec2(textureSize(coarser, 0));
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 1; y += 2)
        for (int x = -1; x <= 1; x += 2) sum += textureLod(coarser, uv + vec2(x, y) * offset, 0.0).rgb;
    vec3 own = imageLoad(result, texel).rgb;
    imageStore(result, texel, vec4(mix(own, sum * 0.25, 0.55), 1.0));
}
