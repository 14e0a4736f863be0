#version 450 core
// What the weather adds to the finished picture: shafts of rain and snow with the rainbow in them, the cloud bow and the glory on clouds,
// halo and sun dogs in sheets of ice, lightning.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/weather_light.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image2D colourTarget;
layout(binding = 0) uniform sampler2D depthTarget;
layout(binding = 1) uniform sampler2D cloudDistance;
uniform int inverted;  // 1: the distance texture holds 1 / m

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colourTarget)))) return;
    vec2 centre = vec2(pixel) + 0.5;
    if (!insidePicture(centre)) return;
    vec4 colour = imageLoad(colourTarget, pixel);
    float cloud = texelFetch(cloudDistance, pixel, 0).r;
    LightRay ray;
    ray.direction = rayDirection(centre);
    ray.land = distanceOfDepth(texelFetch(depthTarget, pixel, 0).r, centre);
    ray.cloud = inverted == 1 ? 1.0 / max(cloud, 1e-6) : cloud;
    ray.through = colour.a;
    ray.pixel = centre;
    KeyLight key = keyLight();
    vec3 radiance = colour.rgb / frame.exposure.x;
    radiance += haloLight(ray, key) + gloryLight(ray, key);
    radiance = behindFalling(radiance, ray, key) + strokeLight(ray);
    imageStore(colourTarget, pixel, vec4(clamp(radiance * frame.exposure.x, vec3(0.0), vec3(60000.0)), colour.a));
}
