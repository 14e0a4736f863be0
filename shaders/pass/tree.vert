#version 450 core
// A tree is an ellipsoid of leaves; a square that faces the camera covers its outline exactly.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/curvature.glsl"
#include "shaders/shared/terrain.glsl.h"

layout(location = 0) in vec4 tree;  // east, north from the tile's corner; altitude of the foot; height
layout(location = 1) in vec2 kind;  // x: 1 conifer; y: tint

uniform vec2 tileCorner;  // m east and north of the camera
uniform float treeReach;  // m

out vec3 world;           // relative to the camera, bent
out vec2 across;          // -1..1 over the square
out vec4 clipNow;
out vec4 clipBefore;
flat out vec3 middle;     // of the crown
flat out vec3 right;
flat out vec3 above;
flat out vec4 about;      // conifer, tint, altitude, how level the view is
flat out vec2 offset;     // east, north of the camera

void main() {
    offset = tileCorner + tree.xy;
    float far = length(vec3(offset, tree.z - land.levels.w));
    float height = tree.w * clamp((treeReach - far) / (0.25 * treeReach), 0.0, 1.0);
    float wide = height * mix(0.38, 0.20, kind.x);
    float tall = 0.5 * height;
    vec3 foot = curvedFromFlat(vec3(offset.x, tree.z - land.levels.w, -offset.y), land.levels.w);
    middle = foot + vec3(0.0, tall * 1.04, 0.0);
    vec3 toward = normalize(middle);
    right = normalize(cross(toward, abs(toward.y) > 0.999 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    above = cross(right, toward);
    float level = 1.0 - toward.y * toward.y;
    float outline = sqrt(tall * tall * level + wide * wide * (1.0 - level));
    across = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    right *= wide;
    above *= outline;
    world = middle + right * across.x + above * across.y;
    about = vec4(kind, tree.z, level);
    clipNow = frame.clipFromWorld * vec4(world, 1.0);
    clipBefore = frame.previousClipFromWorld * vec4(world, 1.0);
    gl_Position = clipNow;
}
