// What the picture keeps of its clouds from frame to frame: one ray's own answer per pixel, never mixed with another's, and
// where in the pixel that ray went through. GLSL alone.
//
// A picture that is filtered again each time it is found again blurs a little more with every frame. Here the answers are
// moved as they are; what lies between them is worked out once, for the eye (cloud_composite), and never kept.
#ifndef LUFTPOST_CLOUD_STORE_GLSL
#define LUFTPOST_CLOUD_STORE_GLSL

/// What is known of a pixel beside its light.
struct CloudFacts {
    float distance;  // m, of the cloud
    float land;      // m, of what lies behind; 1e9: the sky
    vec2 offset;     // pixels, from the pixel's centre to where the ray went through
};

const float kNoLand = 1.0e9;
const float kSky = 1.0e8;    // m: land beyond is the sky
const float kGuess = 4.0;    // pixels: an offset that says that no ray has answered

vec4 packedFacts(CloudFacts facts) {
    return vec4(1.0 / max(facts.distance, 1.0), facts.land > kSky ? 0.0 : 1.0 / max(facts.land, 0.1), facts.offset);
}
CloudFacts unpackedFacts(vec4 v) {
    return CloudFacts(1.0 / max(v.x, 1.0e-7), v.y > 0.0 ? 1.0 / v.y : kNoLand, v.zw);
}

bool isGuess(CloudFacts facts) { return facts.offset.x > 0.5 * kGuess; }

/// Two pixels see the same background when both see the sky or their lands are at about the same distance.
bool sameLand(float a, float b) {
    if (a > kSky || b > kSky) return a > kSky && b > kSky;
    return abs(a - b) < 0.12 * min(a, b) + 20.0;
}
#endif
