#version 450 core
// Debug view: the land's vertices with their normals, for normals.geom.
#include "shaders/lib/terrain_mesh.glsl"

layout(location = 0) in uvec4 vertex;  // cell east, cell north, 1 for the skirt's foot

layout(location = 0) out vec3 fragmentRelative;
layout(location = 1) out vec3 fragmentNormal;

void main() {
    vec2 place;
    fragmentRelative = meshVertex(ivec2(vertex.xy), kLandItself, place);
    fragmentNormal = texture(chunkSamples, (place / chunkPlace.z * chunkPlace.w + 0.5) * chunkMorph.z).yzw;
    gl_Position = vec4(fragmentRelative, 1.0);
}
