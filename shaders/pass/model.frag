#version 450 core
// A metallic-roughness surface under the frame's light.
#include "shaders/lib/cloud_shadow.glsl"
#include "shared/frame.glsl.h"
#include "lib/camera.glsl"
#include "lib/cloud_shadow.glsl"
#include "lib/model_shadow.glsl"
#include "lib/scene_light.glsl"

layout(location = 0) in vec3 fragmentRelative;
layout(location = 1) in vec3 fragmentNormal;
layout(location = 2) in vec2 fragmentUv;
layout(location = 3) in vec4 fragmentTangent;
layout(location = 4) in vec3 fragmentFlat;
layout(location = 5) in vec4 clipNow;
layout(location = 6) in vec4 clipBefore;

layout(binding = 0) uniform sampler2D baseColourTexture;
layout(binding = 1) uniform sampler2D metallicRoughnessTexture;
layout(binding = 2) uniform sampler2D normalTexture;
layout(binding = 3) uniform sampler2D occlusionTexture;
layout(binding = 4) uniform sampler2D emissiveTexture;

uniform vec4 baseColour;
uniform vec4 factors;      // metallic, roughness, normal scale, occlusion strength
uniform vec3 emissive;     // as bright on the screen as this, whatever the exposure
uniform float alphaCutoff; // below it: a hole

layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

vec3 shadingNormal() {
    vec3 n = normalize(fragmentNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 t = fragmentTangent.xyz - n * dot(n, fragmentTangent.xyz);
    if (dot(t, t) < 1e-8) return n;
    t = normalize(t);
    vec3 map = texture(normalTexture, fragmentUv).xyz * 2.0 - 1.0;
    vec3 b = cross(n, t) * fragmentTangent.w;
    return normalize(t * map.x * factors.z + b * map.y * factors.z + n * map.z);
}

void main() {
    vec4 base = baseColour * texture(baseColourTexture, fragmentUv);
    if (base.a < alphaCutoff) discard;
    vec3 rough = texture(metallicRoughnessTexture, fragmentUv).rgb;
    SurfaceMaterial material = surfaceMaterial(base.rgb, factors.x * rough.b, factors.y * rough.g);
    float open = 1.0 + factors.w * (texture(occlusionTexture, fragmentUv).r - 1.0);
    vec3 eye = normalize(-fragmentRelative);
    vec3 place = vec3(fragmentFlat.x, fragmentFlat.y + frame.cameraWorld.y, fragmentFlat.z);
    vec3 radiance = litSurface(material, shadingNormal(), eye, modelShadow(fragmentFlat) * cloudShadow(place), open);
    radiance += emissive * texture(emissiveTexture, fragmentUv).rgb / max(frame.exposure.y, 1e-12);
    colour = vec4(radiance * frame.exposure.x, base.a);
    motion = motionOf(clipNow, clipBefore);
}
