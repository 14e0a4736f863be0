// The home airfield's face: asphalt, its markings, and the mown strip around it. Positions are metres east and north of
// the runway's middle.
#ifndef LUFTPOST_RUNWAY_GLSL
#define LUFTPOST_RUNWAY_GLSL
#include "shaders/shared/terrain.glsl.h"
#include "shaders/lib/terrain_colour.glsl"

vec2 runwayAlongAcross(vec2 home) {
    return vec2(dot(home, land.runway.xy), home.x * land.runway.y - home.y * land.runway.x);
}
/// Metres outside the airfield's grounds and its approaches, 0 within.
float airfieldDistance(vec2 home) {
    vec2 at = abs(runwayAlongAcross(home));
    return length(max(at - vec2(620.0, 90.0), vec2(0.0)));
}

/// Coverage of a bar that begins at `from` and ends at `to`, over a pixel of `footprint`.
float bar(float x, float from, float to, float footprint) {
    float half_ = 0.5 * max(footprint, 0.02);
    return clamp((min(x + half_, to) - max(x - half_, from)) / (2.0 * half_), 0.0, 1.0);
}

LandColour runwayColour(vec2 home, LandColour around, float footprint) {
    vec2 at = runwayAlongAcross(home);
    vec2 size = 0.5 * land.runway.zw;
    LandColour face = around;
    float mown = bar(at.x, -size.x - 60.0, size.x + 60.0, footprint) * bar(at.y, -size.y - 30.0, size.y + 30.0, footprint);
    float stripes = 0.5 + 0.5 * clamp(sin(at.y * 0.5236) * 6.0, -1.0, 1.0) * visibleShare(6.0, footprint);
    face.albedo = mix(face.albedo, mix(vec3(0.132, 0.176, 0.066), vec3(0.152, 0.196, 0.076), stripes), mown);
    float asphalt = bar(at.x, -size.x, size.x, footprint) * bar(at.y, -size.y, size.y, footprint);
    float wear = exp(-pow(abs(abs(at.x) - size.x + 130.0) / 70.0, 2.0)) * exp(-at.y * at.y / 30.0);
    vec3 tar = vec3(0.105, 0.105, 0.110) * (1.0 - 0.45 * wear);
    face.albedo = mix(face.albedo, tar, asphalt);
    face.bump = mix(face.bump, 0.02, asphalt);
    face.gloss = mix(face.gloss, 1.0, asphalt);
    face.canopy *= 1.0 - mown;
    // Paint: centre line 30 m on, 20 m off; edges; eight threshold stripes; touchdown bars.
    float end = size.x - abs(at.x);
    float dash = fract(at.x / 50.0) * 50.0;
    float centre = bar(at.y, -0.45, 0.45, footprint) * bar(dash, 10.0, 40.0, footprint) * step(60.0, end);
    float edge = bar(abs(at.y), size.y - 1.4, size.y - 0.5, footprint);
    float stripe = fract(abs(at.y) / 3.6) * 3.6;
    float threshold = bar(end, 6.0, 36.0, footprint) * bar(stripe, 0.9, 2.7, footprint) * bar(abs(at.y), 0.5, 14.0, footprint);
    float touchdown = bar(end, 150.0, 172.0, footprint) * bar(abs(at.y), 4.0, 7.0, footprint);
    float paint = max(max(centre, edge), max(threshold, touchdown)) * asphalt;
    face.albedo = mix(face.albedo, vec3(0.62), 0.9 * paint);
    return face;
}
#endif
