// Rain and snow near the camera.
//
// Drops fall along one direction, that of their velocity relative to the camera. Cylinders about that axis through the
// camera are unrolled into sheets of cells, (angle, way along the axis); each cell holds one drop or none, and the
// sheets slide along the axis as far as the drops have fallen. So streaks are parallel in space, run together in the two
// points where the camera flies to and comes from, and are as long as a drop falls while the shutter is open. A drop covers
// each point of its streak for a part of that time only: streaks are faint, and rain is many of them.
#ifndef LUFTPOST_PRECIPITATION_GLSL
#define LUFTPOST_PRECIPITATION_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_FUNCTION float dropUnit(uint x) {
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    x = x ^ (x >> 16u);
    return float(x >> 8u) * (1.0f / 16777216.0f);
}

/// A right-handed pair of axes across `axis` (unit).
GLSL_FUNCTION vec3 acrossAxis(vec3 axis) {
    vec3 other = abs(axis.x) < 0.7f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
    return normalize(cross(axis, other));
}

/// Share 0..1 of a pixel that drops of one sheet cover, faint toward the streaks' ends. `direction`: the pixel's ray; `axis`: unit, where the drops go
/// to; `radius`: of the sheet, m; `fallen`: m along the axis; `streak`: length, m; `size`: width, m; `share`: of cells
/// that hold a drop; `pixel`: angle of a pixel, rad; `reach`: m to what stands behind.
GLSL_FUNCTION float dropCover(vec3 direction, vec3 axis, float radius, float fallen, float streak, float size,
                              float share, float pixel, float reach) {
    float along = dot(direction, axis);
    float across = sqrt(max(1.0f - along * along, 0.0f));
    float distance = radius / max(across, 0.01f);
    if (distance > reach || across < 0.04f) return 0.0f;
    vec3 right = acrossAxis(axis);
    float angle = atan(dot(direction, cross(axis, right)), dot(direction, right));
    float width = max(size, 0.7f * pixel * distance);
    float columns = max(floor(6.2831853f * radius / max(2.5f * width, 0.03f)), 8.0f);
    float column = (angle / 6.2831853f + 0.5f) * columns;
    float cellLength = max(3.0f * streak, 0.25f);
    float whole = floor(column);
    uint key = uint(whole) * 9781u + uint(radius * 64.0f) * 6271u;
    float place = radius * along / max(across, 0.01f) - fallen + cellLength * dropUnit(key);
    float row = floor(place / cellLength);
    uint cell = key + uint(int(row) + 65536) * 26699u;
    if (dropUnit(cell + 1u) > share) return 0.0f;
    float middle = 0.3f + 0.4f * dropUnit(cell + 2u);
    float aside = abs(column - whole - middle) * 6.2831853f * radius / columns;
    float ahead = abs(place - (row + 0.5f) * cellLength);
    float inside = (1.0f - smoothstep(0.3f * width, 0.7f * width, aside)) *
                   (1.0f - smoothstep(0.0f, 0.5f * streak + 0.3f * width, ahead));
    return inside * min(size / width, 1.0f) * (0.3f + 0.7f * dropUnit(cell + 3u));
}

GLSL_END
#endif
