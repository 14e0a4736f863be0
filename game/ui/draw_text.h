// Small helpers over Dear ImGui's draw list, shared by HUD and menus. Between ScreenFrame::begin and end.
#pragma once
#include <imgui.h>

#include <string>

#include <glm/glm.hpp>

#include "game/ui/screen_frame.h"

namespace luftpost::ui {
namespace colour {
inline constexpr ImU32 kPaper = IM_COL32(250, 245, 230, 255);
inline constexpr ImU32 kFaint = IM_COL32(228, 222, 206, 255);
inline constexpr ImU32 kInk = IM_COL32(16, 18, 22, 255);
inline constexpr ImU32 kPlate = IM_COL32(14, 18, 24, 172);
inline constexpr ImU32 kHalo = IM_COL32(8, 10, 14, 205);
inline constexpr ImU32 kYellow = IM_COL32(252, 196, 44, 255);
inline constexpr ImU32 kBlue = IM_COL32(20, 98, 232, 255);
inline constexpr ImU32 kGreen = IM_COL32(92, 206, 104, 255);
inline constexpr ImU32 kRed = IM_COL32(236, 66, 50, 255);
}  // namespace colour

inline ImVec2 im(glm::vec2 v) { return {v.x, v.y}; }

/// Size of a line, pixels.
glm::vec2 textSize(Face const& face, std::string const& text);
/// A line with its dark halo. `align`: 0 left of, 0.5 around, 1 right of `at` (upper edge). Returns its width.
float drawText(ImDrawList& list, Face const& face, glm::vec2 at, ImU32 colour, std::string const& text, float align = 0.0f);
/// A line without halo (on light ground).
float drawPlainText(ImDrawList& list, Face const& face, glm::vec2 at, ImU32 colour, std::string const& text,
                    float align = 0.0f);
/// Fades a colour; 0..1.
ImU32 faded(ImU32 colour, float alpha);
/// A filled arrow from `from` to `to`, `width` pixels thick, its head three times as wide.
void drawArrow(ImDrawList& list, glm::vec2 from, glm::vec2 to, float width, ImU32 colour);
/// A key's cap with its letter; `at` upper left. Returns its width.
float drawKeyCap(ImDrawList& list, Face const& face, glm::vec2 at, std::string const& cap, float alpha = 1.0f);
}  // namespace luftpost::ui
