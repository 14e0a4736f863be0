#version 450 core
// Smoke: thick in the middle, lit by sun and sky, behind the air between; fades where land cuts through it.
#include "lib/camera.glsl"
#include "lib/cloud_shadow.glsl"
#include "lib/sky_tables.glsl"

layout(location = 0) in vec2 across;
layout(location = 1) flat in vec4 colour;
layout(location = 2) in vec3 relative;
layout(location = 3) flat in float radius;
layout(binding = 0) uniform sampler2D depthTarget;

layout(location = 0) out vec4 result;

void main() {
    float r2 = dot(across, across);
    if (r2 >= 1.0) discard;
    float distance = length(relative);
    float behind = distanceOfDepth(texelFetch(depthTarget, ivec2(gl_FragCoord.xy), 0).r, gl_FragCoord.xy) - distance;
    float thickness = (1.0 - r2) * (1.0 - r2) * clamp(0.5 + 0.5 * behind / radius, 0.0, 1.0);
    vec3 normal = mat3(frame.worldFromCamera) * vec3(across, sqrt(1.0 - r2));
    float sunward = 0.3 + 0.25 * dot(normal, frame.sunDirection.xyz);  // light scattered inside softens the shade
    vec3 sun = frame.sunIrradiance.rgb * sunward * cloudShadow(vec3(relative.x, frame.cameraWorld.y + relative.y, relative.z));
    vec3 around = mix(frame.groundIrradiance.rgb, frame.skyIrradiance.rgb, 0.5 + 0.5 * normal.y) + 0.4 * frame.moonIrradiance.rgb;
    AirLight air = airBefore(relative / distance, distance);
    vec3 radiance = colour.rgb * (sun + around) * (1.0 / 3.14159265) * air.transmittance + air.radiance;
    result = vec4(radiance * frame.exposure.x, 1.0 - exp(-3.0 * colour.a * thickness));
}
