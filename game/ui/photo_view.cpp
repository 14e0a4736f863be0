#include "game/ui/photo_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/render/snapshot.h"
#include "game/ui/draw_text.h"

namespace luftpost::ui {
namespace {
constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255);

/// The part of the screen right of `left` shows the same part of the photograph, as opaque as asked.
void drawPart(ImDrawList& list, PhotoState const& photo, glm::vec2 size, float left, float opacity) {
    PhotoCrop const crop = photoCrop(photo.size, size);
    float const share = left / size.x;
    glm::vec2 const uvFrom{glm::mix(crop.uvFrom.x, crop.uvTo.x, share), crop.uvFrom.y};
    list.AddImage(render::kPhotoTexture, {left, 0.0f}, im(size), im(uvFrom), im(crop.uvTo), faded(kWhite, opacity));
}

void drawSplitLine(ImDrawList& list, float x, float high) {
    float const s = fonts().scale;
    list.AddLine({x, 0.0f}, {x, high}, colour::kInk, 4.0f * s);
    list.AddLine({x, 0.0f}, {x, high}, colour::kPaper, 2.0f * s);
    drawText(list, fonts().small, {x - 8.0f * s, 0.5f * high}, colour::kPaper, "game", 1.0f);
    drawText(list, fonts().small, {x + 8.0f * s, 0.5f * high}, colour::kPaper, "photograph");
}

/// Right half of the screen: the photograph whole, its proportions kept; the picture goes on beneath and beside it.
void drawBeside(ImDrawList& list, PhotoState const& photo, glm::vec2 size) {
    glm::vec2 const half{0.5f * size.x, size.y};
    float const scale = std::min(half.x / static_cast<float>(photo.size.x), half.y / static_cast<float>(photo.size.y));
    glm::vec2 const wide = scale * glm::vec2{photo.size}, from{half.x, 0.5f * (size.y - wide.y)};
    list.AddRectFilled({half.x, 0.0f}, im(size), colour::kInk);
    list.AddImage(render::kPhotoTexture, im(from), im(from + wide), {0.0f, 0.0f}, {1.0f, 1.0f}, kWhite);
    drawSplitLine(list, half.x, size.y);
}
}  // namespace

PhotoCrop photoCrop(glm::ivec2 photo, glm::vec2 size) {
    glm::vec2 const own{glm::max(photo, glm::ivec2{1})};
    // The share of each side that stays when the photograph covers the whole of `size`.
    float const scale = std::max(size.x / own.x, size.y / own.y);
    glm::vec2 const seen = glm::min(size / (scale * own), glm::vec2{1.0f});
    return {0.5f * (glm::vec2{1.0f} - seen), 0.5f * (glm::vec2{1.0f} + seen)};
}

void drawPhoto(PhotoState const& photo) {
    if (photo.name.empty() || photo.view.mode == PhotoMode::hidden) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    ImVec2 const display = ImGui::GetIO().DisplaySize;
    glm::vec2 const size{display.x, display.y};
    if (photo.view.mode == PhotoMode::beside) return drawBeside(list, photo, size);
    if (photo.view.mode == PhotoMode::over) return drawPart(list, photo, size, 0.0f, static_cast<float>(photo.view.opacity));
    auto const x = static_cast<float>(photo.view.split) * size.x;
    if (x < size.x) drawPart(list, photo, size, x, 1.0f);
    drawSplitLine(list, x, size.y);
}
}  // namespace luftpost::ui
