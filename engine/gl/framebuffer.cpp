#include "engine/gl/framebuffer.h"

#include <array>

#include "engine/core/check.h"
#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace {
void checkComplete(GLuint id, std::string_view label) {
    GLenum const status = glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
    CHECK(status == GL_FRAMEBUFFER_COMPLETE, "framebuffer '{}' is incomplete: {:#x}", label, status);
}
}  // namespace

Framebuffer::Framebuffer(std::initializer_list<Texture2D const*> colours, Texture2D const* depth,
                         std::string_view label) {
    glCreateFramebuffers(1, &id_);
    std::array<GLenum, 8> buffers{};
    GLsizei count = 0;
    for (Texture2D const* colour : colours) {
        GLenum const attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(count);
        glNamedFramebufferTexture(id_, attachment, colour->id(), 0);
        buffers[static_cast<std::size_t>(count++)] = attachment;
        size_ = colour->size();
    }
    if (depth) {
        glNamedFramebufferTexture(id_, GL_DEPTH_ATTACHMENT, depth->id(), 0);
        size_ = depth->size();
    }
    glNamedFramebufferDrawBuffers(id_, count, buffers.data());
    api::label(GL_FRAMEBUFFER, id_, label);
    checkComplete(id_, label);
}

Framebuffer::Framebuffer(Texture2DArray const& depth, int layer, std::string_view label) : size_{depth.size()} {
    glCreateFramebuffers(1, &id_);
    glNamedFramebufferTextureLayer(id_, GL_DEPTH_ATTACHMENT, depth.id(), 0, layer);
    glNamedFramebufferDrawBuffer(id_, GL_NONE);
    api::label(GL_FRAMEBUFFER, id_, label);
    checkComplete(id_, label);
}

Framebuffer::~Framebuffer() {
    if (id_) glDeleteFramebuffers(1, &id_);
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glViewport(0, 0, size_.x, size_.y);
}

void Framebuffer::clearColour(int attachment, glm::vec4 const& colour) const {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearNamedFramebufferfv(id_, GL_COLOR, attachment, &colour.x);
}

void Framebuffer::clearDepth(float depth) const {
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(id_, GL_DEPTH, 0, &depth);
}

void Framebuffer::copyToWindow(glm::ivec2 const& windowSize) const {
    GLenum const filter = windowSize == size_ ? GL_NEAREST : GL_LINEAR;
    glBlitNamedFramebuffer(id_, 0, 0, 0, size_.x, size_.y, 0, 0, windowSize.x, windowSize.y, GL_COLOR_BUFFER_BIT,
                           filter);
}

void Framebuffer::bindWindow(glm::ivec2 const& windowSize) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, windowSize.x, windowSize.y);
}
}  // namespace luftpost::gl
