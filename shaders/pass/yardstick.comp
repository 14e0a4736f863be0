#version 450 core
// A fixed piece of work by which machines are compared, never changed: a plain march through a slab of noise, every
// pixel 64 samples along the ray and 6 toward the light from each that lies in cloud, no early end.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler3D noise;
layout(binding = 0, rgba16f) uniform writeonly image2D result;

float density(vec3 p) { return max(textureLod(noise, p * 0.00025, 0.0).r - 0.76, 0.0) * 0.05; }

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(result);
    if (any(greaterThanEqual(pixel, size))) return;
    vec2 unit = (vec2(pixel) + 0.5) / vec2(size);
    vec3 direction = normalize(vec3(unit.x * 2.0 - 1.0, 0.1 + 0.5 * unit.y, -1.0));
    vec3 light = normalize(vec3(0.4, 0.7, 0.2));
    float start = 1500.0 / direction.y, step = (3500.0 / direction.y - start) / 64.0;
    float through = 1.0, sum = 0.0;
    for (int i = 0; i < 64; ++i) {
        vec3 p = direction * (start + (float(i) + 0.5) * step);
        float here = density(p);
        if (here <= 0.0) continue;
        float depth = 0.0;
        for (int k = 1; k <= 6; ++k) depth += density(p + light * 60.0 * float(k)) * 60.0;
        float part = exp(-here * min(step, 200.0));
        sum += through * (1.0 - part) * exp(-depth);
        through *= part;
    }
    imageStore(result, pixel, vec4(vec3(sum), 1.0 - through));
}
