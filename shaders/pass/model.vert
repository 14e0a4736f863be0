#version 450 core
// A vertex of a model: placed, bent with the Earth, with its motion on the screen.
#include "shared/frame.glsl.h"
#include "lib/curvature.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 tangent;

uniform mat4 worldFromNode;          // relative to the camera
uniform mat4 previousWorldFromNode;  // relative to this frame's camera
uniform mat3 normalFromNode;

layout(location = 0) out vec3 fragmentRelative;  // bent
layout(location = 1) out vec3 fragmentNormal;
layout(location = 2) out vec2 fragmentUv;
layout(location = 3) out vec4 fragmentTangent;
layout(location = 4) out vec3 fragmentFlat;      // not bent
layout(location = 5) out vec4 clipNow;
layout(location = 6) out vec4 clipBefore;

void main() {
    fragmentFlat = (worldFromNode * vec4(position, 1.0)).xyz;
    fragmentRelative = curvedFromFlat(fragmentFlat, frame.cameraWorld.y);
    vec3 before = (previousWorldFromNode * vec4(position, 1.0)).xyz;
    fragmentNormal = normalFromNode * normal;
    fragmentTangent = vec4(mat3(worldFromNode) * tangent.xyz, tangent.w);
    fragmentUv = uv;
    clipNow = frame.clipFromWorld * vec4(fragmentRelative, 1.0);
    clipBefore = frame.previousClipFromWorld * vec4(curvedFromFlat(before, frame.cameraWorld.y), 1.0);
    gl_Position = clipNow;
}
