#version 450 core
// What the air does to the picture: behind everything the sky with its sun, moon and stars; before land, aircraft and
// clouds the light and the veil of the air between.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/night_sky.glsl"
#include "shaders/lib/sky_tables.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform image2D colourTarget;
layout(binding = 0) uniform sampler2D depthTarget;
layout(std430, binding = 7) readonly buffer StarBlock {
    ivec4 cells[512];  // first star, number of stars
    vec4 stars[];      // two each: direction (J2000), irradiance
} bright;

// Whether stars may show: by day software GL need not pay for them.
#ifndef STARS
#define STARS true
#endif

vec3 brightStars(vec3 d, float pixel) {
    float column = fract(atan(d.y, d.x) / 6.2831853 + 1.0) * 32.0;
    float row = (asin(clamp(d.z, -1.0, 1.0)) / 3.14159265 + 0.5) * 16.0;
    ivec4 cell = bright.cells[clamp(int(row), 0, 15) * 32 + clamp(int(column), 0, 31)];
    vec3 sum = vec3(0.0);
    for (int i = cell.x; i < cell.x + cell.y; ++i)
        sum += bright.stars[2 * i + 1].rgb * starSpot(length(bright.stars[2 * i].xyz - d), pixel);
    return sum;
}

/// Stars and Milky Way before the air.
vec3 starsToward(vec3 direction) {
    vec3 d = mat3(sky.celestialFromWorld) * direction;
    return brightStars(d, frame.projection.w) + faintStars(d, frame.projection.w) + milkyWay(d);
}

/// Radiance of the sun's disc, its edge smoothed over a pixel.
vec3 sunDisc(vec3 direction) {
    float radius = sky.lights.sun.w;
    float angle = length(direction - sky.lights.sun.xyz);
    float inside = 1.0 - smoothstep(radius - 0.5 * frame.projection.w, radius + 0.5 * frame.projection.w, angle);
    if (inside <= 0.0) return vec3(0.0);
    return inside * sky.lights.sunLight.rgb * limbDarkening(min(angle / radius, 1.0)) / (kAirPi * radius * radius);
}

/// Radiance of the moon's disc, a its share of the pixel. Its north is the sky's.
vec4 moonDisc(vec3 direction) {
    vec3 toMoon = sky.lights.moon.xyz;
    float radius = sky.lights.moon.w;
    float angle = length(direction - toMoon);
    float share = 1.0 - smoothstep(radius - 0.5 * frame.projection.w, radius + 0.5 * frame.projection.w, angle);
    if (share <= 0.0) return vec4(0.0);
    vec3 north = transpose(mat3(sky.celestialFromWorld)) * vec3(0.0, 0.0, 1.0);
    vec3 right = normalize(cross(toMoon, north));
    vec3 up = cross(right, toMoon);
    vec2 p = vec2(dot(direction, right), dot(direction, up)) / radius;
    p /= max(length(p), 1.0);
    vec3 sun = sky.lights.sun.xyz;  // the sun is so far that both see it in the same direction
    return vec4(moonRadiance(p, vec3(dot(sun, right), dot(sun, up), -dot(sun, toMoon))) * share, share);
}

/// The sky where nothing stands before it.
vec3 skyBehind(vec3 direction) {
    vec3 radiance = skyRadiance(direction);
    float h = sky.skyCamera.x;
    if (distanceInward(h, direction.y, 0.0) >= 0.0) return radiance;
    vec4 moon = moonDisc(direction);
    vec3 beyond = sunDisc(direction) + moon.rgb;
    if (STARS && sky.skyCamera.z > 0.0) beyond += starsToward(direction) * (1.0 - moon.a) * sky.skyCamera.z;
    return any(greaterThan(beyond, vec3(0.0))) ? radiance + beyond * airToTop(h, direction.y) : radiance;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colourTarget)))) return;
    vec2 centre = vec2(pixel) + 0.5;
    if (!insidePicture(centre)) {
        imageStore(colourTarget, pixel, vec4(0.0, 0.0, 0.0, 1.0));
        return;
    }
    vec3 direction = rayDirection(centre);
    float depth = texelFetch(depthTarget, pixel, 0).r;
    vec3 radiance;
    if (depth > 0.0) {
        AirLight air = airBefore(direction, distanceOfDepth(depth, centre));
        radiance = imageLoad(colourTarget, pixel).rgb / frame.exposure.x * air.transmittance + air.radiance;
    } else {
        radiance = skyBehind(direction);
    }
    imageStore(colourTarget, pixel, vec4(min(radiance * frame.exposure.x, vec3(60000.0)), 1.0));
}
