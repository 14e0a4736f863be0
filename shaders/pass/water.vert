#version 450 core
#include "shaders/lib/camera.glsl"
#include "shaders/lib/terrain_mesh.glsl"

layout(location = 0) in uvec4 vertex;  // cell east, cell north, 1 for the skirt's foot

out vec3 world;       // relative to the camera, bent
out vec2 place;       // m from the chunk's corner
out vec4 clipNow;
out vec4 clipBefore;

void main() {
    world = meshVertex(ivec2(vertex.xy), land.levels.x, place);
    clipNow = frame.clipFromWorld * vec4(world, 1.0);
    clipBefore = frame.previousClipFromWorld * vec4(world, 1.0);
    gl_Position = clipNow;
}
