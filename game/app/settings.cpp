#include "game/app/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace luftpost::app {
namespace {
constexpr std::string_view kPageHead =
    R"(# Settings

Made by `luftpost settings --markdown`; a test compares the two. Each key may stand in `--set KEY=VALUE`, in the TOML file of
`--settings FILE`, in the player's own `settings.toml` (`$XDG_CONFIG_HOME/luftpost`, else `~/.config/luftpost`; read and written
only with a window) and in the config menu (F1). The later of these wins: player's file, `--settings`, `--set`, menu.

Keys and buttons are words with spaces between, any number of them, none too: `w`, `leftShift`, `shift+f` (`control+`, `alt+`), `mouse.left`,
`wheel.up`, `pad.south`, `joy1.button3` (hats are the last buttons). Axes are `pad.leftX`, `joy1.axis2`; a minus before one turns it round. What is
bound to two actions does both. Keys are named after their place on a US keyboard.
)";

std::string_view groupOf(core::Setting const& setting) {
    return setting.key.substr(0, setting.key.find('.'));
}

/// Groups in the order in which they come first, their settings together.
void gather(core::SettingList& list) {
    std::vector<std::string_view> groups;
    for (core::Setting const& setting : list)
        if (std::find(groups.begin(), groups.end(), groupOf(setting)) == groups.end()) groups.push_back(groupOf(setting));
    auto const place = [&](core::Setting const& setting) { return std::find(groups.begin(), groups.end(), groupOf(setting)); };
    std::stable_sort(list.begin(), list.end(), [&](core::Setting const& a, core::Setting const& b) { return place(a) < place(b); });
}
}  // namespace

core::SettingList settingList(Settings& settings) {
    core::SettingList list;
    appendFlightSettings(list, settings.flight);
    core::appendSettings(list, settings.mouse, ui::mouseFields);
    core::appendSettings(list, settings.graphics, render::graphicsFields);
    core::appendSettings(list, settings.view, viewFields);
    core::appendSettings(list, settings.hud, ui::hudFields);
    core::appendSettings(list, settings.audio, audio::audioFields);
    core::appendSettings(list, settings.weather, weatherFields);
    ui::appendBindingSettings(list, settings.bindings);
    gather(list);
    return list;
}

std::string settingsPage() {
    Settings settings;
    std::string page{kPageHead};
    std::string_view group;
    for (core::Setting const& setting : settingList(settings)) {
        if (groupOf(setting) != group) {
            group = groupOf(setting);
            page += fmt::format("\n## {}\n\n| key | values | default | what it does |\n|---|---|---|---|\n", group);
        }
        page += fmt::format("| `{}` | {} | {} | {} |\n", setting.key, core::expectedValue(setting),
                            core::settingText(setting.initial), setting.help);
    }
    return page;
}
}  // namespace luftpost::app
