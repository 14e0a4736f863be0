// The face of a lake under wind: sums of travelling waves whose slopes have the variance that Cox and Munk measured from
// the sun's glitter (J. Opt. Soc. Am. 44, 1954: 0.003 + 0.00512 W). Waves shorter than two pixels are taken out of the sum and
// given to the roughness of the mirror.
#ifndef LUFTPOST_WAVES_GLSL
#define LUFTPOST_WAVES_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_CONST int kWavePeriod = 1024;  // m: all waves repeat on this square, so that places may be wrapped to it

GLSL_FUNCTION float slopeVariance(float wind) { return 0.003f + 0.00512f * wind; }

struct WaveFace {
    vec2 slope;        // east, north
    float unresolved;  // variance of the slopes that `footprint` hides
};

/// `place`: m east and north, wrapped to kWavePeriod. `wind`: m/s, east and north. `seconds`: of the simulation.
GLSL_FUNCTION WaveFace waveFace(vec2 place, vec2 wind, float seconds, float footprint) {
    float speed = sqrt(wind.x * wind.x + wind.y * wind.y);
    vec2 along = speed > 0.1f ? vec2(wind.x / speed, wind.y / speed) : vec2(1.0f, 0.0f);
    WaveFace face;
    face.slope = vec2(0.0f);
    face.unresolved = slopeVariance(speed) * 0.35f;  // what is finer than the shortest wave here
    float share = slopeVariance(speed) * 0.65f / 10.0f;
    for (int i = 0; i < 10; ++i) {
        float wavelength = 8.5f / exp2(0.37f * float(i));
        float turn = 0.9f * (fract(float(i) * 0.618034f + 0.3f) - 0.5f) * 2.0f;
        vec2 direction = vec2(along.x - turn * along.y, along.y + turn * along.x);
        float cycles = float(kWavePeriod) / (wavelength * sqrt(1.0f + turn * turn));
        vec2 whole = vec2(floor(direction.x * cycles + 0.5f), floor(direction.y * cycles + 0.5f));
        float number = 6.2831853f * sqrt(whole.x * whole.x + whole.y * whole.y) / float(kWavePeriod);
        float shown = clamp(0.3f * wavelength / max(footprint, 1e-3f) - 1.0f, 0.0f, 1.0f);
        if (number > 0.0f && shown > 0.0f) {
            float phase = 6.2831853f * fract((whole.x * place.x + whole.y * place.y) / float(kWavePeriod)) -
                          sqrt(9.81f * number) * seconds + 2.4f * float(i);
            float steep = sqrt(2.0f * share) * shown * cos(phase);
            face.slope = face.slope + vec2(whole.x, whole.y) * (steep * 6.2831853f / (float(kWavePeriod) * number));
        }
        face.unresolved = face.unresolved + share * (1.0f - shown * shown);
    }
    return face;
}

GLSL_END
#endif
