#version 450 core
// Rain on the glass of the cockpit, over the finished picture.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/windscreen.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image2D colourTarget;
layout(binding = 0) uniform sampler2D depthTarget;
uniform mat3 bodyFromWorld;
uniform vec3 cabin;  // m from the eye: ahead, up or down, aside
uniform vec4 water;  // x: wetness 0..1; yz: lib/windscreen's `slid`, m; w: s

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colourTarget)))) return;
    vec2 centre = vec2(pixel) + 0.5;
    if (!insidePicture(centre)) return;
    vec3 direction = rayDirection(centre);
    vec3 inBody = bodyFromWorld * direction;
    vec3 seen = inBody * distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, centre);
    if (seen.x < cabin.x && abs(seen.y) < cabin.y && abs(seen.z) < cabin.z) return;
    GlassDrop drop = glassDrop(glassPlace(inBody), water.x, water.yz, water.w);
    if (drop.cover <= 0.0) return;
    vec2 lens = glassLens(drop.slope, direction.y);
    vec3 light = mix(frame.groundIrradiance.rgb, frame.skyIrradiance.rgb, lens.x) * (lens.y / 3.14159265 * frame.exposure.x);
    vec4 colour = imageLoad(colourTarget, pixel);
    imageStore(colourTarget, pixel, vec4(mix(colour.rgb, light, 0.85 * drop.cover), colour.a));
}
