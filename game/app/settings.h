// All settings of the program: one struct, and the one list over the tables that the floors declare.
#pragma once
#include <string>

#include "engine/audio/audio_settings.h"
#include "engine/core/settings.h"
#include "engine/render/graphics_settings.h"
#include "game/app/flight_settings.h"
#include "game/app/view_settings.h"
#include "game/app/weather_settings.h"
#include "game/ui/bindings.h"
#include "game/ui/hud_settings.h"

namespace luftpost::app {
struct Settings {
    FlightSettings flight;
    render::GraphicsSettings graphics;
    ViewSettings view;
    ui::HudSettings hud;
    audio::AudioSettings audio;
    WeatherSettings weather;
    ui::MouseSettings mouse;
    ui::Bindings bindings;
};

/// The list over `settings`, in the order of the config menu's pages. Valid as long as `settings` stays where
/// it is.
core::SettingList settingList(Settings& settings);

/// docs/settings.md: every setting with its values, its default and its help, a table for each group.
std::string settingsPage();
}  // namespace luftpost::app
