// How the layers change around the camera: a plane fitted to the weather field.
#pragma once
#include <array>

#include "engine/render/snapshot.h"
#include "shaders/shared/cloud.glsl.h"

namespace luftpost::render {
/// By layer of `snapshot.weather`: threshold of the rank, base, top and water at the camera, their slopes (from points
/// 40 km away) and the bounds of what was found. Without a field everything is as at the camera.
std::array<glsl::LayerField, weather::kMaxLayers> layerFields(Snapshot const& snapshot);
}  // namespace luftpost::render
