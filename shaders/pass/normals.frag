#version 450 core
// Debug view: lines in the colour of their direction, equally bright at every exposure.
#include "shared/frame.glsl.h"

layout(location = 0) in vec3 lineColour;
layout(location = 0) out vec4 colour;

void main() { colour = vec4(lineColour * frame.exposure.x / max(frame.exposure.y, 1e-12), 1.0); }
