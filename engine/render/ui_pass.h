// Draws Dear ImGui's lists by our own owners of GL objects.
#pragma once
#include "engine/assets/image.h"
#include "engine/gl/buffer.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/gl/vertex_array.h"

struct ImDrawData;
struct ImDrawList;
struct ImDrawCmd;

namespace luftpost::render {
class UiPass {
public:
    /// Throws core::Error when its shaders do not load.
    explicit UiPass(gl::ProgramLibrary& programs);

    /// Draws over `display`. A `fontVersion` other than the last one's means that the current ImGui context has a new
    /// font atlas.
    void draw(ImDrawData const& lists, int fontVersion, gl::Framebuffer const& display);

    /// What kPhotoTexture in the lists stands for; nothing is done when the version is the last one's.
    void usePhoto(assets::Image const& photo, int version);

private:
    void uploadFont();
    void reserve(std::size_t vertexBytes, std::size_t indexBytes);
    void drawList(ImDrawData const& lists, ImDrawList const& list, glm::ivec2 const& size);
    void drawCommand(ImDrawData const& lists, ImDrawCmd const& command, glm::ivec2 const& size);

    gl::Program const& program_;
    gl::Texture2D font_, photo_;
    gl::Buffer vertices_, indices_;
    gl::VertexArray array_;
    int fontVersion_ = -1, photoVersion_ = -1;
};
}  // namespace luftpost::render
