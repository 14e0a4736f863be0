#version 450 core
// Menus: a tint times the font's coverage.
layout(location = 0) in vec2 fragmentUv;
layout(location = 1) in vec4 fragmentTint;
layout(binding = 0) uniform sampler2D font;
layout(location = 0) out vec4 colour;

void main() { colour = vec4(fragmentTint.rgb, fragmentTint.a * texture(font, fragmentUv).r); }
