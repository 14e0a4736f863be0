#version 450 core
// A vertex of the menus: pixels from the upper left.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 tint;

uniform vec4 box;  // left, top, width, height of the display in the lists' units

layout(location = 0) out vec2 fragmentUv;
layout(location = 1) out vec4 fragmentTint;

void main() {
    fragmentUv = uv;
    fragmentTint = tint;
    vec2 unit = (position - box.xy) / box.zw;
    gl_Position = vec4(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y, 0.0, 1.0);
}
