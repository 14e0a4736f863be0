// The clouds from straight above: what `sky --plan` writes and what cover is measured on. CPU alone, no GL.
#pragma once
#include <vector>

#include "engine/core/environment.h"
#include "engine/weather/cloud_settings.h"
#include "engine/weather/field.h"
#include "engine/weather/noise_volume.h"

namespace luftpost::weather {
struct PlanRequest {
    double width = 120'000.0;  // m, of the square, centred on the world's origin
    glm::ivec2 size{512, 512};  // pixels: north up, first row north; a pixel covers width / size each way
    core::UtcSeconds time = 0.0;
    unsigned seed = 1;
    CloudSettings settings;
};

/// Vertical optical depth of all layers at each pixel's centre, row by row, on `workers` threads.
std::vector<float> cloudPlan(Field const& field, PlanRequest const& request, NoiseVolumes const& noise, int workers);
}  // namespace luftpost::weather
