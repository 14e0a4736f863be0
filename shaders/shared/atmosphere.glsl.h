// The air as C++ and GLSL share it: optical properties that change with the weather. Metres and 1/m at the effective
// wavelengths of Rec. 709's red, green and blue (615, 545, 465 nm).
#ifndef LUFTPOST_ATMOSPHERE_GLSL_H
#define LUFTPOST_ATMOSPHERE_GLSL_H
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

// The fields are vec4 so that std140 and C++ lay them out alike.
struct Atmosphere {
    vec4 rayleigh;  // rgb: scattering of air molecules at sea level; w: scale height
    vec4 haze;      // rgb: extinction of haze at its base; w: scale height
    vec4 ozone;     // rgb: absorption at 25 km, falling to 0 at 10 and 40 km; w: albedo of fog
    vec4 fog;       // x: extinction at the base; y: scale height; z: altitude of the base of haze and fog; w: albedo of haze
    vec4 cover;     // x: altitude below which clouds above dim; y: share of direct light that they leave; z: altitude of the tops of clouds, w: their albedo, cover counted in
    vec4 under;     // rgb: mean radiance over all directions of the light under them, 1/sr; w: their share of the sky
    vec4 ground;    // rgb: mean radiance of the land that the sky meets below the horizon; w: albedo of the land
};

// What the sky is drawn from in one frame. Irradiances above the air, the sun's being 1.
struct SkyLights {
    vec4 sun;        // xyz: unit vector toward it; w: angular radius
    vec4 sunLight;   // rgb: irradiance above the air
    vec4 moon;       // xyz: unit vector toward it; w: angular radius
    vec4 moonLight;  // rgb: irradiance above the air
};

GLSL_END
#endif
