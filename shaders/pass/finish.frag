#version 450 core
// Smooths edges, scales to the window, dithers. An edge is where luma differs across a pixel's four corners; there the
// colour is averaged along the edge, not across it.
#include "lib/camera.glsl"
#include "lib/tone.glsl"

layout(location = 0) in vec2 uv;
layout(binding = 0) uniform sampler2D picture;  // luma in alpha
uniform float smoothing;                        // 0 or 1
uniform float dither;                           // 0 or 1

layout(location = 0) out vec4 colour;

vec3 smoothed(vec2 texel) {
    vec4 here = textureLod(picture, uv, 0.0);
    float nw = textureLod(picture, uv + vec2(-0.5, 0.5) * texel, 0.0).a, ne = textureLod(picture, uv + 0.5 * texel, 0.0).a;
    float sw = textureLod(picture, uv - 0.5 * texel, 0.0).a, se = textureLod(picture, uv + vec2(0.5, -0.5) * texel, 0.0).a;
    float least = min(min(nw, ne), min(min(sw, se), here.a)), most = max(max(nw, ne), max(max(sw, se), here.a));
    if (most - least < max(0.03, 0.125 * most)) return here.rgb;
    vec2 along = vec2((sw + se) - (nw + ne), (nw + sw) - (ne + se));
    along /= max(min(abs(along.x), abs(along.y)), 0.02 * (nw + ne + sw + se) + 0.004);
    along = clamp(along, vec2(-6.0), vec2(6.0)) * texel;
    vec3 near = 0.5 * (textureLod(picture, uv - along / 6.0, 0.0).rgb + textureLod(picture, uv + along / 6.0, 0.0).rgb);
    vec3 wide = 0.5 * near + 0.25 * (textureLod(picture, uv - 0.5 * along, 0.0).rgb + textureLod(picture, uv + 0.5 * along, 0.0).rgb);
    float luma = dot(wide, vec3(0.299, 0.587, 0.114));
    return luma < least || luma > most ? near : wide;
}

void main() {
    vec2 texel = 1.0 / vec2(textureSize(picture, 0));
    vec3 result = smoothing > 0.5 ? smoothed(texel) : textureLod(picture, uv, 0.0).rgb;
    uint number = frame.mode.w == 1 ? 0u : uint(frame.mode.z);  // a still is the same picture each time
    float noise = dither * ditherNoise(uvec2(picturePixel(gl_FragCoord.xy)), number);
    colour = vec4(result + noise, 1.0);
}
