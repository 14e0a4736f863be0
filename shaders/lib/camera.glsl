// Rays and distances of the picture. `unit`: 0..1 over the picture, (0, 0) at the lower left. Directions are unit
// vectors of the world (x east, y up, z south).
#ifndef LUFTPOST_CAMERA_GLSL
#define LUFTPOST_CAMERA_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

/// Perspective, in the camera's frame, not normalised: z is -1.
GLSL_FUNCTION vec3 perspectiveRay(vec2 unit, vec2 tangentHalf) {
    return vec3((2.0f * unit.x - 1.0f) * tangentHalf.x, (2.0f * unit.y - 1.0f) * tangentHalf.y, -1.0f);
}

/// Equirectangular: azimuth clockwise from north at the left edge, zenith on top.
GLSL_FUNCTION vec3 panoramaRay(vec2 unit) {
    float azimuth = 6.28318531f * unit.x;
    float elevation = 3.14159265f * (unit.y - 0.5f);
    return vec3(sin(azimuth) * cos(elevation), sin(elevation), -cos(azimuth) * cos(elevation));
}

/// Where a direction lies in the panorama: inverse of panoramaRay.
GLSL_FUNCTION vec2 panoramaUnit(vec3 direction) {
    float azimuth = atan(direction.x, -direction.z);
    return vec2(azimuth < 0.0f ? azimuth / 6.28318531f + 1.0f : azimuth / 6.28318531f,
                asin(clamp(direction.y, -1.0f, 1.0f)) / 3.14159265f + 0.5f);
}

/// Equal-area dome: zenith in the centre, horizon at the inscribed circle, north up, east left. Outside the circle
/// the rays go on below the horizon; insideDome says which.
GLSL_FUNCTION vec3 domeRay(vec2 unit) {
    vec2 p = 2.0f * unit - vec2(1.0f);
    float r2 = p.x * p.x + p.y * p.y;
    float up = 1.0f - r2;                              // r = sqrt(2) sin(zenith angle / 2)
    float stretch = sqrt(max(2.0f - r2, 0.0f));        // sin(zenith angle) / r
    return vec3(-p.x * stretch, up, -p.y * stretch);
}
GLSL_FUNCTION bool insideDome(vec2 unit) {
    vec2 p = 2.0f * unit - vec2(1.0f);
    return p.x * p.x + p.y * p.y <= 1.0f;
}

GLSL_END

#ifndef __cplusplus
#include "shaders/shared/frame.glsl.h"

/// Where a pixel of the target (centres are at .5, row 0 at the bottom) lies in the whole picture: in its pixels, and 0..1.
vec2 picturePixel(vec2 pixel) { return pixel + frame.tile.xy; }
vec2 pictureUnit(vec2 pixel) { return picturePixel(pixel) * frame.viewport.zw; }

/// Unit vector from the camera through `pixel` in every projection.
vec3 rayDirection(vec2 pixel) {
    vec2 unit = pictureUnit(pixel);
    if (frame.mode.x == kProjectionPanorama) return panoramaRay(unit);
    if (frame.mode.x == kProjectionDome) return domeRay(unit);
    return normalize(mat3(frame.worldFromCamera) * perspectiveRay(unit, frame.projection.xy));
}

/// False for pixels outside a dome's circle.
bool insidePicture(vec2 pixel) {
    return frame.mode.x != kProjectionDome || insideDome(pictureUnit(pixel));
}

/// Metres from the camera along the ray of what `depth` of the depth target stands for; 0 (nothing drawn) gives 1e9.
float distanceOfDepth(float depth, vec2 pixel) {
    if (depth <= 0.0) return 1.0e9;
    float along = frame.projection.z / depth;
    if (frame.mode.x != kProjectionPerspective) return along;
    return along * length(perspectiveRay(pictureUnit(pixel), frame.projection.xy));
}

/// Its inverse: the depth of something `distance` metres along the ray of `pixel`.
float depthOfDistance(float distance, vec2 pixel) {
    if (frame.mode.x != kProjectionPerspective) return frame.projection.z / distance;
    return frame.projection.z * length(perspectiveRay(pictureUnit(pixel), frame.projection.xy)) / distance;
}

/// Screen motion of a world position that did not move: this frame's uv less the previous one's.
vec2 motionOf(vec4 clipNow, vec4 clipBefore) {
    return 0.5 * (clipNow.xy / clipNow.w - clipBefore.xy / clipBefore.w);
}
#endif
#endif
