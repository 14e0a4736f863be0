#include "game/ui/draw_text.h"

#include <algorithm>
#include <cmath>

namespace luftpost::ui {
namespace {
glm::vec2 placed(Face const& face, glm::vec2 at, std::string const& text, float align) {
    float const width = align == 0.0f ? 0.0f : textSize(face, text).x;
    return glm::round(at - glm::vec2{align * width, 0.0f});
}
}  // namespace

glm::vec2 textSize(Face const& face, std::string const& text) {
    ImVec2 const size = face.letters->CalcTextSizeA(face.size_px, 1e6f, 0.0f, text.data(), text.data() + text.size());
    return {size.x, size.y};
}

float drawText(ImDrawList& list, Face const& face, glm::vec2 at, ImU32 colour, std::string const& text, float align) {
    ImVec2 const from = im(placed(face, at, text, align));
    char const* const end = text.data() + text.size();
    float const alpha = static_cast<float>(colour >> IM_COL32_A_SHIFT & 255) / 255.0f;
    list.AddText(face.halo, face.size_px, from, faded(colour::kHalo, alpha), text.data(), end);
    list.AddText(face.letters, face.size_px, from, colour, text.data(), end);
    return textSize(face, text).x;
}

float drawPlainText(ImDrawList& list, Face const& face, glm::vec2 at, ImU32 colour, std::string const& text, float align) {
    list.AddText(face.letters, face.size_px, im(placed(face, at, text, align)), colour, text.data(), text.data() + text.size());
    return textSize(face, text).x;
}

ImU32 faded(ImU32 colour, float alpha) {
    auto const own = static_cast<float>(colour >> IM_COL32_A_SHIFT & 255);
    auto const a = static_cast<ImU32>(std::lround(own * std::clamp(alpha, 0.0f, 1.0f)));
    return (colour & ~IM_COL32_A_MASK) | a << IM_COL32_A_SHIFT;
}

void drawArrow(ImDrawList& list, glm::vec2 from, glm::vec2 to, float width, ImU32 colour) {
    glm::vec2 const way = to - from;
    float const span = glm::length(way);
    if (span < 1.0f) return;
    glm::vec2 const ahead = way / span, side{-ahead.y, ahead.x};
    float const head = std::min(3.2f * width, span);
    glm::vec2 const neck = to - head * ahead;
    if (span > head) list.AddLine(im(from), im(neck + 0.5f * ahead), colour, width);
    list.AddTriangleFilled(im(to), im(neck + 1.6f * width * side), im(neck - 1.6f * width * side), colour);
}

float drawKeyCap(ImDrawList& list, Face const& face, glm::vec2 at, std::string const& cap, float alpha) {
    float const pad = 0.42f * face.size_px, high = 1.32f * face.size_px;
    float const wide = std::max(high, textSize(face, cap).x + 2.0f * pad);
    glm::vec2 const size{std::round(wide), std::round(high)};
    float const round = 0.28f * face.size_px;
    list.AddRectFilled(im(at + glm::vec2{0.0f, 0.11f * face.size_px}), im(at + size + glm::vec2{0.0f, 0.11f * face.size_px}),
                       faded(IM_COL32(120, 110, 88, 255), alpha), round);
    list.AddRectFilled(im(at), im(at + size), faded(IM_COL32(247, 240, 222, 255), alpha), round);
    drawPlainText(list, face, at + glm::vec2{0.5f * size.x, 0.15f * face.size_px}, faded(colour::kInk, alpha), cap, 0.5f);
    return size.x;
}
}  // namespace luftpost::ui
