#version 450 core
// Table three: the sky's radiance by direction, of sun, moon and airglow together.
#include "shaders/lib/sky_tables.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba32f) writeonly uniform image2D table;

AirLight lightFrom(vec3 toward, vec3 direction, float h) {
    return airLight(sky.air, skyTransmittanceTable, vec2(textureSize(skyTransmittanceTable, 0)), skyMultipleTable,
                    vec2(textureSize(skyMultipleTable, 0)), h, direction.y, toward.y, dot(direction, toward), 32);
}

/// Airglow comes from a layer 90 km up, of which a slanting ray sees more (van Rhijn 1921).
vec3 airglowAlong(float mu) {
    float outside = kPlanetRadius / (kPlanetRadius + 90000.0);
    return sky.airglow.rgb * inversesqrt(1.0 - outside * outside * (1.0 - mu * mu));
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(table);
    if (any(greaterThanEqual(texel, size))) return;
    float h = sky.skyCamera.x;
    vec3 direction = skyDirection(h, (vec2(texel) + 0.5) / vec2(size), sky.lights.sun.xyz);
    AirLight light = lightFrom(sky.lights.sun.xyz, direction, h);
    vec3 radiance = light.radiance * sky.lights.sunLight.rgb;
    if (sky.skyCamera.y > 0.0)
        radiance += lightFrom(sky.lights.moon.xyz, direction, h).radiance * sky.lights.moonLight.rgb;
    vec3 behind = distanceInward(h, direction.y, 0.0) >= 0.0 ? sky.air.ground.rgb : airglowAlong(direction.y);
    vec3 astray = 0.6 * sky.airglow.rgb * (1.0 - light.transmittance);  // of the airglow, by the air below it
    imageStore(table, texel, vec4(radiance + light.transmittance * behind + astray, 1.0));
}
