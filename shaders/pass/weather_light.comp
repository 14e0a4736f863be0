#version 450 core
// What the weather adds to the finished picture: shafts of rain and snow with the rainbow in them, the cloud bow and the glory on clouds,
// halo and sun dogs in sheets of ice, lightning.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/cloud_store.glsl"
#include "shaders/lib/weather_light.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image2D colourTarget;
layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 1) uniform sampler2D cloudFacts;
layout(binding = 3) uniform sampler2D fallenLight;  // of falling.comp, one texel for `block` x `block` pixels
layout(binding = 4) uniform sampler2D fallenLit;
uniform int block;

// Whether anything falls or flashes: where nothing does, software GL need not pay for it.
#ifndef STORMY
#define STORMY true
#endif

float cloudAway(ivec2 pixel) {
    return unpackedFacts(texelFetch(cloudFacts, pixel, 0)).distance;
}
float landAway(ivec2 pixel) { return distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, vec2(pixel) + 0.5); }

/// The texels around a pixel, those the more that see land and cloud as far away as it does.
Fallen fallenAt(ivec2 pixel, LightRay ray) {
    ivec2 size = textureSize(fallenLight, 0);
    vec2 at = (vec2(pixel) - 0.5 * float(block - 1)) / float(block);
    ivec2 corner = ivec2(floor(at));
    vec2 share = at - vec2(corner);
    vec4 light = vec4(0.0);
    vec4 lit = vec4(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 side = ivec2(i & 1, i >> 1);
        ivec2 texel = clamp(corner + side, ivec2(0), size - 1);
        ivec2 centre = min(texel * block + block / 2, imageSize(colourTarget) - 1);
        float land = abs(log2(landAway(centre) / ray.land));
        float cloud = (1.0 - ray.through) * abs(log2(max(cloudAway(centre), 1.0) / max(ray.cloud, 1.0)));
        vec2 near = mix(1.0 - share, share, vec2(side));
        float weight = (near.x * near.y + 1e-3) / (0.02 + land + cloud);
        light += weight * texelFetch(fallenLight, texel, 0);
        lit += weight * texelFetch(fallenLit, texel, 0);
        weights += weight;
    }
    light /= weights;
    lit /= weights;
    return Fallen(light.rgb / frame.exposure.x, light.a, lit.rgb, exp2(lit.a));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colourTarget)))) return;
    vec2 centre = vec2(pixel) + 0.5;
    if (!insidePicture(centre)) return;
    vec4 colour = imageLoad(colourTarget, pixel);
    KeyLight key = keyLight();
    LightRay ray = LightRay(rayDirection(centre), landAway(pixel), cloudAway(pixel), colour.a, picturePixel(centre));
    vec3 radiance = colour.rgb / frame.exposure.x + haloLight(ray, key) + gloryLight(ray, key);
    if (STORMY && falling.optics.x > 0.5) radiance = behindFalling(radiance, fallenAt(pixel, ray), ray, key);
    if (STORMY) radiance += strokeLight(ray);
    imageStore(colourTarget, pixel, vec4(clamp(radiance * frame.exposure.x, vec3(0.0), vec3(60000.0)), colour.a));
}
