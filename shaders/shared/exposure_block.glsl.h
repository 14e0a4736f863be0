// What the measured exposure is kept in, on the GPU alone: no frame waits to read it.
#ifndef LUFTPOST_EXPOSURE_BLOCK_GLSL_H
#define LUFTPOST_EXPOSURE_BLOCK_GLSL_H
#ifndef __cplusplus
layout(std430, binding = 6) buffer ExposureBlock {
    float shown;          // factor from radiance to the tone curve, adapted
    float wanted;         // what the latest picture asked for
    float meanLuminance;  // of the latest picture, 1/sr
    float started;        // 0 before the first picture
    uint bins[256];
} measured;
#endif
#endif
