// How the layers change around the camera: a plane fitted to the weather field.
#pragma once
#include <array>

#include "engine/render/snapshot.h"
#include "shaders/shared/cloud.glsl.h"

namespace luftpost::render {
/// The weather at the camera, and the layers that stand only farther off, with no cover here: those behind a front that comes,
/// those of another site. No more than a Weather holds; sorted by base.
weather::Weather skyAround(Snapshot const& snapshot);

/// By layer of `sky`: threshold of the rank, base, top and water at the camera, their slopes (from points 40 km away; across a
/// front that is nearer than that, those of its line) and the bounds of what was found. Without a field everything is as at
/// the camera.
std::array<glsl::LayerField, weather::kMaxLayers> layerFields(Snapshot const& snapshot, weather::Weather const& sky);
}  // namespace luftpost::render
