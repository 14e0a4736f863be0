#version 450 core
// Table four: the air's light and transmittance by direction and distance, one invocation a direction.
#include "shaders/lib/sky_tables.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) writeonly uniform image3D radianceTable;
layout(binding = 1, rgba16f) writeonly uniform image3D transmittanceTable;

AirLight stepTo(AirLight sum, vec3 toward, vec3 direction, float h, float start, float end) {
    return addAir(sum, sky.air, skyTransmittanceTable, vec2(textureSize(skyTransmittanceTable, 0)), skyMultipleTable,
                  vec2(textureSize(skyMultipleTable, 0)), h, direction.y, toward.y, dot(direction, toward), start, end);
}

AirLight throughSlice(AirLight sum, vec3 toward, vec3 direction, float h, float start, float end) {
    float middle = mix(start, end, 0.5);
    return stepTo(stepTo(sum, toward, direction, h, start, middle), toward, direction, h, middle, end);
}

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID.xy);
    ivec3 size = imageSize(radianceTable);
    if (any(greaterThanEqual(column, size.xy))) return;
    float h = sky.skyCamera.x;
    vec3 direction = skyDirection(h, (vec2(column) + 0.5) / vec2(size.xy), sky.lights.sun.xyz);
    AirLight sun = AirLight(vec3(0.0), vec3(1.0));
    AirLight moon = sun;
    float start = 0.0;
    for (int slice = 0; slice < size.z; ++slice) {
        float end = aerialDistance(float(slice), float(size.z));
        if (slice > 0) {
            sun = throughSlice(sun, sky.lights.sun.xyz, direction, h, start, end);
            if (sky.skyCamera.y > 0.0) moon = throughSlice(moon, sky.lights.moon.xyz, direction, h, start, end);
        }
        vec3 radiance = sun.radiance * sky.lights.sunLight.rgb + moon.radiance * sky.lights.moonLight.rgb +
                        0.6 * sky.airglow.rgb * (1.0 - sun.transmittance);
        imageStore(radianceTable, ivec3(column, slice), vec4(radiance, 1.0));
        imageStore(transmittanceTable, ivec3(column, slice), vec4(sun.transmittance, 1.0));
        start = end;
    }
}
