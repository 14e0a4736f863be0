// Light in clouds.
//
// PROBLEM. How bright is a point in a cloud toward the eye? Droplets absorb nothing: light only changes direction, tens
// of times before it leaves a cumulus. To follow it is the reference's work; here is what is left of it.
//
// MODEL. Three parts, all in radiance per unit of irradiance of the light.
//   - Scattered once: Henyey and Greenstein's phase function, forward lobe and a weak backward one, times exp(-depth).
//     It makes the silver rim.
//   - Scattered a few times: it still runs forward, broader each time (g squared), through a cloud that looks thinner
//     the less the turns count: octaves after Wrenninge (2013).
//   - Scattered many times: isotropic. In a thick cloud that absorbs nothing the two-stream solution makes what gets
//     through depth t fall like 1 / (1 + 0.75 (1 - g) t), not exponentially: shaded bases are a quarter to an eighth of
//     the sunlit sides, not black. Near a face light leaks out again, and a thin cloud never had it: the share grows
//     with the optical depth to the nearest face.
// All phase functions hold the 1 / (4 pi), and no term is clamped from below.
#ifndef LUFTPOST_CLOUD_LIGHT_GLSL
#define LUFTPOST_CLOUD_LIGHT_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_CONST float kIsotropic = 0.0795774715f;  // 1 / (4 pi)
GLSL_CONST float kIceShare = 0.92f;           // asymmetry of crystals over that of droplets
GLSL_CONST float kSunGivesWay = -0.14f;       // sine of the sun's elevation below which clouds are lit by the moon

// Henyey and Greenstein, 1/sr; `cosine` between the ways in and out; integrates to 1 over the sphere.
GLSL_FUNCTION float henyeyGreenstein(float cosine, float g) {
    float k = max(1.0f + g * g - 2.0f * g * cosine, 1e-4f);
    return kIsotropic * (1.0f - g * g) / (k * sqrt(k));
}

// Cloud droplets: a forward lobe of asymmetry g, and a little that comes back. With g = 0.91 the mean cosine is 0.85, as
// Mie's theory has it for droplets of 10 um, and the sides and the back are as bright as its mean over their sizes.
GLSL_CONST float kBackwardShare = 0.04f;
GLSL_CONST float kBackward = -0.6f;
GLSL_FUNCTION float cloudPhase(float cosine, float g) {
    return (1.0f - kBackwardShare) * henyeyGreenstein(cosine, g) + kBackwardShare * henyeyGreenstein(cosine, kBackward);
}

// Share of a flux that gets through optical depth t of a cloud that absorbs nothing (two streams).
GLSL_FUNCTION float diffused(float t, float g) { return 1.0f / (1.0f + 0.75f * (1.0f - g) * t); }

// Albedo of a cloud of optical depth t that absorbs nothing: what `diffused` leaves.
GLSL_FUNCTION float cloudAlbedo(float t, float g) { return 1.0f - diffused(t, g); }

// Radiance per unit irradiance and per unit of optical depth passed, of a light at optical depth `toLight`, at a point
// `depth` (optical) below the nearest face of a cloud `bulk` (optical) large. `powder` darkens thin edges beyond what
// physics does (0: none).
GLSL_FUNCTION float litByBeam(float cosine, float g, float toLight, float depth, float bulk, float powder) {
    float scattered = cloudAlbedo(bulk, g);
    float once = cloudPhase(cosine, g) * exp(-toLight);
    float few = scattered * henyeyGreenstein(cosine, 0.45f * g) * exp(-(1.0f - g) * 1.4f * toLight);
    float leak = 1.0f - 0.6f * exp(-1.3f * (1.0f - g) * depth);
    float many = 0.40f * scattered * leak * diffused(toLight, g);
    return (once + few + many) * (1.0f - powder * exp(-2.0f * depth));
}

// The same of diffuse light: `fromAbove`, `fromBelow` are mean radiances of the upper and the lower half of the sphere.
GLSL_FUNCTION vec3 litByDiffuse(vec3 fromAbove, vec3 fromBelow, float above, float below, float g) {
    return 0.5f * (fromAbove * diffused(above, g) + fromBelow * diffused(below, g));
}

GLSL_END
#endif
