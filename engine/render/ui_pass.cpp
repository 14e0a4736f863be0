#include "engine/render/ui_pass.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "engine/gl/draw.h"
#include "engine/render/snapshot.h"

namespace luftpost::render {
namespace {
constexpr std::array<gl::Attribute, 3> kAttributes{{
    {.location = 0, .components = 2, .offset = offsetof(ImDrawVert, pos)},
    {.location = 1, .components = 2, .offset = offsetof(ImDrawVert, uv)},
    {.location = 2, .components = 4, .type = gl::AttributeType::uint8, .offset = offsetof(ImDrawVert, col), .normalised = true},
}};
constexpr gl::IndexType kIndexType = sizeof(ImDrawIdx) == 2 ? gl::IndexType::uint16 : gl::IndexType::uint32;

template <class T>
std::span<T const> spanOf(ImVector<T> const& items) {
    return {items.Data, static_cast<std::size_t>(items.Size)};
}
}  // namespace

UiPass::UiPass(gl::ProgramLibrary& programs) : program_{programs.graphics("ui")} {}

void UiPass::uploadFont() {
    unsigned char* coverage = nullptr;
    glm::ivec2 size{0};
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&coverage, &size.x, &size.y);
    font_ = gl::Texture2D{gl::Format::r8, size, 1, "font"};
    font_.upload<std::uint8_t>(std::span{coverage, static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)});
}

void UiPass::usePhoto(assets::Image const& photo, int version) {
    if (version == photoVersion_) return;
    photoVersion_ = version;
    photo_ = gl::Texture2D{gl::Format::rgba8, {photo.width, photo.height}, 1, "photograph"};
    photo_.upload<std::uint8_t>(photo.values);
}

void UiPass::reserve(std::size_t vertexBytes, std::size_t indexBytes) {
    if (vertexBytes <= vertices_.bytes() && indexBytes <= indices_.bytes()) return;
    vertices_ = gl::Buffer{std::bit_ceil(std::max(vertexBytes, vertices_.bytes())), "menus"};
    indices_ = gl::Buffer{std::bit_ceil(std::max(indexBytes, indices_.bytes())), "menus"};
    array_ = gl::VertexArray({{&vertices_, sizeof(ImDrawVert), kAttributes}}, &indices_, kIndexType, "menus");
}

void UiPass::draw(ImDrawData const& lists, int fontVersion, gl::Framebuffer const& display) {
    if (lists.TotalIdxCount == 0 || lists.DisplaySize.x <= 0.0f || lists.DisplaySize.y <= 0.0f) return;
    if (fontVersion != fontVersion_) uploadFont();
    fontVersion_ = fontVersion;
    display.bind();
    program_.use();
    program_.set("box", glm::vec4{lists.DisplayPos.x, lists.DisplayPos.y, lists.DisplaySize.x, lists.DisplaySize.y});
    font_.bind(0);
    if (photoVersion_ >= 0) photo_.bind(1);
    for (int i = 0; i < lists.CmdListsCount; ++i) drawList(lists, *lists.CmdLists[i], display.size());
    gl::apply({});
}

void UiPass::drawList(ImDrawData const& lists, ImDrawList const& list, glm::ivec2 const& size) {
    auto const vertices = std::as_bytes(spanOf(list.VtxBuffer));
    auto const indices = std::as_bytes(spanOf(list.IdxBuffer));
    if (indices.empty()) return;
    reserve(vertices.size(), indices.size());
    vertices_.update(vertices);
    indices_.update(indices);
    for (ImDrawCmd const& command : spanOf(list.CmdBuffer)) {
        if (command.UserCallback && command.UserCallback != ImDrawCallback_ResetRenderState)
            command.UserCallback(&list, &command);
        else if (!command.UserCallback)
            drawCommand(lists, command, size);
    }
}

void UiPass::drawCommand(ImDrawData const& lists, ImDrawCmd const& command, glm::ivec2 const& size) {
    glm::vec2 const scale = glm::vec2{size} / glm::vec2{lists.DisplaySize.x, lists.DisplaySize.y};
    glm::vec2 const origin{lists.DisplayPos.x, lists.DisplayPos.y};
    glm::ivec2 const low{glm::max((glm::vec2{command.ClipRect.x, command.ClipRect.y} - origin) * scale, glm::vec2{0.0f})};
    glm::ivec2 const high{glm::min((glm::vec2{command.ClipRect.z, command.ClipRect.w} - origin) * scale, glm::vec2{size})};
    if (high.x <= low.x || high.y <= low.y) return;
    gl::DrawState state;
    state.blend = gl::Blend::alpha;
    state.scissor = true;
    state.scissorBox = {low.x, size.y - high.y, high.x - low.x, high.y - low.y};
    gl::apply(state);
    program_.set("photograph", command.TextureId == kPhotoTexture ? 1 : 0);
    gl::drawElements(array_, gl::Primitive::triangles, static_cast<int>(command.ElemCount), command.IdxOffset, 1,
                     static_cast<int>(command.VtxOffset));
}
}  // namespace luftpost::render
