// The menus: config (F1), pause (Esc), keys (H). Each draws from plain data and answers with what the player asked for;
// nothing is applied here. Main thread, between ScreenFrame::begin and end.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/settings.h"
#include "game/ui/bindings_page.h"
#include "game/ui/response_plot.h"
#include "game/ui/weather_page.h"

namespace luftpost::ui {
/// What the player did in the config menu this frame.
struct ConfigAnswer {
    std::vector<SettingChange> changes;
    WeatherAnswer weather;
    bool close = false;  // the cross
};

/// What the config menu shows beside the settings themselves.
struct ConfigPages {
    std::optional<MenuWeather> weather;  // none: no such page
    Bindings const& bindings;
    BindingsPage& bindingsPage;
    platform::Input const* input = nullptr;  // none without a window
    bool weatherPage = false;                // brings that one to the front
    ResponseCurves const* response = nullptr;  // of the assist's settings, for their page
};

/// The config menu at the right of the screen: flight goes on beside it. Pages are the groups of the keys ("clouds.hg"
/// belongs to "clouds"); which one is open is kept by Dear ImGui.
ConfigAnswer drawConfigMenu(core::SettingList const& settings, ConfigPages const& pages);

enum class PauseChoice { none, resume, studio, config, keys, restart, quit };
/// The pause menu in the middle of the screen.
PauseChoice drawPauseMenu();

/// The keys page. True when its cross was clicked.
bool drawKeysPage(std::span<KeyHelp const> rows);
}  // namespace luftpost::ui
