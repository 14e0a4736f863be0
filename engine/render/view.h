// The camera's part of the frame block: pure.
#pragma once
#include <optional>

#include "engine/render/snapshot.h"
#include "engine/render/tile.h"
#include "shaders/shared/frame.glsl.h"

namespace luftpost::render {
/// Clip from position relative to the camera, world axes: reversed depth (near / distance along the axis), far plane at
/// infinity. `aspect` is width over height.
glm::dmat4 clipFromWorld(Camera const& camera, double aspect);

/// What is kept of a frame for the next one's motion.
struct ViewHistory {
    glm::dmat4 clipFromWorld{1.0};
    glm::dvec3 positionWorld{0.0};
};

/// Fills the camera, picture and time members of `frame` for a tile of the snapshot's picture. Without history nothing moved.
void describeView(Snapshot const& snapshot, Tile const& tile, std::uint64_t number,
                  std::optional<ViewHistory> const& history, glsl::FrameBlock& frame);
}  // namespace luftpost::render
