#version 450 core
// HDR picture and bloom -> screen-encoded colour, not yet dithered. Luma in alpha, for the edges.
#include "shared/exposure_block.glsl.h"
#include "lib/camera.glsl"
#include "lib/exposure.glsl"
#include "lib/tone.glsl"

layout(location = 0) in vec2 uv;
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform sampler2D bloom;  // of the whole picture
uniform float bloomShare;

layout(location = 0) out vec4 colour;

void main() {
    vec3 light = mix(textureLod(picture, uv, 0.0).rgb, textureLod(bloom, pictureUnit(gl_FragCoord.xy), 0.0).rgb, bloomShare);
    light = seenInTheDark(light, kSunLux / frame.exposure.x);
    vec3 encoded = encodedForScreen(toneMapped(light * (measured.shown / frame.exposure.x)));
    colour = vec4(encoded, dot(encoded, vec3(0.299, 0.587, 0.114)));
}
