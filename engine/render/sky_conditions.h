// What the weather of a snapshot means for the air's light.
#pragma once
#include "engine/render/snapshot.h"
#include "engine/sky/atmosphere.h"

namespace luftpost::render {
/// Visibility and ground of the snapshot's weather, and the share of the sky under clouds seen from its camera.
sky::AirConditions airConditions(Snapshot const& snapshot);

/// Share of the sky under cloud seen from `altitude` (m above sea level): layers overlap at random, each weighed by how
/// much of the sun's beam its genus takes; a layer that one is inside of counts by what lies above.
double coverAbove(weather::Weather const& weather, double altitude);
}  // namespace luftpost::render
