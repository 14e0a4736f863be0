// From scene light to the screen: the tone map, the screen's encoding, the dither.
#ifndef LUFTPOST_TONE_GLSL
#define LUFTPOST_TONE_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_CONST float kToneSlope = 1.5f;   // contrast about the middle, per stop
GLSL_CONST float kToneMiddle = 0.18f; // exposed radiance that keeps its value

/// One channel: Naka and Rushton's response x^n / (x^n + k^n), 0.18 staying 0.18. It never clips: a cloud sixteen
/// times as bright as its shadow still shows form. White (1) gives 0.74, 4 gives 0.96, 16 gives 0.995.
GLSL_FUNCTION float toneChannel(float x) {
    float powered = pow(max(x, 0.0f), kToneSlope);
    float middle = pow(kToneMiddle, kToneSlope) * (1.0f - kToneMiddle) / kToneMiddle;
    return powered / (powered + middle);
}

/// Exposed linear Rec. 709 -> display-linear 0..1. Before the curve each channel lends a little to the others, so that
/// bright colours go to white by way of paler shades of themselves. Channels curved alone turn orange to yellow, the curve
/// of the luminance alone keeps hues but burns: a third of it keeps a low sun's orange. After it pale colours are made
/// stronger, as cameras do: a clear sky is bluer in every photograph than its luminances say. Pale warm ones are made weaker: an
/// eye takes a low sun's light half for white.
GLSL_FUNCTION vec3 toneMapped(vec3 exposed) {
    float mean = (exposed.x + exposed.y + exposed.z) / 3.0f;
    vec3 lent = mix(exposed, vec3(mean), vec3(0.08f));
    vec3 alone = vec3(toneChannel(lent.x), toneChannel(lent.y), toneChannel(lent.z));
    float luminance = max(0.2126f * lent.x + 0.7152f * lent.y + 0.0722f * lent.z, 1e-9f);
    vec3 together = min(lent * (toneChannel(luminance) / luminance), vec3(1.0f));
    vec3 curved = mix(alone, together, vec3(0.35f));
    float most = max(curved.x, max(curved.y, curved.z));
    float least = min(curved.x, min(curved.y, curved.z));
    float pale = most > 0.0f ? least / most : 1.0f;
    float warm = most > 0.0f ? clamp(1.5f * (curved.x - curved.z) / most, 0.0f, 1.0f) : 0.0f;
    float curvedMean = (curved.x + curved.y + curved.z) / 3.0f;
    float stronger = mix(0.3f, -0.12f, warm) * smoothstep(0.0f, 0.35f, pale);
    return clamp(mix(curved, vec3(curvedMean), vec3(-stronger)), vec3(0.0f), vec3(1.0f));
}

/// What the eye makes of a radiance in the dark: `candela`: cd/m2 of 1 in `light`. Below 3 cd/m2 rods take over from cones,
/// below 0.003 they see alone: no colour, most for blue-green, and the brain calls it blue (Purkinje; Jensen et al. 2000,
/// "Night rendering"). So moonlight is bluish though the moon is redder than the sun.
GLSL_FUNCTION vec3 seenInTheDark(vec3 light, float candela) {
    float luminance = 0.2126f * light.x + 0.7152f * light.y + 0.0722f * light.z;
    float stage = log(max(luminance * candela, 1e-8f)) / 2.30258509f;
    float rods = 0.85f * (1.0f - smoothstep(-2.5f, 0.5f, stage));
    float rodLight = 0.06f * light.x + 0.60f * light.y + 0.34f * light.z;
    return mix(light, rodLight * vec3(0.72f, 0.95f, 1.35f), vec3(rods));
}

/// Linear -> sRGB (IEC 61966-2-1).
GLSL_FUNCTION float encodedChannel(float x) {
    return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}
GLSL_FUNCTION vec3 encodedForScreen(vec3 linear) {
    return vec3(encodedChannel(linear.x), encodedChannel(linear.y), encodedChannel(linear.z));
}

/// Even noise 0..1 of a pixel and a frame (a PCG hash: O'Neill 2014).
GLSL_FUNCTION float pixelNoise(uvec2 pixel, uint frame) {
    uint state = (pixel.x + 4096u * pixel.y + 16777259u * frame) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0f;
}

/// Triangular noise of -1..1 steps of an 8-bit screen: breaks bands without raising the mean.
GLSL_FUNCTION float ditherNoise(uvec2 pixel, uint frame) {
    return (pixelNoise(pixel, frame) + pixelNoise(pixel, frame + 91u) - 1.0f) / 255.0f;
}

GLSL_END
#endif
