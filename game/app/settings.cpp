#include "game/app/settings.h"

namespace luftpost::app {
core::SettingList settingList(Settings& settings) {
    core::SettingList list;
    appendFlightSettings(list, settings.flight);
    core::appendSettings(list, settings.clouds, weather::cloudFields);
    core::appendSettings(list, settings.graphics, render::graphicsFields);
    core::appendSettings(list, settings.view, viewFields);
    core::appendSettings(list, settings.hud, ui::hudFields);
    core::appendSettings(list, settings.audio, audio::audioFields);
    return list;
}
}  // namespace luftpost::app
