// Optical depth of the clouds straight down, from the one density: what `sky --plan` draws and what cover means.
#pragma once
#include "engine/weather/noise_volume.h"
#include "engine/weather/weather.h"
#include "shaders/shared/cloud.glsl.h"

namespace luftpost::weather {
/// Optical depth of one layer over `place` (m east and south in the frame of `density`), at lod 0.
float layerDepth(glsl::LayerColumn const& column, glsl::LayerShape const& shape, glm::vec2 const& place,
                 NoiseVolumes const& noise);

/// The same of all layers.
float columnDepth(glsl::CloudColumn const& column, glsl::CloudShape const& shape, glm::vec2 const& place,
                  NoiseVolumes const& noise);

/// The optical depth from which on a layer of the genus covers the ground: 0.3, and 0.05 for Ci, Cc, Cs.
float coverDepth(Genus genus);
}  // namespace luftpost::weather
