// What a pass asks the GPU to do: the fixed state of a draw, draws, dispatches, barriers.
#pragma once
#include <cstddef>

#include <glm/glm.hpp>

#include "engine/gl/buffer.h"
#include "engine/gl/types.h"
#include "engine/gl/vertex_array.h"

namespace luftpost::gl {
/// All fixed state that a draw depends on; apply() sets every item, so no pass inherits from another.
struct DrawState {
    Compare depthTest = Compare::always;  // reversed depth: nearer is greater; `always` and no write: depth is off
    bool depthWrite = false;
    Blend blend = Blend::none;
    Cull cull = Cull::none;               // front faces are counter-clockwise
    bool colourWrite = true;
    bool wireframe = false;
    bool depthClamp = false;
    bool scissor = false;
    glm::ivec4 scissorBox{0};             // x, y from the lower left, width, height
    glm::vec2 polygonOffset{0.0f};        // factor, units
};
void apply(DrawState const& state);

/// The usual state of opaque geometry.
inline DrawState opaqueState() {
    DrawState state;
    state.depthTest = Compare::greaterEqual;
    state.depthWrite = true;
    state.cull = Cull::back;
    return state;
}

/// One colour (as the screen takes it) in a box of framebuffer 0: x, y from the lower left, width, height.
void clearWindow(glm::ivec4 const& box, glm::vec3 const& colour);

void drawArrays(VertexArray const& vertices, Primitive primitive, int first, int count, int instances = 1);
/// `firstIndex` counts indices; `baseVertex` is added to each.
void drawElements(VertexArray const& vertices, Primitive primitive, int count, std::size_t firstIndex = 0,
                  int instances = 1, int baseVertex = 0, unsigned baseInstance = 0);
/// One triangle over the whole viewport, for the vertex stage "fullscreen".
void drawFullscreen();

void dispatch(glm::ivec3 const& groups);
/// As many groups as the three unsigned numbers at `offset` of a buffer say, which a shader may have written.
void dispatchIndirect(Buffer const& groups, std::size_t offset);
/// As many groups of `local` invocations as cover `size`.
void dispatchOver(glm::ivec2 const& size, glm::ivec2 const& local);

/// What later commands read of what earlier shaders wrote through images and storage buffers.
enum class Barrier { textureFetch, image, storage, uniform, vertices, framebuffer, readBack, indirect, all };
void barrier(Barrier barrier);
}  // namespace luftpost::gl
