// All settings of the program: one struct, and the one list over the tables that the floors declare.
#pragma once
#include "engine/audio/audio_settings.h"
#include "engine/core/settings.h"
#include "game/ui/hud_settings.h"

namespace luftpost::app {
struct Settings {
    audio::AudioSettings audio;
    ui::HudSettings hud;
};

/// The list over `settings`, in the order of the config menu's pages. Valid as long as `settings` stays where
/// it is.
core::SettingList settingList(Settings& settings);
}  // namespace luftpost::app
