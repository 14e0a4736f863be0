// How opaque surfaces reflect light: glTF's metallic-roughness material with the microfacet model of Trowbridge and
// Reitz (GGX; Walter et al. 2007), Smith's height-correlated shadowing (Heitz 2014) and Schlick's Fresnel term. All
// cosines are of unit vectors; radiance out per unit of irradiance on a plane that faces the light, 1/sr.
#ifndef LUFTPOST_SURFACE_GLSL
#define LUFTPOST_SURFACE_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_CONST float kSurfacePi = 3.14159265f;

/// Density of microfacet normals at cosine `cosHalf` to the surface's normal; integrates to 1 over the projected
/// hemisphere. alpha is roughness squared.
GLSL_FUNCTION float facetDensity(float cosHalf, float alpha) {
    float a2 = alpha * alpha;
    float d = (cosHalf * a2 - cosHalf) * cosHalf + 1.0f;
    return a2 / (kSurfacePi * d * d);
}

/// Smith's shadowing and masking over 4 cosEye cosLight.
GLSL_FUNCTION float facetVisibility(float cosEye, float cosLight, float alpha) {
    float a2 = alpha * alpha;
    float byEye = cosLight * sqrt(cosEye * cosEye * (1.0f - a2) + a2);
    float byLight = cosEye * sqrt(cosLight * cosLight * (1.0f - a2) + a2);
    return 0.5f / max(byEye + byLight, 1e-6f);
}

/// Reflectance of facets at cosine `cosine` between light and facet.
GLSL_FUNCTION vec3 fresnel(vec3 straight, float cosine) {
    float x = 1.0f - cosine;
    float x2 = x * x;
    return straight + (vec3(1.0f) - straight) * (x2 * x2 * x);
}

/// Reflectance of the facets together under even light from everywhere, as a pair: straight * x + y. The fit of Karis,
/// "Physically Based Shading on Mobile" (2014), after Lazarov (SIGGRAPH 2013); a test integrates it.
GLSL_FUNCTION vec2 evenReflectance(float cosEye, float roughness) {
    float smoothness = 1.0f - roughness;
    float grazing = min(smoothness * smoothness, exp2(-9.28f * cosEye)) * smoothness + 0.0425f - 0.0275f * roughness;
    return vec2(1.04f - 0.572f * roughness - 1.04f * grazing, -0.04f + 0.022f * roughness + 1.04f * grazing);
}

struct SurfaceMaterial {
    vec3 diffuse;    // albedo of what light that goes in comes back as
    vec3 straight;   // reflectance straight on
    float roughness; // glTF's, 0.045..1
};

/// glTF's parameters -> diffuse and specular colour.
GLSL_FUNCTION SurfaceMaterial surfaceMaterial(vec3 baseColour, float metallic, float roughness) {
    SurfaceMaterial material;
    material.diffuse = baseColour * (1.0f - metallic);
    material.straight = mix(vec3(0.04f), baseColour, vec3(metallic));
    material.roughness = clamp(roughness, 0.045f, 1.0f);
    return material;
}

/// Radiance toward `eye` per unit irradiance of a light at `light` (on a plane facing it). All unit vectors that point
/// away from the surface.
GLSL_FUNCTION vec3 reflectedLight(SurfaceMaterial material, vec3 normal, vec3 eye, vec3 light) {
    float cosLight = dot(normal, light);
    if (cosLight <= 0.0f) return vec3(0.0f);
    float cosEye = max(dot(normal, eye), 1e-4f);
    vec3 halfway = normalize(eye + light);
    float alpha = material.roughness * material.roughness;
    vec3 mirror = fresnel(material.straight, clamp(dot(halfway, light), 0.0f, 1.0f));
    float facets = facetDensity(clamp(dot(normal, halfway), 0.0f, 1.0f), alpha) * facetVisibility(cosEye, cosLight, alpha);
    return (material.diffuse * (vec3(1.0f) - mirror) / kSurfacePi + mirror * facets) * cosLight;
}

GLSL_END
#endif
