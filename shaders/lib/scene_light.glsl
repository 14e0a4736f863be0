// The light of the frame on a surface: sun, moon, sky from above, ground from below. GLSL only.
#ifndef LUFTPOST_SCENE_LIGHT_GLSL
#define LUFTPOST_SCENE_LIGHT_GLSL
#include "shaders/shared/frame.glsl.h"
#include "shaders/lib/surface.glsl"

/// Irradiance of sky and ground on a plane that faces `normal`.
vec3 surroundingIrradiance(vec3 normal) {
    return mix(frame.groundIrradiance.rgb, frame.skyIrradiance.rgb, 0.5 + 0.5 * normal.y);
}

/// Radiance that a surface as rough as this sees in its mirror direction: sky above, ground below, the edge blurred.
vec3 surroundingRadiance(vec3 direction, float roughness) {
    float blur = 0.05 + 0.6 * roughness;
    float sky = smoothstep(-blur, blur, direction.y);
    return mix(frame.groundIrradiance.rgb, frame.skyIrradiance.rgb, sky) / kSurfacePi;
}

/// Radiance toward `eye` of a surface under the whole frame's light. `sunShare`: what shadows leave of sun and moon;
/// `open`: what the surface's own hollows leave of the surroundings.
vec3 litSurface(SurfaceMaterial material, vec3 normal, vec3 eye, float sunShare, float open) {
    vec3 direct = reflectedLight(material, normal, eye, frame.sunDirection.xyz) * frame.sunIrradiance.rgb +
                  reflectedLight(material, normal, eye, frame.moonDirection.xyz) * frame.moonIrradiance.rgb;
    float cosEye = clamp(dot(normal, eye), 0.0, 1.0);
    vec2 even = evenReflectance(cosEye, material.roughness);
    vec3 mirror = material.straight * even.x + even.y;
    vec3 around = material.diffuse * (1.0 - mirror) * surroundingIrradiance(normal) / kSurfacePi +
                  mirror * surroundingRadiance(reflect(-eye, normal), material.roughness);
    return direct * sunShare + around * open;
}
#endif
