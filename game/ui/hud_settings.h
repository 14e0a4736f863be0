// How the player wants the instruments.
#pragma once
#include <array>
#include <string_view>
#include <tuple>

#include "engine/core/settings.h"
#include "game/ui/hud.h"

namespace luftpost::ui {
inline constexpr std::array<std::string_view, 3> kDensityWords{"full", "reduced", "minimal"};

struct HudSettings {
    bool visible = true;
    HudDensity density = HudDensity::full;
    bool air = false;
    float scale = 1.0f;  // times height of the window / 720
};

inline constexpr std::tuple hudFields{
    core::Field{&HudSettings::visible, "hud.visible", "Instruments and navigation bar are shown"},
    core::Field{&HudSettings::density, "hud.density", kDensityWords,
                "How much is shown: full, reduced (speed, height, levers, navigation) or minimal"},
    core::Field{&HudSettings::air, "hud.air", "The air is shown: winds by height, where it rises and where it sinks"},
    core::Field{&HudSettings::scale, "hud.scale", 0.5f, 2.0f, "Size of instruments and menus"}};
}  // namespace luftpost::ui
