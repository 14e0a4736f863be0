// What a pass gets: the snapshot, the targets it draws into, the block it may fill before and read while drawing.
#pragma once
#include <cstdint>
#include <optional>

#include "engine/gl/buffer.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/texture.h"
#include "engine/render/snapshot.h"
#include "engine/render/tile.h"
#include "shaders/shared/frame.glsl.h"

namespace luftpost::render {
/// The HDR picture before the tone map. All of one size.
struct Targets {
    explicit Targets(glm::ivec2 const& size);

    glm::ivec2 size;
    gl::Texture2D colour;   // RGBA16F: radiance * preExposure; alpha: transmittance of the clouds once they are drawn
    gl::Texture2D depth;    // 32-bit float, reversed: near / distance along the view axis, 0: nothing drawn
    gl::Texture2D motion;   // RG16F: this frame's uv less the previous frame's, of what was drawn
    gl::Framebuffer opaque;      // colour (output 0), motion (output 1), depth
    gl::Framebuffer blended;     // colour (output 0), depth: what blends over opaque things and is hidden by them
    gl::Framebuffer colourOnly;  // colour (output 0): full-screen passes that read the depth
};

/// Valid during one Renderer::draw. A pass is a class made with the ProgramLibrary (throws core::Error when its shaders
/// do not load) and drawn with a FrameContext on the GL thread. `describe` members of passes fill `frame` before it is
/// uploaded; while drawing, every shader that includes shared/frame.glsl.h sees it at binding 0.
struct FrameContext {
    Snapshot const& snapshot;
    glsl::FrameBlock& frame;
    Targets& targets;
    std::uint64_t number = 0;   // of the frame since the renderer was made
    bool historyValid = false;  // the previous frame had the same projection, and this is no still
    std::optional<Tile> tile{};  // what of the picture the targets hold; none: all of it

    /// Pixels of the whole picture.
    glm::ivec2 picture() const { return tile ? tile->picture : targets.size; }
};

/// Position relative to the frame's camera, as the GPU gets it (not bent yet).
inline glm::vec3 relativeToCamera(FrameContext const& context, glm::dvec3 const& positionWorld) {
    return glm::vec3{positionWorld - context.snapshot.camera.positionWorld};
}
}  // namespace luftpost::render
