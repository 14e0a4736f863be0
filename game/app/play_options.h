// The command line of `play` and `replay`, read and checked before anything is made.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/photo.h"
#include "game/app/commands.h"
#include "game/app/session.h"
#include "game/app/weather_feed.h"

namespace luftpost::app {
/// As typed.
struct PlayTexts {
    bool headless = false, noRender = false;
    std::string bot, start, assist, payload, fuel, seconds, frameRate, workers;
    std::filesystem::path input, log, exported, report, screenshot, saveReplay, saveWeather, save, photo;
};

/// How a flight is run and what is written about it.
struct RunOptions {
    bool headless = false, noRender = false;
    bool watch = false;              // a replay in a window
    std::optional<long long> ticks;  // none: until the window closes
    double frameRate = 60.0;         // frames of simulated time a second
    int workers = 1;
    glm::ivec2 size{1280, 720};
    Settings settings;
    std::filesystem::path log, exported, report, screenshot, saveReplay, saveWeather;
    std::vector<assets::PhotoFile> photos;  // of --photo
    std::filesystem::path save, settingsFile;  // the player's; empty: neither read nor written
    std::shared_ptr<WeatherFeed> feed;         // of live weather
};

struct PlayOptions {
    SessionOptions session;
    RunOptions run;
};

/// Reads and checks everything of `play`: texts, input file, weather, start. Throws core::Error.
PlayOptions playOptions(PlayTexts const& texts, CommonOptions const& common);
/// The same for `replay FILE`: the flight comes from the file.
PlayOptions replayOptions(std::filesystem::path const& file, PlayTexts const& texts,
                          CommonOptions const& common);
}  // namespace luftpost::app
