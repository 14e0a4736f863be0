// Light in clouds.
//
// PROBLEM. How bright is a point in a cloud toward the eye? Droplets absorb nothing: light only changes direction, tens
// of times before it leaves a cumulus. To follow it is the reference's work; here is what is left of it.
//
// MODEL. Four parts, all in radiance per unit of irradiance of the light.
//   - Scattered once: the phase function times exp(-depth). It makes the silver rim.
//   - Scattered forward, again and again: a lobe about the light's way that widens with the depth. It makes thin layers bright on
//     their far side: half of what one sees of altocumulus under the sun.
//   - Scattered a few times: a broad lobe near the lit face.
//   - Scattered many times, the glow: it has forgotten where it came from and diffuses. By similarity (van de Hulst 1980) that is even
//     scattering by the share s = 1 - m of the extinction, m the mean cosine of the phase function. Around the camera it is solved on a
//     grid (lib/cloud_glow.glsl); beyond, closed forms of two streams do: a slab between two faces that absorb nothing, a wall.
//     What turns toward the eye is the mean radiance and, since turns are small, more of what comes along the eye's ray: m times three
//     times the flux along it. The flux is the slope of the mean over 3 s, so to first order that is the mean radiance m / s optical
//     depths farther on along the ray, where the glow is asked for.
// In slabs that is within a tenth of the path tracer with no constant fitted. The rest, what a grid and a lobe cannot know, is: the constants
// below, to the path tracer's pictures (docs/clouds.md, The reference). All phase functions hold the 1 / (4 pi), and no term is clamped from below.
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

// Optical depths farther on along the eye's ray at which the glow says what is scattered toward the eye.
GLSL_FUNCTION float glowAhead(float g) {
    float m = max(meanCosine(g), 0.0f);
    return m / (1.0f - m);
}

// Share of a flux that gets through optical depth t of a slab that absorbs nothing; `s`: 1 less the mean cosine.
GLSL_FUNCTION float diffused(float t, float s) { return 1.0f / (1.0f + 0.75f * s * t); }

GLSL_CONST float kForward = 1.89f;
GLSL_CONST float kForwardTurns = 0.271f;  // per optical depth, beyond the two of the first; each widens the lobe by g
GLSL_CONST float kForwardFade = 1.29f;  // per depth of even turns
GLSL_CONST float kFew = 0.261f;
GLSL_CONST float kFewLobe = 0.394f;  // asymmetry
GLSL_CONST float kFewBack = 0.818f;    // of what still goes forward, how much is turned back
GLSL_CONST float kFewFade = 1.76f;
GLSL_CONST float kThinLess = 0.712f;  // a thin rim has less light than its parts would have within a cloud: by its transmittance

// Of the glow's radiance and, for a sky, of what is above and below; theory has 1 for the three.
GLSL_CONST float kGlow = 1.224f;
GLSL_CONST float kGlowAbove = 1.232f;
GLSL_CONST float kGlowBelow = 0.94f;

// A grid smears the walls of what is narrow:
GLSL_CONST float kWallWidth = 600.0f;  // m
GLSL_CONST float kWallMore = 0.718f;  // so much more light there is,
GLSL_CONST float kGlowFade = 0.228f;  // less of it on the far side, per depth of even turns toward the light,
GLSL_CONST float kEdge = 0.115f;      // and so much less at a face, through what is finer than the grid,
GLSL_CONST float kEdgeFade = 0.333f;  // where it ends that fast per optical depth

// The closed forms:
GLSL_CONST float kSheet = 2.06f;     // how much sooner than by its shape a cloud counts as a sheet that is lit from above
GLSL_CONST float kSides = 1.896f;   // loss through the sides, by depth over width
GLSL_CONST float kSkySides = 0.9f;  // of the sky a narrow cloud gets a half, wherever in it
GLSL_CONST float kRim = 0.433f;      // near any face light leaks out: so much of it at the face,
GLSL_CONST float kRimFade = 1.76f;  // and how fast that ends

// Share of a beam that land, aircraft and air get behind an optical depth: light scattered but a few degrees still falls like a
// beam and is not taken out.
GLSL_FUNCTION float beamBehind(float depth) { return exp(-0.35f * depth); }

// Mean radiance per unit of irradiance of a beam whose cosine to the face of a slab is m, `front` below that face of a slab `all` deep (both
// in depth of even turns): two streams without absorption, their source what turns out of the beam, no light from without (Marshak).
GLSL_FUNCTION float slabGlow(float front, float all, float m) {
    float low = exp(-all / m);
    float flux = (2.0f * m + 3.0f * m * m + low * (2.0f * m - 3.0f * m * m)) / (4.0f + 3.0f * all);
    return kIsotropic * max(3.0f * m * m * (1.0f - exp(-front / m)) + 2.0f * m - 2.0f * flux - 3.0f * flux * front, 0.0f);
}

// The same of a sky of 1 on one side of it.
GLSL_FUNCTION float slabSkyGlow(float front, float all) { return 1.0f - (2.0f + 3.0f * front) / (4.0f + 3.0f * all); }

// The glow (lib/cloud_glow.glsl) where no grid has it: x: of the beam; y: of a sky of 1 above. A cloud is a slab that is lit from above,
// a wall that faces the light, or something between by height and width; and light leaks out through its sides and near its faces. Optical depths: `toLight`;
// `above`, `below`: of the cloud over and under the point; `wide`: of the cloud in the plane; `depth`: below the nearest face. `up`: sine of
// the light's elevation; `s`: 1 less the mean cosine.
GLSL_FUNCTION vec2 closedGlow(float toLight, float above, float below, float wide, float depth, float up, float s) {
    float height = above + below, shape = kSheet * wide * up / (height * sqrt(1.0f - min(up * up, 0.99f)) + 0.1f);
    float sheet = shape * shape / (1.0f + shape * shape);
    float wall = slabGlow(s * min(toLight, wide), s * wide, 1.0f);
    float slab = slabGlow(s * above, s * height, max(up, 0.1f));
    float narrow = kSides * toLight / (wide + 2.0f);
    float kept = (1.0f - kRim * exp(-kRimFade * s * depth)) / (1.0f + narrow * narrow);
    float sides = kSkySides / (kSkySides + s * wide);
    return vec2(mix(wall, slab, sheet) * kept, mix(slabSkyGlow(s * above, s * height), 0.5f, sides));
}

// How narrow a cloud `width` m wide is for the glow's grid, which smears its walls: 0..1.
GLSL_FUNCTION float narrowness(float width) {
    float cells = width * (1.0f / kWallWidth);
    return 1.0f / (1.0f + cells * cells);
}

// What a grid's glow of the beam is multiplied by.
GLSL_FUNCTION float gridContrast(float toLight, float depth, float narrow, float up, float s) {
    return (1.0f + kWallMore * narrow) * (1.0f - kEdge * narrow * exp(-kEdgeFade * depth)) / (1.0f + kGlowFade * narrow * s * toLight * sqrt(up));
}

// What a ray's phase functions say, the same all along it. `cosine`: between the eye's ray and the way to the light.
struct RayPhase {
    float cosine;
    float g;     // asymmetry of the droplets' forward lobe
    float once;  // 1/sr: cloudPhase
    float few;   // 1/sr: of light that was turned a few times, by its factor
};

GLSL_FUNCTION RayPhase rayPhase(float cosine, float g) {
    RayPhase phase;
    phase.cosine = cosine;
    phase.g = g;
    phase.once = cloudPhase(cosine, g);
    phase.few = kFew * (henyeyGreenstein(cosine, kFewLobe) + kFewBack * henyeyGreenstein(cosine, kBackward));
    return phase;
}

// Radiance per unit irradiance and per unit of optical depth passed, of a light at optical depth `toLight`, at a point where its glow is `glow`.
GLSL_FUNCTION float litByBeam(RayPhase phase, float toLight, float glow) {
    float s = 1.0f - meanCosine(phase.g);
    float beam = exp(-toLight), met = 1.0f - beam;
    float lobe = henyeyGreenstein(phase.cosine, pow(phase.g, 2.0f + kForwardTurns * toLight));
    float forward = kForward * met * met * exp(-kForwardFade * s * toLight) * lobe;
    return phase.once * beam + forward + phase.few * met * exp(-kFewFade * s * toLight) + kGlow * glow;
}

// Of diffuse light, the same: `fromAbove`, `fromBelow` are mean radiances of the upper and the lower half of the sphere, as a level plane
// weighs them; `sky` is the glow of a sky of 1.
GLSL_FUNCTION vec3 litBySky(vec3 fromAbove, vec3 fromBelow, float sky) {
    return kGlowAbove * sky * fromAbove + kGlowBelow * (1.0f - sky) * fromBelow;
}

GLSL_END
#endif
