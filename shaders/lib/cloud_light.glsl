// Light in clouds.
//
// PROBLEM. How bright is a point in a cloud toward the eye? Droplets absorb nothing: light only changes direction, tens
// of times before it leaves a cumulus. To follow it is the reference's work; here is what is left of it.
//
// MODEL. Four parts, all in radiance per unit of irradiance of the light.
//   - Scattered once: the phase function times exp(-depth). It makes the silver rim.
//   - Scattered forward, again and again: a lobe about the light's way that widens with the depth. It makes thin layers bright on
//     their far side: half of what one sees of altocumulus under the sun.
//   - Scattered a few times: nearly even, through a cloud that looks thinner the less the turns count: an octave after
//     Wrenninge (2013). The glow holds them too.
//   - Scattered many times: it has forgotten where it came from and diffuses. Between two faces that absorb nothing the
//     flux is the same everywhere, and the mean radiance falls evenly from the lit face to the dark one: two streams. That is a
//     slab. A cloud as wide as it is deep loses light through its sides, the sooner the narrower it is; and near a face it
//     leaks out. Around the camera that is solved on a grid instead, the glow (lib/cloud_glow.glsl), and the sample only puts right
//     what the grid is too coarse for.
// How much of each, and how fast what falls off: fitted to the path tracer (docs/clouds.md, The reference). All phase functions
// hold the 1 / (4 pi), and no term is clamped from below.
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

// Cloud droplets: a forward lobe of asymmetry g, and a little that comes back, about as much as Mie's theory has for droplets of
// 10 um toward the sides and the back. Its forward peak is broader than theirs, whose mean cosine is 0.85.
GLSL_CONST float kBackwardShare = 0.04f;
GLSL_CONST float kBackward = -0.6f;
GLSL_FUNCTION float cloudPhase(float cosine, float g) {
    return (1.0f - kBackwardShare) * henyeyGreenstein(cosine, g) + kBackwardShare * henyeyGreenstein(cosine, kBackward);
}

// Mean cosine of cloudPhase.
GLSL_FUNCTION float meanCosine(float g) { return (1.0f - kBackwardShare) * g + kBackwardShare * kBackward; }

// Share of a flux that gets through optical depth t of a slab that absorbs nothing; `s`: 1 less the mean cosine.
GLSL_FUNCTION float diffused(float t, float s) { return 1.0f / (1.0f + 0.75f * s * t); }

// 4 pi times the mean radiance in such a slab, over the flux that falls on it: optical depth `front` below the lit face,
// `behind` before the other one. 2 where there is no slab, 4 under the face of a thick one.
GLSL_FUNCTION float meanInside(float front, float behind, float s) { return (2.0f + 3.0f * s * behind) * diffused(front + behind, s); }

GLSL_CONST float kForward = 1.876f;
GLSL_CONST float kForwardTurns = 0.495f; // per optical depth, beyond the two of the first; each widens the lobe by g
GLSL_CONST float kFewTurns = 1.15f;
GLSL_CONST float kFewLobe = 0.063f;      // asymmetry
GLSL_CONST float kFewFade = 0.248f;
GLSL_CONST float kFewThick = 0.89f;    // power of what does not get through a slab
GLSL_CONST float kManyTurns = 0.517f;
GLSL_CONST float kManyFront = 0.20f;   // light comes in on other ways than the straight one: the depth of the face counts less
GLSL_CONST float kManyFresh = 0.40f;   // light at a lit face that has yet to be scattered
GLSL_CONST float kManySides = 9.5f;   // loss through the sides, by depth over width
GLSL_CONST float kManyLeakFade = 1.29f; // near a face that is not lit
GLSL_CONST float kManyThick = 0.93f;   // it takes a cloud to scatter many times: of its depth or width, whichever is less,
GLSL_CONST float kManyPower = 1.62f;   // and the power of what does not get through
GLSL_CONST float kRim = 0.235f;        // near any face light that was scattered leaks out: so much of it at the face,
GLSL_CONST float kRimFade = 1.76f;      // and how fast that ends

// With the glow in place of the last of them:
GLSL_CONST float kGlow = 1.781f;
GLSL_CONST float kGlowFade = 0.049f;   // a grid lets too much through to the far side: less of it, per depth of even turns toward the light
GLSL_CONST float kGlowLeak = 0.155f;    // share of a turn that is lost at a cloud's edge, through what is finer than the grid
GLSL_CONST float kBeamKnown = 0.613f;  // what the glow's grid knows of the beam is taken out,
GLSL_CONST float kBeamFade = 1.038f;    // and what the sample knows of it put in
GLSL_CONST float kGlowAhead = 1.888f;   // optical depths farther on along the eye's ray: what turns toward the eye comes from there
GLSL_CONST float kSkyAhead = 1.972f;
GLSL_CONST float kGlowAbove = 1.763f;
GLSL_CONST float kGlowBelow = 0.563f;

GLSL_CONST float kFromAbove = 1.774f;
GLSL_CONST float kFromBelow = 1.257f;

// Share of a beam that land, aircraft and air get behind an optical depth: light scattered but a few degrees still falls like a
// beam and is not taken out.
GLSL_FUNCTION float beamBehind(float depth) { return exp(-0.35f * depth); }

// Of a light at optical depth `toLight`: what is scattered once, and forward again and again. `s`: 1 less the mean cosine.
GLSL_FUNCTION float scatteredForward(float cosine, float g, float toLight, float s) {
    float beam = exp(-toLight), met = 1.0f - beam;
    float lobe = henyeyGreenstein(cosine, pow(g, 2.0f + kForwardTurns * toLight));
    return cloudPhase(cosine, g) * beam + kForward * met * met * exp(-s * toLight) * lobe;
}

// Radiance per unit irradiance and per unit of optical depth passed, of a light at optical depth `toLight`, at a point
// `depth` (optical) below the nearest face of a cloud `along` deep the light's way and `wide` across it (optical, both). `powder` darkens thin edges
// beyond what physics does (0: none).
GLSL_FUNCTION float litByBeam(float cosine, float g, float toLight, float depth, float along, float wide, float powder) {
    float s = 1.0f - meanCosine(g);
    float thin = min(along, wide), kept = 1.0f - kRim * exp(-kRimFade * s * depth);
    float few = kFewTurns * kept * pow(1.0f - diffused(thin, s), kFewThick) * henyeyGreenstein(cosine, kFewLobe) * exp(-kFewFade * s * toLight);
    float narrow = kManySides * toLight / (wide + 2.0f);
    float sides = 1.0f / (1.0f + narrow * narrow);
    float leak = 1.0f - (1.0f - exp(-s * toLight)) * exp(-kManyLeakFade * s * depth);
    float inside = meanInside(kManyFront * toLight, max(along - toLight, 0.0f), s) - kManyFresh * exp(-s * toLight);
    float many = kManyTurns * kept * pow(1.0f - diffused(kManyThick * thin, s), kManyPower) * kIsotropic * sides * leak * max(inside, 0.0f);
    return (scatteredForward(cosine, g, toLight, s) + few + many) * (1.0f - powder * exp(-2.0f * depth));
}

// litByBeam where the glow of the beam is known (cloud_scene's glowAt).
GLSL_FUNCTION float litByGlow(float cosine, float g, float toLight, float glow) {
    float s = 1.0f - meanCosine(g);
    float many = kGlow / (1.0f + kGlowFade * s * toLight) * max(glow + kBeamKnown * kIsotropic * exp(-kBeamFade * s * toLight), 0.0f);
    return scatteredForward(cosine, g, toLight, s) + many;
}

// Of diffuse light, the same: `fromAbove`, `fromBelow` are mean radiances of the upper and the lower half of the sphere, as a level plane
// weighs them; `sky` is the glow of a sky of 1.
GLSL_FUNCTION vec3 litBySkyGlow(vec3 fromAbove, vec3 fromBelow, float sky) {
    return kGlowAbove * sky * fromAbove + kGlowBelow * (1.0f - sky) * fromBelow;
}

// The same beyond the glow.
GLSL_FUNCTION vec3 litByDiffuse(vec3 fromAbove, vec3 fromBelow, float above, float below, float g) {
    float s = 1.0f - meanCosine(g);
    return 0.25f * (kFromAbove * fromAbove * meanInside(above, below, s) + kFromBelow * fromBelow * meanInside(below, above, s));
}

GLSL_END
#endif
