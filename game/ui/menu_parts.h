// What the pages of the menus are put together from. Between ScreenFrame::begin and end.
#pragma once
#include <imgui.h>

#include <string>
#include <string_view>

#include "game/ui/draw_text.h"
#include "game/ui/screen_frame.h"

namespace luftpost::ui {
/// Pixels per unit of layout.
inline float unit() { return fonts().scale; }

/// A page in a tab bar, its title in small letters. Ends with ImGui::EndTabItem when it is open.
bool beginPage(char const* title);

/// The help in small letters; a note in brackets at its end is left to the tooltip.
void drawHelp(std::string_view help);

/// The value over the item just drawn, with a halo, so that the slider's grab does not hide it.
void drawNumberText(std::string const& format, double value);

/// A slider with its figure over it in the width set for the next item. True when the player moved it.
bool drawSlider(char const* id, double& value, double least, double most, std::string const& format, bool logarithmic = false);
/// The same with its label before it, as the settings have it.
bool drawSliderRow(char const* label, double& value, double least, double most, std::string const& format, bool logarithmic = false);
}  // namespace luftpost::ui
