#include "game/app/settings.h"

namespace luftpost::app {
core::SettingList settingList(Settings& settings) {
    core::SettingList list;
    core::appendSettings(list, settings.hud, ui::hudFields);
    core::appendSettings(list, settings.audio, audio::audioFields);
    return list;
}
}  // namespace luftpost::app
