// Bows, glory and halos: where they stand and how bright they are. What drops, droplets and columns do is in a table of true phase
// functions (sky/particle_phase), read here by the scattering angle; plates that float level are a formula.
#ifndef LUFTPOST_SKY_OPTICS_GLSL
#define LUFTPOST_SKY_OPTICS_GLSL
#include "shaders/shared/language.glsl.h"
#include "shaders/shared/sampler2d.glsl.h"
GLSL_BEGIN

GLSL_CONST float kDegree = 0.0174532925f;
GLSL_CONST float kRainRow = 0.0f;
GLSL_CONST float kDropletRow = 1.0f;
GLSL_CONST float kIceRow = 2.0f;
GLSL_CONST float kPhaseRows = 3.0f;

/// 1/sr. `cosine` of the scattering angle: toward the light it is 1.
GLSL_FUNCTION vec3 tabledPhase(sampler2D table, vec2 size, float cosine, float row) {
    float share = acos(clamp(cosine, -1.0f, 1.0f)) / (180.0f * kDegree);
    vec4 v = textureLod(table, vec2((share * (size.x - 1.0f) + 0.5f) / size.x, (row + 0.5f) / kPhaseRows), 0.0f);
    return vec3(v.x, v.y, v.z);
}

/// What the bows add to the light that rain sends, 1/sr; less than nothing never: measured from Alexander's dark band between them.
GLSL_FUNCTION vec3 bowExcess(sampler2D table, vec2 size, float cosine) {
    float angle = acos(clamp(cosine, -1.0f, 1.0f)) / kDegree;
    float near = clamp((angle - 112.0f) / 8.0f, 0.0f, 1.0f);
    if (near <= 0.0f) return vec3(0.0f);
    vec3 band = tabledPhase(table, size, cos(133.0f * kDegree), kRainRow);
    return near * max(tabledPhase(table, size, cosine, kRainRow) - band, vec3(0.0f));
}

/// By how much droplets send more than `smoothPhase`, 1/sr: cloud bow and glory.
GLSL_FUNCTION vec3 gloryExcess(sampler2D table, vec2 size, float cosine, float smoothPhase) {
    float angle = acos(clamp(cosine, -1.0f, 1.0f)) / kDegree;
    float near = clamp((angle - 118.0f) / 12.0f, 0.0f, 1.0f);
    if (near <= 0.0f) return vec3(0.0f);
    return near * (tabledPhase(table, size, cosine, kDropletRow) - vec3(smoothPhase));
}

/// By how much columns in all directions send more than a smooth curve through 16 and 40 degrees, 1/sr: the halo of 22 degrees, dark
/// inside and red at its inner edge.
GLSL_FUNCTION vec3 haloExcess(sampler2D table, vec2 size, float cosine) {
    float angle = acos(clamp(cosine, -1.0f, 1.0f)) / kDegree;
    if (angle < 16.0f || angle > 40.0f) return vec3(0.0f);
    float share = (angle - 16.0f) / 24.0f;
    vec3 inner = max(tabledPhase(table, size, cos(16.0f * kDegree), kIceRow), vec3(1e-4f));
    vec3 outer = max(tabledPhase(table, size, cos(40.0f * kDegree), kIceRow), vec3(1e-4f));
    vec3 even = exp(mix(log(inner), log(outer), share));
    return tabledPhase(table, size, cosine, kIceRow) - even;
}

/// Azimuth between sun and sun dog at the sun's elevation (its sine), rad, for ice of an index: the least turn through an upright
/// prism of 60 degrees, whose index for slanting light is Bravais'. Negative: the sun is too high for one (over 61 degrees).
GLSL_FUNCTION float sunDogAzimuth(float sineElevation, float index) {
    float level2 = 1.0f - sineElevation * sineElevation;
    float bravais = sqrt((index * index - sineElevation * sineElevation) / max(level2, 1e-6f));
    return bravais < 2.0f ? 2.0f * asin(0.5f * bravais) - 60.0f * kDegree : -1.0f;
}

/// What level plates send toward the eye from beside the sun, about 1/sr: a sharp inner edge, red first, and a tail away from the sun, as high
/// as the sun. `direction`, `toward`: world, unit.
GLSL_FUNCTION vec3 sunDogs(vec3 direction, vec3 toward) {
    float up = asin(clamp(direction.y, -1.0f, 1.0f)) - asin(clamp(toward.y, -1.0f, 1.0f));
    float wobble = 0.8f * kDegree;
    float level = exp(-0.5f * up * up / (wobble * wobble));
    if (level < 1e-3f || toward.y < -0.02f) return vec3(0.0f);
    float across = direction.x * toward.z - direction.z * toward.x;
    float along = direction.x * toward.x + direction.z * toward.z;
    float azimuth = abs(atan(across, along));
    vec3 index = vec3(1.3085f, 1.3112f, 1.3145f);  // of ice at 615, 545 and 465 nm
    vec3 result = vec3(0.0f);
    for (int i = 0; i < 3; ++i) {
        float least = sunDogAzimuth(toward.y, index[i]);
        if (least < 0.0f) continue;
        float beyond = (azimuth - least) / kDegree;
        float edge = clamp(0.5f + beyond / 0.54f, 0.0f, 1.0f);  // the sun's disc
        result[i] = edge / sqrt(1.0f + max(beyond, 0.0f) / 0.35f) * exp(-max(beyond, 0.0f) / 9.0f);
    }
    return level * result;
}

GLSL_END
#endif
