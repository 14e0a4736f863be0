#version 450 core
// The clouds before the picture, and the air before the clouds. What the rays saw beside the pixels' centres is worked out
// for the centres by how it changes to the neighbours.
#include "shaders/lib/camera.glsl"
#include "shaders/lib/cloud_store.glsl"
#include "shaders/lib/sky_tables.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D cloudLight;  // radiance * preExposure, transmittance
layout(binding = 1) uniform sampler2D cloudFacts;  // packedFacts
layout(binding = 0, rgba16f) uniform image2D colourTarget;

/// A neighbour's light and where its ray went through, from this pixel's centre; this pixel's own across an edge of the land.
struct Neighbour {
    vec4 light;
    vec2 place;
};
Neighbour neighbourAt(ivec2 pixel, ivec2 step, vec4 light, CloudFacts facts) {
    ivec2 texel = clamp(pixel + step, ivec2(0), textureSize(cloudLight, 0) - 1);
    CloudFacts there = unpackedFacts(texelFetch(cloudFacts, texel, 0));
    bool same = sameLand(facts.land, there.land) && !isGuess(there);
    return same ? Neighbour(texelFetch(cloudLight, texel, 0), vec2(texel - pixel) + there.offset) : Neighbour(light, vec2(step) + facts.offset);
}

/// The light at the pixel's centre, first order; never beyond what is around.
vec4 lightAtCentre(ivec2 pixel, vec4 light, CloudFacts facts) {
    Neighbour west = neighbourAt(pixel, ivec2(-1, 0), light, facts), east = neighbourAt(pixel, ivec2(1, 0), light, facts);
    Neighbour south = neighbourAt(pixel, ivec2(0, -1), light, facts), north = neighbourAt(pixel, ivec2(0, 1), light, facts);
    vec4 acrossX = (east.light - west.light) / max(east.place.x - west.place.x, 0.5);
    vec4 acrossY = (north.light - south.light) / max(north.place.y - south.place.y, 0.5);
    vec4 low = min(light, min(min(west.light, east.light), min(south.light, north.light)));
    vec4 high = max(light, max(max(west.light, east.light), max(south.light, north.light)));
    return clamp(light - acrossX * facts.offset.x - acrossY * facts.offset.y, low, high);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(colourTarget)))) return;
    vec4 light = texelFetch(cloudLight, pixel, 0);
    CloudFacts facts = unpackedFacts(texelFetch(cloudFacts, pixel, 0));
    if (!isGuess(facts)) light = lightAtCentre(pixel, light, facts);
    if (light.a >= 0.9999) return;
    AirLight air = airBefore(rayDirection(vec2(pixel) + 0.5), facts.distance);
    vec4 behind = imageLoad(colourTarget, pixel);
    vec3 before = light.rgb * air.transmittance + air.radiance * frame.exposure.x * (1.0 - light.a);
    imageStore(colourTarget, pixel, vec4(min(behind.rgb * light.a + before, vec3(60000.0)), behind.a * light.a));
}
