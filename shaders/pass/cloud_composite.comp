#version 450 core
// The clouds before the picture, and the air before the clouds.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/sky_tables.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D cloudLight;     // radiance * preExposure, transmittance
layout(binding = 1) uniform sampler2D cloudDistance;
layout(binding = 0, rgba16f) uniform image2D colourTarget;
uniform int inverted;                                 // 1: the distance texture holds 1 / m

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colourTarget)))) return;
    vec4 light = texelFetch(cloudLight, pixel, 0);
    if (light.a >= 0.9999) return;
    float distance = texelFetch(cloudDistance, pixel, 0).r;
    if (inverted == 1) distance = 1.0 / max(distance, 1e-6);
    AirLight air = airBefore(rayDirection(vec2(pixel) + 0.5), distance);
    vec4 behind = imageLoad(colourTarget, pixel);
    vec3 before = light.rgb * air.transmittance + air.radiance * frame.exposure.x * (1.0 - light.a);
    imageStore(colourTarget, pixel, vec4(min(behind.rgb * light.a + before, vec3(60000.0)), behind.a * light.a));
}
