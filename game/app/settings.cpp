#include "game/app/settings.h"

#include <fmt/format.h>

namespace luftpost::app {
namespace {
constexpr std::string_view kPageHead =
    R"(# Settings

Made by `luftpost settings --markdown`; a test compares the two. Each key may stand in `--set KEY=VALUE`, in the TOML file of
`--settings FILE`, in the player's own `settings.toml` (`$XDG_CONFIG_HOME/luftpost`, else `~/.config/luftpost`; read and written
only with a window) and in the config menu (F1). The later of these wins: player's file, `--settings`, `--set`, menu.
)";

std::string_view groupOf(core::Setting const& setting) {
    return setting.key.substr(0, setting.key.find('.'));
}
}  // namespace

core::SettingList settingList(Settings& settings) {
    core::SettingList list;
    appendFlightSettings(list, settings.flight);
    core::appendSettings(list, settings.graphics, render::graphicsFields);
    core::appendSettings(list, settings.view, viewFields);
    core::appendSettings(list, settings.hud, ui::hudFields);
    core::appendSettings(list, settings.audio, audio::audioFields);
    core::appendSettings(list, settings.weather, weatherFields);
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
