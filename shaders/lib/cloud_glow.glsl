// The glow of clouds: mean radiance of the light that is scattered again and again in them, on a grid around the camera of upright
// columns. GLSL alone; for the passes that solve it (render/cloud_glow).
//
// PROBLEM. A cloud absorbs nothing, and light leaves it after tens of turns, through whichever side is near: the rims of a cloud are
// darker than its middle, the gap between two catches light from both. No sample knows that by itself.
//
// METHOD. Turns that hardly change the way are not counted: of the extinction there remains the share 1 - m, m the mean cosine of the phase
// function: k, and scattering by it is even (similarity; van de Hulst 1980). What is scattered once by k out of the beam is the source.
// First the light diffuses: its flux is the slope of its mean over 3 k, which is solved by lines. That is wrong in gaps and thin clouds; so then every cell looks round
// once along kWays ways and sums up what comes (one step of the source function's iteration, which in gaps is exact).
// Two parts: of the light's beam, per unit of irradiance; and of a sky of 1 above with no light from below.
#ifndef LUFTPOST_CLOUD_GLOW_GLSL
#define LUFTPOST_CLOUD_GLOW_GLSL
#include "shaders/lib/cloud_light.glsl"
#include "shaders/lib/cloud_scene.glsl"
#include "shaders/lib/sky_tables.glsl"

const int kGlowSide = 128;

/// m between two columns.
float glowWidth() { return clouds.depthPlaces[0].w / float(kGlowSide); }

/// The middle of a cell: of all places that its column stands for the one around the camera.
vec3 glowPlace(ivec2 column, int slice) {
    vec4 place = clouds.depthPlaces[0];
    vec2 p = (vec2(column) + 0.5) * glowWidth() - place.xy;
    p -= place.w * round(p * place.z);
    return vec3(p.x, clouds.depthHeights.x + (float(slice) + 0.5) * glowStep(), p.y);
}
#endif
