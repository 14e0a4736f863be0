#include "engine/gl/draw.h"

#include <array>

#include "engine/core/check.h"
#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace {
void toggle(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

void applyBlend(Blend blend) {
    toggle(GL_BLEND, blend != Blend::none);
    switch (blend) {
        case Blend::none: return;
        case Blend::alpha:
            return glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        case Blend::premultiplied: return glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        case Blend::add: return glBlendFunc(GL_ONE, GL_ONE);
        case Blend::multiply: return glBlendFunc(GL_DST_COLOR, GL_ZERO);
    }
}
}  // namespace

void apply(DrawState const& state) {
    toggle(GL_DEPTH_TEST, state.depthTest != Compare::always || state.depthWrite);
    glDepthFunc(api::number(state.depthTest));
    glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
    applyBlend(state.blend);
    toggle(GL_CULL_FACE, state.cull != Cull::none);
    glCullFace(state.cull == Cull::front ? GL_FRONT : GL_BACK);
    GLboolean const colour = state.colourWrite ? GL_TRUE : GL_FALSE;
    glColorMask(colour, colour, colour, colour);
    glPolygonMode(GL_FRONT_AND_BACK, state.wireframe ? GL_LINE : GL_FILL);
    toggle(GL_DEPTH_CLAMP, state.depthClamp);
    toggle(GL_SCISSOR_TEST, state.scissor);
    if (state.scissor)
        glScissor(state.scissorBox.x, state.scissorBox.y, state.scissorBox.z, state.scissorBox.w);
    toggle(GL_POLYGON_OFFSET_FILL, state.polygonOffset != glm::vec2{0.0f});
    glPolygonOffset(state.polygonOffset.x, state.polygonOffset.y);
}

void clearWindow(glm::ivec4 const& box, glm::vec3 const& colour) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.x, box.y, box.z, box.w);
    glm::vec4 const value{colour, 1.0f};
    glClearBufferfv(GL_COLOR, 0, &value.x);
    glDisable(GL_SCISSOR_TEST);
}

void drawArrays(VertexArray const& vertices, Primitive primitive, int first, int count, int instances) {
    glBindVertexArray(vertices.id());
    glDrawArraysInstanced(api::number(primitive), first, count, instances);
}

void drawElements(VertexArray const& vertices, Primitive primitive, int count, std::size_t firstIndex, int instances,
                  int baseVertex, unsigned baseInstance) {
    CHECK(vertices.indexType() != IndexType::none, "a draw by index of a vertex array without indices");
    std::size_t const indexBytes = vertices.indexType() == IndexType::uint16 ? 2 : 4;
    glBindVertexArray(vertices.id());
    glDrawElementsInstancedBaseVertexBaseInstance(api::number(primitive), count, api::number(vertices.indexType()),
                                                  reinterpret_cast<void const*>(firstIndex * indexBytes), instances,
                                                  baseVertex, baseInstance);
}

void drawFullscreen() {
    VertexArray const none = VertexArray::withoutAttributes();  // GL wants one bound; vertex arrays belong to one context, so none is kept
    glBindVertexArray(none.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void dispatch(glm::ivec3 const& groups) {
    glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), static_cast<GLuint>(groups.z));
}

void dispatchIndirect(Buffer const& groups, std::size_t offset) {
    CHECK(offset + 3 * sizeof(GLuint) <= groups.bytes(), "groups at {} of a buffer of {} bytes", offset, groups.bytes());
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.id());
    glDispatchComputeIndirect(static_cast<GLintptr>(offset));
}

void dispatchOver(glm::ivec2 const& size, glm::ivec2 const& local) {
    dispatch({(size.x + local.x - 1) / local.x, (size.y + local.y - 1) / local.y, 1});
}

void barrier(Barrier which) {
    static constexpr std::array<GLbitfield, 9> kBits{GL_TEXTURE_FETCH_BARRIER_BIT, GL_SHADER_IMAGE_ACCESS_BARRIER_BIT,
                                                     GL_SHADER_STORAGE_BARRIER_BIT, GL_UNIFORM_BARRIER_BIT,
                                                     GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT,
                                                     GL_FRAMEBUFFER_BARRIER_BIT,
                                                     GL_TEXTURE_UPDATE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT,
                                                     GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT, GL_ALL_BARRIER_BITS};
    glMemoryBarrier(kBits[static_cast<std::size_t>(which)]);
}
}  // namespace luftpost::gl
