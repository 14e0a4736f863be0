#version 450 core
// A model seen from the light.
layout(location = 0) in vec3 position;
uniform mat4 clipFromNode;

void main() { gl_Position = clipFromNode * vec4(position, 1.0); }
