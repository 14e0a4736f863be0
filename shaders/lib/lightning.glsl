// Lightning: the bent channel under a cloud, and the light it throws around itself.
#ifndef LUFTPOST_LIGHTNING_GLSL
#define LUFTPOST_LIGHTNING_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_CONST int kChannelJoints = 16;  // stretches of a channel, a power of two

GLSL_FUNCTION float strokeUnit(float seed, float k) {
    uint x = uint(seed) * 747796405u + uint(k) * 2891336453u;
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return float((x ^ (x >> 16u)) >> 8u) * (1.0f / 16777216.0f);
}

/// The k-th of kChannelJoints + 1 joints between `from` and `to`, m: halves whose middles are pushed aside, less from half to half.
GLSL_FUNCTION vec3 channelJoint(vec3 from, vec3 to, float seed, int k) {
    vec3 a = from;
    vec3 b = to;
    int low = 0;
    int high = kChannelJoints;
    float reach = 0.11f * distance(from, to);
    for (int depth = 0; depth < 5; ++depth) {
        if (k == low) return a;
        if (k == high) return b;
        int middle = (low + high) / 2;
        float key = float(low * 64 + high);
        vec3 push = vec3(strokeUnit(seed, key) - 0.5f, 0.3f * (strokeUnit(seed, key + 8192.0f) - 0.5f), strokeUnit(seed, key + 16384.0f) - 0.5f);
        vec3 m = 0.5f * (a + b) + 2.0f * reach * push;
        if (k < middle) {
            high = middle;
            b = m;
        } else {
            low = middle;
            a = m;
        }
        reach *= 0.55f;
    }
    return k == low ? a : b;
}

/// Least distance between a ray from the origin and a stretch from `a` to `b`, as an angle at the eye, rad; `reach`: m along the ray there.
GLSL_FUNCTION float angleToStretch(vec3 direction, vec3 a, vec3 b, OUT(float) reach) {
    vec3 stretch = b - a;
    vec3 across = a - direction * dot(a, direction);
    vec3 run = stretch - direction * dot(stretch, direction);
    float t = clamp(-dot(across, run) / max(dot(run, run), 1e-6f), 0.0f, 1.0f);
    vec3 nearest = a + stretch * t;
    reach = dot(nearest, direction);
    return reach > 0.0f ? length(across + run * t) / reach : 4.0f;
}

/// Irradiance at `away` m from a light of an intensity inside scattering cloud: softened near it, and lost in what lies farther.
GLSL_FUNCTION float strokeIrradiance(float intensity, float away) {
    return intensity / (away * away + 600.0f * 600.0f) * exp(-away / 1800.0f);
}

GLSL_END
#endif
