// The one pair that bends the flat world of the simulation around the Earth for the picture, and back: the
// azimuthal-equidistant map about the camera. A point keeps its direction and its flat distance becomes arc length on
// a sphere of radius R = 6371 km, so what is near does not change and the far sinks below the horizon.
//
// Positions are relative to the camera: x east, y up, z south, metres. `flatPosition.y` is a difference of altitudes.
#ifndef LUFTPOST_CURVATURE_GLSL
#define LUFTPOST_CURVATURE_GLSL
#include "../shared/language.glsl.h"

GLSL_BEGIN

GLSL_CONST float kCurvatureRadius = 6371000.0f;

// sin and 1 - cos of arcs below 0.5 rad as their series to 1e-9 of themselves: a GPU's own sin is only good to about
// 1e-6, six metres on the Earth.
GLSL_FUNCTION float arcSine(float a) {
    float s = a * a;
    return a * (1.0f - s / 6.0f * (1.0f - s / 20.0f * (1.0f - s / 42.0f * (1.0f - s / 72.0f))));
}
GLSL_FUNCTION float arcVersine(float a) {
    float s = a * a;
    return 0.5f * s * (1.0f - s / 12.0f * (1.0f - s / 30.0f * (1.0f - s / 56.0f * (1.0f - s / 90.0f))));
}
// An arc over the tangent of its half, whose square is s: a series, to 1e-9 of itself below 0.5 rad.
GLSL_FUNCTION float arcOverHalfTangent(float s) {
    return 2.0f * (1.0f - s * (1.0f / 3.0f - s * (1.0f / 5.0f - s * (1.0f / 7.0f - s * (1.0f / 9.0f - s / 11.0f)))));
}

/// Where a point of the flat world is drawn, relative to the camera at `cameraAltitude` above sea level. Good to 3000 km.
GLSL_FUNCTION vec3 curvedFromFlat(vec3 flatPosition, float cameraAltitude) {
    float flatDistance = sqrt(flatPosition.x * flatPosition.x + flatPosition.z * flatPosition.z);
    float arc = flatDistance / kCurvatureRadius;
    float cameraRadius = kCurvatureRadius + cameraAltitude;
    float stretch = flatDistance > 0.0f ? (cameraRadius + flatPosition.y) * arcSine(arc) / flatDistance : 1.0f;
    float versine = arcVersine(arc);
    return vec3(flatPosition.x * stretch, flatPosition.y * (1.0f - versine) - cameraRadius * versine, flatPosition.z * stretch);
}

/// The inverse: the altitude difference and flat offset of a drawn point.
GLSL_FUNCTION vec3 flatFromCurved(vec3 curvedPosition, float cameraAltitude) {
    float cameraRadius = kCurvatureRadius + cameraAltitude;
    float across2 = curvedPosition.x * curvedPosition.x + curvedPosition.z * curvedPosition.z;
    float up = cameraRadius + curvedPosition.y;
    float radius = sqrt(across2 + up * up);
    float height = (across2 + curvedPosition.y * (curvedPosition.y + 2.0f * cameraRadius)) / (radius + cameraRadius);
    float both = 1.0f / (radius + up);  // times the way across: the tangent of half the arc
    float shrink = kCurvatureRadius * both * arcOverHalfTangent(across2 * both * both);
    return vec3(curvedPosition.x * shrink, height, curvedPosition.z * shrink);
}

GLSL_END
#endif
