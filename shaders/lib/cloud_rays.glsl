// Which pixels are marched: one of each block a frame, in turn, and those of the list. GLSL alone.
#ifndef LUFTPOST_CLOUD_RAYS_GLSL
#define LUFTPOST_CLOUD_RAYS_GLSL
#include "shaders/lib/camera.glsl"
#include "shaders/shared/cloud.glsl.h"

/// Of 4 x 4 pixels, so that those of successive frames lie far apart.
const int kRayOfBlock[16] = int[16](0, 10, 2, 8, 5, 15, 7, 13, 1, 11, 3, 9, 4, 14, 6, 12);
const int kRayOfSmallBlock[4] = int[4](0, 3, 1, 2);

/// The pixel of a block that is marched in this frame. Blocks are clouds.march.w pixels wide: 4, 2 or 1.
ivec2 marchedPixel(ivec2 block) {
    int side = clouds.march.w;
    if (side == 1) return block;
    int ray = side == 4 ? kRayOfBlock[clouds.march.z] : kRayOfSmallBlock[clouds.march.z];
    return block * side + ivec2(ray % side, ray / side);
}

/// Pixels that nothing is known of: they are marched in the same frame as far as the budget reaches.
layout(std430, binding = 8) buffer CloudRayList {
    uvec4 marchGroups;  // xyz: of the dispatch that marches them; w: how many there are
    uvec4 fillGroups;   // xyz: of the dispatch that guesses the rest; w: the budget
    uint pixels[];      // x + 65536 y
} rayList;

// Rays of a work group of cloud_march, 64 or 512. With 512 a GPU's compiler must spare registers, and more of them run at once: a third
// faster. Software GL has nothing to gain by it, and few groups to deal out: a third slower.
#ifndef MARCH_GROUP
#define MARCH_GROUP 64
#endif
const uint kFillGroup = 64u;  // of cloud_fill

void askRay(ivec2 pixel) {
    uint place = atomicAdd(rayList.marchGroups.w, 1u);
    if (place >= uint(rayList.pixels.length())) return;
    rayList.pixels[place] = uint(pixel.x) | uint(pixel.y) << 16;
    uint budget = rayList.fillGroups.w;
    if (place < budget) atomicMax(rayList.marchGroups.x, place / uint(MARCH_GROUP) + 1u);
    else atomicMax(rayList.fillGroups.x, (place - budget) / kFillGroup + 1u);
}

/// The pixel at `place` of the list; x below 0 when the list is shorter.
ivec2 askedPixel(uint place, uint end) {
    if (place >= min(min(rayList.marchGroups.w, uint(rayList.pixels.length())), end)) return ivec2(-1);
    uint both = rayList.pixels[place];
    return ivec2(both & 65535u, both >> 16);
}
#endif
