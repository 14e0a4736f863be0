// The plan of a cloud layer: where in the plane its elements stand. A sum of flow noises of falling size, in a domain
// that a coarser one bends; what comes out is turned into a rank by its measured distribution (weather/cloud_pattern).
#ifndef LUFTPOST_CLOUD_PATTERN_GLSL
#define LUFTPOST_CLOUD_PATTERN_GLSL
#include "shaders/lib/noise.glsl"
GLSL_BEGIN

// One octave of a pattern over a period of the plane.
struct PatternOctave {
    ivec2 cells;    // along and across, in one period
    float weight;
    float turns;    // how far its gradients have turned by now
    float billow;   // 2: round elements of very different sizes, 1: of one size, with creases between them (Worley), 0: gradient noise
};

// `unit`: place in the period, 0..1 each way.
GLSL_INLINE float patternOctave(vec2 unit, PatternOctave octave, uint seed) {
    vec2 p = unit * vec2(octave.cells);
    float noise = octave.billow > 1.5f   ? 0.53f - unevenWorley(p, octave.cells, octave.turns, seed)
                : octave.billow > 0.5f ? 0.53f - flowWorley(p, octave.cells, octave.turns, seed)
                                       : flowNoise(p, octave.cells, octave.turns, seed);
    return octave.weight * noise;
}

// Displacement of the domain, of about `reach` in units of the period.
GLSL_INLINE vec2 patternWarp(vec2 unit, ivec2 cells, float turns, float reach, uint seed) {
    vec2 p = unit * vec2(cells);
    return reach * vec2(flowNoise(p, cells, turns, seed), flowNoise(p, cells, turns, seed + 77u));
}

GLSL_END
#endif
