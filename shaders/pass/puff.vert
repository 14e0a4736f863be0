#version 450 core
// A soft ball of smoke: a square that faces the camera.
#include "shared/frame.glsl.h"
#include "lib/curvature.glsl"

struct Ball {
    vec4 place;   // relative to the camera, radius
    vec4 colour;  // albedo, opacity in the middle
};
layout(std430, binding = 5) readonly buffer PuffBlock { Ball balls[]; } puffs;

layout(location = 0) out vec2 across;  // -1..1
layout(location = 1) flat out vec4 colour;
layout(location = 2) out vec3 relative;
layout(location = 3) flat out float radius;

void main() {
    Ball ball = puffs.balls[gl_InstanceID];
    across = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    colour = ball.colour;
    radius = ball.place.w;
    vec3 middle = curvedFromFlat(ball.place.xyz, frame.cameraWorld.y);
    relative = middle + mat3(frame.worldFromCamera) * vec3(across * radius, 0.0);
    gl_Position = frame.clipFromWorld * vec4(relative, 1.0);
}
