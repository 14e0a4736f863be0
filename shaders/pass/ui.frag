#version 450 core
// Menus: a tint times the font's coverage, or times the photograph.
layout(location = 0) in vec2 fragmentUv;
layout(location = 1) in vec4 fragmentTint;
layout(binding = 0) uniform sampler2D font;
layout(binding = 1) uniform sampler2D photo;
uniform int photograph;  // 1: the list's texture is the photograph
layout(location = 0) out vec4 colour;

void main() {
    if (photograph == 1)
        colour = fragmentTint * texture(photo, fragmentUv);
    else
        colour = vec4(fragmentTint.rgb, fragmentTint.a * texture(font, fragmentUv).r);
}
