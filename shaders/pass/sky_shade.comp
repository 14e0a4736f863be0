#version 450 core
// Table five: by what share the clouds' shade dims the air's light; less than nothing where the sun breaks through. God rays are
// its differences. One invocation a direction.
#include "shaders/lib/cloud_march.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) uniform writeonly image3D shadeTable;
uniform int firstRow;

const int kSteps = 2;     // between two slices
const int kSkySteps = 6;  // from the last one on
const float kMost = 0.97;
const float kSharpest = 0.9976;  // cosine: the table that is dimmed knows haze's glow no nearer to the light

/// x: share of the key light's beam that the clouds let through to a place; y: how far that is known: beyond the grids it is
/// the mean.
vec2 beamAt(vec3 p, vec3 toward) {
    vec2 onPlane = onDepthPlane(p, toward);
    int grid = gridOver(onPlane);
    if (grid > 1) return vec2(1.0, 0.0);
    float edge = max(abs(onPlane.x), abs(onPlane.y)) / clouds.depthPlaces[1].w;
    float depth = griddedDepth(grid, p, onPlane) + layersAbove(p, toward).sheets;
    return vec2(beamBehind(depth), 1.0 - smoothstep(0.36, 0.46, edge));
}

/// The air's light in the mean over the land, and what of it this ray's air lacks, under a key light of 1.
struct ShadedAir {
    AirLight mean;
    vec3 lack;
};

ShadedAir addShaded(ShadedAir sum, vec3 direction, float start, float end, KeyLight key) {
    float t = 0.5 * (start + end);
    float h = max(heightAlong(sky.skyCamera.x, direction.y, t), 0.0);
    vec3 p = flatFromCurved(direction * t, frame.cameraWorld.y);
    p.y = h;
    vec3 toward = inFlatFrame(key.toward, direction, p);
    float nu = min(dot(direction, key.toward), kSharpest);
    vec2 size = vec2(textureSize(skyTransmittanceTable, 0));
    AirAt here = airAt(sky.air, h);
    vec3 through = exp(-here.extinction * (end - start));
    vec3 weight = sum.mean.transmittance * (vec3(1.0) - through) / max(here.extinction, vec3(1e-12));
    vec2 beam = t < kShadeReach ? beamAt(p, toward) : vec2(0.0);
    sum.lack += weight * (directShare(sky.air, h) - beam.x) * beam.y * scatteredOnce(here, skyTransmittanceTable, size, h, toward.y, nu);
    sum.mean.radiance += weight * sourceAt(sky.air, skyTransmittanceTable, size, skyMultipleTable, vec2(textureSize(skyMultipleTable, 0)), here, h,
                                           direction.y, toward.y, nu);
    sum.mean.transmittance *= through;
    return sum;
}

vec4 shadeOf(ShadedAir air, KeyLight key) {
    vec3 mean = air.mean.radiance * key.above + 0.6 * sky.airglow.rgb * (1.0 - air.mean.transmittance);
    return vec4(clamp(air.lack * key.above / max(mean, vec3(1e-20)), vec3(-20.0), vec3(kMost)), 0.0);
}

void main() {
    ivec3 size = imageSize(shadeTable);
    ivec2 column = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
    if (any(greaterThanEqual(column, size.xy))) return;
    KeyLight key = keyLight();
    float h = sky.skyCamera.x;
    vec3 direction = skyDirection(h, (vec2(column) + 0.5) / vec2(size.xy), sky.lights.sun.xyz);
    ShadedAir sum = ShadedAir(AirLight(vec3(0.0), vec3(1.0)), vec3(0.0));
    float start = 0.0;
    for (int slice = 1; slice < size.z - 1; ++slice) {
        float length = (shadeDistance(float(slice), float(size.z)) - start) / float(kSteps);
        for (int i = 0; i < kSteps; ++i, start += length) sum = addShaded(sum, direction, start, start + length, key);
        vec4 shade = shadeOf(sum, key);
        if (slice == 1) imageStore(shadeTable, ivec3(column, 0), shade);
        imageStore(shadeTable, ivec3(column, slice), shade);
    }
    float toGround = distanceInward(h, direction.y, 0.0);
    float reach = toGround >= 0.0 ? toGround : distanceOutward(h, direction.y, kAirTop);
    for (int i = 1; i <= kSkySteps && reach > kShadeReach; ++i) {
        float end = mix(kShadeReach, reach, float(i * i) / float(kSkySteps * kSkySteps));
        sum = addShaded(sum, direction, start, end, key);
        start = end;
    }
    imageStore(shadeTable, ivec3(column, size.z - 1), shadeOf(sum, key));
}
