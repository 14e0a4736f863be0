// The sky without clouds as the tables that are made of it ask for it. GLSL alone.
#ifndef LUFTPOST_OPEN_SKY_GLSL
#define LUFTPOST_OPEN_SKY_GLSL
#include "shaders/lib/sky_tables.glsl"

AirLight lightFrom(Atmosphere air, vec3 toward, vec3 direction, float h, int steps) {
    return airLight(air, skyTransmittanceTable, vec2(textureSize(skyTransmittanceTable, 0)), skyMultipleTable,
                    vec2(textureSize(skyMultipleTable, 0)), h, direction.y, toward.y, dot(direction, toward), steps);
}

/// Airglow comes from a layer 90 km up, of which a slanting ray sees more (van Rhijn 1921).
vec3 airglowAlong(float mu) {
    float outside = kPlanetRadius / (kPlanetRadius + 90000.0);
    return sky.airglow.rgb * inversesqrt(1.0 - outside * outside * (1.0 - mu * mu));
}

/// Radiance toward `direction` (world, unit) from altitude `h`, of sun, moon, airglow and, below the horizon, land.
vec3 openSky(Atmosphere air, float h, vec3 direction, int steps) {
    AirLight light = lightFrom(air, sky.lights.sun.xyz, direction, h, steps);
    vec3 radiance = light.radiance * sky.lights.sunLight.rgb;
    if (sky.skyCamera.y > 0.0) radiance += lightFrom(air, sky.lights.moon.xyz, direction, h, steps).radiance * sky.lights.moonLight.rgb;
    vec3 behind = distanceInward(h, direction.y, 0.0) >= 0.0 ? sky.air.ground.rgb : airglowAlong(direction.y);
    vec3 astray = 0.6 * sky.airglow.rgb * (1.0 - light.transmittance);  // of the airglow, by the air below it
    return radiance + light.transmittance * behind + astray;
}
#endif
