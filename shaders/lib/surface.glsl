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

/// Reflectance of the facets together under even light from everywhere, as a pair: straight * x + y. Polynomials fitted
/// to the integral for cosines from 0.05 and roughness from 0.1, on average within 0.02 (a test integrates again).
GLSL_FUNCTION vec2 evenReflectance(float cosEye, float roughness) {
    float c = max(cosEye, 0.05f), r = max(roughness, 0.1f);
    float x = 0.1182f + c * (2.435f - 1.5866f * c) + r * (1.3535f - 0.558f * r) +
              c * r * (-3.5891f + 2.4725f * c - 0.3153f * r);
    float grazing = (1.0f - c) * (1.0f - c);
    float y = grazing * grazing * (1.098f + r * (-2.4071f + 1.3634f * r));
    return vec2(clamp(x, 0.0f, 1.0f), max(y, 0.0f));
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
    // What is mirrored on the way in or out does not come back as diffuse light.
    vec3 inside = (vec3(1.0f) - fresnel(material.straight, cosLight)) * (vec3(1.0f) - fresnel(material.straight, cosEye));
    return (material.diffuse * inside / kSurfacePi + mirror * facets) * cosLight;
}

GLSL_END
#endif
