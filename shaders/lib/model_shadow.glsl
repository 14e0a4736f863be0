// The shadow of models (the aircraft) on the ground and on themselves. GLSL only.
#ifndef LUFTPOST_MODEL_SHADOW_GLSL
#define LUFTPOST_MODEL_SHADOW_GLSL
#include "shaders/shared/frame.glsl.h"

layout(binding = 14) uniform sampler2D modelShadowMap;  // depth toward the sun, 1 nearest

/// Share of the sun's (or moon's) disc that models leave at `relative` (not bent), 0..1. The edge is as soft as the
/// light's disc makes it: the farther below the model, the wider.
float modelShadow(vec3 relative) {
    if (frame.modelShadow.x <= 0.0) return 1.0;
    vec3 place = (frame.modelShadowFromWorld * vec4(relative, 1.0)).xyz;
    float metresPerUnit = frame.modelShadow.y;               // across the map
    float below = (0.5 - place.z) * frame.modelShadow.z;     // metres behind the model's middle
    float blur = clamp(max(below, 0.0) * frame.modelShadow.w, 0.02, 2.5) / metresPerUnit;
    if (any(greaterThan(abs(place.xy - 0.5), vec2(0.5 + blur))) || place.z > 1.0) return 1.0;
    float bias = 0.12 / frame.modelShadow.z;
    float turn = 6.2832 * fract(52.9829189 * fract(dot(gl_FragCoord.xy + frame.tile.xy, vec2(0.06711056, 0.00583715))));
    float lit = 0.0;
    for (int i = 0; i < 12; ++i) {
        float r = sqrt((float(i) + 0.5) / 12.0) * blur;
        float a = 2.3999632 * float(i) + turn;
        vec2 at = place.xy + r * vec2(cos(a), sin(a));
        bool inside = all(lessThan(abs(at - 0.5), vec2(0.5)));
        lit += inside && textureLod(modelShadowMap, at, 0.0).r > place.z + bias ? 0.0 : 1.0;
    }
    return lit / 12.0;
}
#endif
