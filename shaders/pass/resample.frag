#version 450 core
// Panorama and dome: takes what one square view of 90 degrees drew, where this pixel's ray goes through it.
#include "shared/frame.glsl.h"
#include "lib/camera.glsl"

layout(binding = 0) uniform sampler2D viewColour;
layout(binding = 1) uniform sampler2D viewDepth;
uniform mat3 viewFromWorld;
uniform float tangentHalf;  // of the square view, a little more than 1

layout(location = 0) out vec4 colour;

void main() {
    vec3 ray = viewFromWorld * rayDirection(gl_FragCoord.xy);
    float along = -ray.z;
    if (!insidePicture(gl_FragCoord.xy) || along < max(abs(ray.x), abs(ray.y)) * 0.99999) discard;
    vec2 uv = 0.5 + 0.5 * ray.xy / (along * tangentHalf);
    float depth = textureLod(viewDepth, uv, 0.0).r;
    colour = textureLod(viewColour, uv, 0.0);
    gl_FragDepth = depth <= 0.0 ? 0.0 : depth * along;  // near / distance along the ray
}
