#version 450 core
// Drops and flakes near the camera, over the finished picture.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/precipitation.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image2D colourTarget;
layout(binding = 0) uniform sampler2D depthTarget;
uniform vec4 axisAndFallen;  // xyz: unit, where the drops go to relative to the camera; w: m they have gone
uniform vec4 dropShape;      // x: streak, m; y: width, m; z: share of cells with a drop; w: opacity of a streak

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colourTarget)))) return;
    vec2 centre = vec2(pixel) + 0.5;
    if (!insidePicture(centre)) return;
    vec3 direction = rayDirection(centre);
    float reach = distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, centre);
    float clear = 1.0;
    float radius = 1.4;
    for (int sheet = 0; sheet < 7; ++sheet) {
        clear *= 1.0 - dropShape.w * dropCover(direction, axisAndFallen.xyz, radius, axisAndFallen.w, dropShape.x,
                                               dropShape.y, dropShape.z, frame.projection.w, reach);
        radius *= 1.65;
    }
    if (clear >= 1.0) return;
    vec4 colour = imageLoad(colourTarget, pixel);
    vec3 light = 0.8 * frame.skyIrradiance.rgb / 3.14159265 * frame.exposure.x;  // a lens that shows the sky
    imageStore(colourTarget, pixel, vec4(mix(light, colour.rgb, clear), colour.a));
}
