// How bright the picture is shown: mid-grey by day, ever darker from dusk to night.
#ifndef LUFTPOST_EXPOSURE_GLSL
#define LUFTPOST_EXPOSURE_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

GLSL_CONST float kSunLux = 128000.0f;     // 1 of our irradiance
GLSL_CONST float kDarkestSeen = 0.00025f;  // cd/m2, a moonless sky: what is darker is not shown brighter
GLSL_CONST float kDarkestKey = 0.10f;

/// Factor from radiance to what the tone curve takes, for a scene of mean luminance `mean` (1/sr, the sun's irradiance
/// above the air being 1). The key falls with the luminance as the eye's does (Krawczyk, Myszkowski and Seidel 2005):
/// a night that is shown as bright as day is no night.
GLSL_FUNCTION float exposureFor(float mean) {
    float candela = max(mean * kSunLux, 1e-7f);
    float key = 1.03f - 2.0f / (2.0f + log(candela + 1.0f) / 2.30258509f);
    // A day under storm clouds is to look darker than a sunlit one, by half a stop.
    float gloom = pow(clamp(candela / 6000.0f, 0.02f, 1.0f), 0.15f);
    return 0.40f * max(key * gloom, kDarkestKey) * kSunLux / max(candela, kDarkestSeen);
}

/// The histogram of the picture: 1/4 stop a bin, bin 0 for all that is darker.
GLSL_CONST int kExposureBins = 256;
GLSL_CONST float kDarkestBin = -40.0f;  // log2 of radiance
GLSL_FUNCTION int exposureBin(float luminance) {
    return clamp(int((log2(max(luminance, 1e-12f)) - kDarkestBin) * 4.0f), 0, kExposureBins - 1);
}
GLSL_FUNCTION float exposureOfBin(int bin) { return exp2((float(bin) + 0.5f) / 4.0f + kDarkestBin); }

/// Where the exposure is `seconds` after it was `from` and ought to be `to`: the eye takes 0.6 s to light and 2 s to dark.
GLSL_FUNCTION float adaptedExposure(float from, float to, float seconds) {
    float pace = to < from ? 0.6f : 2.0f;
    return to * exp2(log2(max(from, 1e-9f) / to) * exp(-seconds / pace));
}

GLSL_END
#endif
