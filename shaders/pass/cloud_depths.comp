#version 450 core
// The grids of optical depth toward the light: each column is one way of the light, summed up from its top.
#include "shaders/lib/cloud_march.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r16f) uniform writeonly image3D depthGrid;
uniform int firstRow;

const float kLods[2] = float[2](2.0, 4.5);  // of the inner and the outer grid: less wide than their texels, else shadows would be soft

const float kLongestStep = 250.0;             // m along the way of a low light
const int kMostSteps = 4;                     // between two slices

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
    int grid = int(gl_GlobalInvocationID.z);
    int side = imageSize(depthGrid).x;
    if (any(greaterThanEqual(texel, ivec2(side)))) return;
    vec4 place = clouds.depthPlaces[grid];
    vec2 onPlane = (vec2(texel) + 0.5) / float(side) * place.w - place.xy;
    onPlane -= place.w * round(onPlane * place.z);  // the one of its like that lies around the camera
    vec3 toward = keyLight().toward;
    float slope = max(toward.y, kLowestLight);
    float way = sliceWay(toward);
    int steps = clamp(int(ceil(way / kLongestStep)), 1, kMostSteps);
    int slice = grid * kDepthSlices + kDepthSlices - 1;
    float sum = 0.0;
    imageStore(depthGrid, ivec3(texel, slice), vec4(0.0));
    for (int k = (kDepthSlices - 1) * steps - 1; k >= 0; --k) {
        float share = (float(k) + 0.5) / (float(kDepthSlices - 1) * float(steps));
        float y = mix(clouds.depthHeights.x, clouds.depthHeights.y, share);
        vec2 p = onPlane + toward.xz * ((y - clouds.depthHeights.z) / slope);
        sum += cloudAt(vec3(p.x, y, p.y), kLods[grid]).extinction * way / float(steps);
        if (k % steps == 0) imageStore(depthGrid, ivec3(texel, --slice), vec4(min(sum, kDeepest)));
    }
}
