#version 450 core
// Debug view: each triangle's three normals as lines, a fiftieth of their distance long. The vertex stage before it
// gives at location 0 the position relative to the camera and at location 1 the normal.
#include "shared/frame.glsl.h"

layout(triangles) in;
layout(line_strip, max_vertices = 6) out;

layout(location = 0) in vec3 fragmentRelative[];
layout(location = 1) in vec3 fragmentNormal[];

layout(location = 0) out vec3 lineColour;

void main() {
    if (length(fragmentRelative[0]) > 3000.0) return;  // farther lines are finer than a pixel
    for (int i = 0; i < 3; ++i) {
        vec3 normal = normalize(fragmentNormal[i]);
        vec3 tip = fragmentRelative[i] + normal * length(fragmentRelative[i]) * 0.02;
        lineColour = normal * 0.5 + 0.5;
        gl_Position = frame.clipFromWorld * vec4(fragmentRelative[i], 1.0);
        EmitVertex();
        gl_Position = frame.clipFromWorld * vec4(tip, 1.0);
        EmitVertex();
        EndPrimitive();
    }
}
