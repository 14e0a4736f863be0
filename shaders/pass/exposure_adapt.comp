#version 450 core
// From the histogram to the exposure: the mean of the logarithms without the darkest tenth and the brightest twentieth;
// no brighter than lets nine tenths of the picture keep form and colour.
#include "shaders/lib/exposure.glsl"
#include "shaders/shared/exposure_block.glsl.h"
#include "shaders/shared/frame.glsl.h"
layout(local_size_x = 1) in;
const float kBrightestShown = 1.3;  // exposed: 0.76 of white

void main() {
    float total = 0.0;
    for (int i = 0; i < kExposureBins; ++i) total += float(measured.bins[i]);
    float low = 0.1 * total, high = 0.95 * total;
    float before = 0.0, weight = 0.0, sum = 0.0, bright = 0.0;
    for (int i = 0; i < kExposureBins; ++i) {
        float after = before + float(measured.bins[i]);
        float kept = max(min(after, high) - max(before, low), 0.0);
        sum += kept * log2(exposureOfBin(i));
        weight += kept;
        if (before <= 0.9 * total) bright = exposureOfBin(i);
        before = after;
        measured.bins[i] = 0u;
    }
    float start = frame.exposure.y;
    float mean = weight > 0.0 ? exp2(sum / weight) : 0.0;
    float keeps = kBrightestShown / max(bright, 1e-12);
    float wanted = weight > 0.0 ? min(exposureFor(mean), keeps) * frame.exposure.w : start;
    wanted = clamp(wanted, start * 0.2, start * 5.0);
    bool jump = frame.mode.w == 1 || measured.started == 0.0;
    measured.shown = jump ? wanted : adaptedExposure(measured.shown, wanted, frame.time.w);
    measured.wanted = wanted;
    measured.meanLuminance = mean;
    measured.started = 1.0;
}
