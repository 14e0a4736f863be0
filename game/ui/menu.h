// The menus: config (F1), pause (Esc), keys (H). Each draws from plain data and answers with what the player asked for;
// nothing is applied here. Main thread, between ScreenFrame::begin and end.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/settings.h"
#include "game/ui/weather_page.h"

namespace luftpost::ui {
/// A changed setting: the new value, of the setting's type and within its range.
struct SettingChange {
    std::string key;
    core::SettingValue value;
};

/// What the player did in the config menu this frame.
struct ConfigAnswer {
    std::vector<SettingChange> changes;
    WeatherAnswer weather;
    bool close = false;  // the cross
};

/// The config menu at the right of the screen: flight goes on beside it. Pages are the groups of the keys ("clouds.hg"
/// belongs to "clouds"); which one is open is kept by Dear ImGui, unless `weatherPage` brings that one to the front. Without weather there is no such page.
ConfigAnswer drawConfigMenu(core::SettingList const& settings, std::optional<MenuWeather> const& weather, bool weatherPage = false);

enum class PauseChoice { none, resume, studio, config, keys, restart, quit };
/// The pause menu in the middle of the screen.
PauseChoice drawPauseMenu();

/// One row of the key help: what the key does and its caps in the layout (and on the gamepad) in hand.
struct KeyHelp {
    std::string group;    // "Flight", "View", "Game"
    std::string caps;     // "A D"
    std::string gamepad;  // "left stick"; empty: none
    std::string action;   // "roll"
};
/// The keys page. True when its cross was clicked.
bool drawKeysPage(std::span<KeyHelp const> rows);
}  // namespace luftpost::ui
