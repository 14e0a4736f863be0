// What falls from the clouds, as the passes see it from afar: the twin of weather/showers, whose tests hold the two together.
//
// A shaft is where a layer's rank is low enough to precipitate. Going down through air that is not saturated drops evaporate, the
// small ones first: light rain ends in the air as virga while a downpour beside it reaches the ground. Kessler (1969) gives
// dM/dt = -5.44e-4 (saturation deficit) M^0.65 and a fall speed of 5.17 M^0.125 m/s, M in g/m3: with the rate R = M V that is
// dR/ds = -c (deficit) R^0.58. The exponent taken for a half makes the root of the rate fall by as much whatever the rate is; below the
// condensation level the deficit of a stirred layer grows in proportion to the depth, so what is lost grows as its square.
#ifndef LUFTPOST_FALLING_GLSL
#define LUFTPOST_FALLING_GLSL
#include "shaders/shared/falling.glsl.h"
GLSL_BEGIN

GLSL_FUNCTION float fallSmooth(float low, float high, float x) {
    float u = clamp((x - low) / (high - low), 0.0f, 1.0f);
    return u * u * (3.0f - 2.0f * u);
}

/// Share of a storm's cover (as seen, 0..1) whose rank lies under its towers.
GLSL_FUNCTION float stormTowers(float cover) { return cover * (0.5f + 0.35f * cover); }

/// How deep inside a precipitating layer a rank lies, 0..1. `cover`: as seen; `storm`: 1 for a cumulonimbus; `blur`: of the rank, over
/// which the outline is softened, for what is seen with long steps.
GLSL_FUNCTION float showerDepth(float rank, float cover, float storm, float blur) {
    if (cover <= 0.0f) return 0.0f;
    float threshold = storm > 0.5f ? stormTowers(cover) : cover + 0.25f * fallSmooth(0.8f, 1.0f, cover);
    float edge = max(storm > 0.5f ? threshold : min(0.25f, cover), 0.01f);
    return fallSmooth(-0.5f * blur, edge + 0.5f * blur, threshold - rank);
}

/// Root of the rate, (mm/h)^1/2, of the heaviest showers at a place, m east and south of the camera.
GLSL_FUNCTION float showerRoot(LayerFall fall, vec2 place) {
    return clamp(fall.root.x + fall.root.y * place.x + fall.root.z * place.y, 0.0f, fall.shower.x);
}

/// mm/h at `altitude` (m above sea level) below a point of depth `inside` of a shower of that root: 0 where all has evaporated.
GLSL_FUNCTION float rateBelow(LayerFall fall, float root, float inside, float altitude) {
    float dry = max(fall.shower.z - altitude, 0.0f);
    float left = root * sqrt(inside) - fall.shower.y * dry * dry;
    return inside > 0.0f && left > 0.0f ? left * left : 0.0f;
}

/// m, east and south: where in the cloud stands what falls past a point `below` m under the base. Drops that leave their cloud's
/// wind lag behind it.
GLSL_FUNCTION vec2 fallLag(LayerFall fall, float below) {
    float way = max(below, 0.0f);
    return vec2(fall.lag.x, fall.lag.y) * (way * way);
}

/// Liquid share of what falls at an altitude: melting, and near the ground as the report says.
GLSL_FUNCTION float liquidShare(FallAll all, float altitude) {
    float byHeight = 1.0f - fallSmooth(all.melting.x - 308.0f, all.melting.x, altitude);
    return mix(all.melting.y, byHeight, fallSmooth(100.0f, 500.0f, altitude - all.melting.z));
}

/// 1/m, of `rain` and `snow` in mm/h: Stoelinga and Warner (1999) with 0.072 R^0.88 g/m3 of rain, and snow falling at 1 m/s.
GLSL_FUNCTION float fallingExtinction(float rain, float snow) {
    float sum = 0.0f;
    if (rain > 0.0f) sum += 3.1135e-4f * pow(rain, 0.66f);
    if (snow > 0.0f) sum += 3.8147e-3f * pow(snow, 0.78f);
    return sum;
}

GLSL_END
#endif
