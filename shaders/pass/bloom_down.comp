#version 450 core
// One level of the bloom: half the size of the one before, each texel the mean of four soft samples.
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D finer;
layout(binding = 0, rgba16f) uniform writeonly image2D result;
uniform float ceiling;  // what a single texel may add: fireflies do not flicker

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(result);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 uv = (vec2(texel) + 0.5) / vec2(size);
    vec2 offset = 1.0 / vec2(textureSize(finer, 0));
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 1; y += 2)
        for (int x = -1; x <= 1; x += 2)
            sum += min(textureLod(finer, uv + vec2(x, y) * offset, 0.0).rgb, vec3(ceiling));
    imageStore(result, texel, vec4(sum * 0.25, 1.0));
}
