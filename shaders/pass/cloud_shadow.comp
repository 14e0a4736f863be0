#version 450 core
// The shadow map of the clouds: optical depth on the way to the light, and the altitude of what takes it.
#include "shaders/lib/cloud_march.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rg16f) uniform writeonly image2D shadowMap;
uniform int firstRow;

const int kSteps = 10;

/// One layer's depth along `toward` above the plane; adds depth times altitude to `moment`.
float shadowOf(int layer, vec3 place, vec3 toward, inout float moment) {
    vec4 extent = clouds.shapes[layer].extent;
    float slope = max(toward.y, 0.06);
    if (clouds.shapes[layer].look.z > 0.5) {
        float coarse;
        vec3 p = place + toward * ((0.5 * (extent.x + extent.y) - place.y) / slope);
        float depth = sheetDepth(p, columnAt(layer, p.xz, coarse), clouds.shapes[layer], cloudCurlNoise, 2.0) / slope;
        moment += depth * p.y;
        return depth;
    }
    float sum = 0.0;
    float length = (extent.y - extent.x) / slope / float(kSteps);
    for (int i = 0; i < kSteps; ++i) {
        vec3 p = place + toward * ((extent.x - place.y) / slope + (float(i) + 0.5) * length);
        float depth = layerAt(layer, p, 3.0).extinction * length;
        sum += depth;
        moment += depth * p.y;
        if (sum > 30.0) break;
    }
    return sum;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
    ivec2 size = imageSize(shadowMap);
    if (any(greaterThanEqual(texel, size))) return;
    vec2 place = (vec2(texel) + 0.5) / vec2(size) / clouds.shadowPlace.z - clouds.shadowPlace.xy;
    vec3 toward = keyLight().toward;
    float sum = 0.0;
    float moment = 0.0;
    if (toward.y > 0.0)
        for (int layer = 0; layer < clouds.march.x; ++layer)
            if (clouds.shapes[layer].extent.z > 0.5)
                sum += shadowOf(layer, vec3(place.x, clouds.shadowPlace.w, place.y), toward, moment);
    imageStore(shadowMap, texel, vec4(min(sum, 60.0), sum > 0.0 ? moment / sum : 0.0, 0.0, 0.0));
}
