#version 450 core
// Table six: what a cloud at an altitude has around it, no other in the way, of sun, moon, airglow and land together. One work group a
// texel; upper row: above, lower row: below.
#include "shaders/lib/open_sky.glsl"
const int kRings = 8, kSectors = 16;
layout(local_size_x = kRings * kSectors) in;
layout(binding = 0, rgba16f) writeonly uniform image2D table;
shared vec3 seen[kRings * kSectors];

void main() {
    int index = int(gl_LocalInvocationIndex);
    float h = aroundAltitude(float(gl_WorkGroupID.x), float(gl_NumWorkGroups.x));
    // Rings of equal share of a level plane's light: the square of the elevation's sine is uniform.
    float up = sqrt((float(index / kSectors) + 0.5) / float(kRings));
    float azimuth = 2.0 * kAirPi * (float(index % kSectors) + 0.5) / float(kSectors);
    bool below = gl_WorkGroupID.y > 0u;
    Atmosphere air = sky.air;
    if (!below) {  // what is above has no clouds before it; the air below lies in their shade
        air.cover.y = 1.0;
        air.under.w = 0.0;
    }
    seen[index] = openSky(air, h, directionFrom(azimuth, below ? -asin(up) : asin(up), sky.lights.sun.xyz), 16);
    barrier();
    for (int rest = kRings * kSectors / 2; rest > 0; rest /= 2) {
        if (index < rest) seen[index] += seen[index + rest];
        barrier();
    }
    if (index == 0) imageStore(table, ivec2(gl_WorkGroupID.xy), vec4(seen[0] / float(kRings * kSectors), 1.0));
}
