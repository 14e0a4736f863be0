// The game's pages and commands: config, pause, keys.
#include <algorithm>
#include <chrono>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/platform/paths.h"
#include "engine/weather/recording.h"
#include "game/app/game.h"

namespace luftpost::app {
namespace {
bool changesFlight(std::string const& key) {
    FlightSettings settings;
    core::SettingList list;
    appendFlightSettings(list, settings);
    return core::findSetting(list, key) != nullptr;
}

/// What the recording calls itself; the file's name where it cannot be read.
std::string nameOf(std::filesystem::path const& file) {
    try {
        return weather::readRecording(file.string()).name;
    } catch (core::Error const&) {
        return file.stem().string();
    }
}

/// The weather that the menu offers: what is bundled, and the presets.
std::vector<ui::MenuWeather::Source> offeredWeather() {
    std::vector<ui::MenuWeather::Source> sources;
    std::error_code ignored;
    auto const folder = std::filesystem::absolute(platform::dataFile("assets/weather"));
    for (auto const& entry : std::filesystem::directory_iterator{folder, ignored})
        if (entry.path().extension() == ".json")
            sources.push_back({"recorded:" + entry.path().string(), nameOf(entry.path()) + " (recorded)"});
    std::sort(sources.begin(), sources.end(),
              [](auto const& a, auto const& b) { return a.source < b.source; });
    for (char const* preset : {"calm", "clear", "fair", "broken", "overcast", "storm"})
        sources.push_back({std::string{"preset:"} + preset, std::string{preset} + " (preset)"});
    return sources;
}

std::filesystem::path pictureFile() {
    std::filesystem::path const folder = platform::dataFolder() / "pictures";
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    auto const now =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    std::string name = core::formatUtc(now);
    std::replace(name.begin(), name.end(), ':', '-');
    return folder / (name + ".png");
}
}  // namespace

void Game::obey(ui::DeviceReading const& reading) {
    using ui::Command;
    if (reading.pressed(Command::camera))
        cameras_.next(session_->simulation().delivery().parcel().has_value());
    if (reading.pressed(Command::pause)) paused_ = !paused_;
    if (reading.pressed(Command::config)) configOpen_ = !configOpen_;
    if (reading.pressed(Command::normals)) debug_.normals = !debug_.normals;
    if (reading.pressed(Command::wireframe)) debug_.wireframe = !debug_.wireframe;
    if (reading.pressed(Command::keys)) keysOpen_ = !keysOpen_;
    if (reading.pressed(Command::escape)) escape();
    if (reading.pressed(Command::fullScreen))
        change({"graphics.full_screen", !settings_.graphics.fullScreen});
    if (reading.pressed(Command::picture)) takePicture();
}

/// Closes the topmost page, else opens the pause menu.
void Game::escape() {
    if (keysOpen_)
        keysOpen_ = false;
    else if (configOpen_)
        configOpen_ = false;
    else
        pauseOpen_ = !pauseOpen_;
}

void Game::takePicture() {
    double const now = session_->simulation().seconds();
    std::filesystem::path const file = pictureFile();
    try {
        writePicture(file);
        messages_.say("Picture: " + file.string(), ui::MessageKind::info, now);
    } catch (core::Error const& error) {
        messages_.say(error.what(), ui::MessageKind::bad, now);
    }
}

void Game::drawPages() {
    if (configOpen_) answerConfig(ui::drawConfigMenu(list_, menuWeather()));
    if (pauseOpen_) answerPause(ui::drawPauseMenu());
    if (keysOpen_ && ui::drawKeysPage(ui::keyHelp())) keysOpen_ = false;
}

void Game::answerConfig(ui::ConfigAnswer const& answer) {
    for (ui::SettingChange const& wanted : answer.changes) change(wanted);
    if (answer.source) useWeather(*answer.source);
    if (answer.utc) session_->input(ClockInput{*answer.utc});
    if (answer.close) configOpen_ = false;
}

void Game::answerPause(ui::PauseChoice choice) {
    using ui::PauseChoice;
    if (choice == PauseChoice::none) return;
    if (sounds_) sounds_->click();
    if (choice == PauseChoice::config) configOpen_ = true;
    if (choice == PauseChoice::keys) keysOpen_ = true;
    if (choice == PauseChoice::restart) restart();
    if (choice == PauseChoice::quit) quit_ = true;
    if (choice == PauseChoice::resume || choice == PauseChoice::restart) pauseOpen_ = paused_ = false;
}

/// Applies a setting at once: to the flight as a stamped input, to everything else directly.
void Game::change(ui::SettingChange const& wanted) {
    core::Setting* const setting = core::findSetting(list_, wanted.key);
    if (!setting || setting->get() == wanted.value) return;
    setting->set(wanted.value);
    if (changesFlight(wanted.key)) session_->input(SettingInput{wanted.key, wanted.value});
    applyGraphics();
    stored_.change(wanted.key, wanted.value);
    sinceChange_ = 0.0;
}

void Game::applyGraphics() {
    if (!surface_.hasWindow()) return;
    if (surface_.fullScreen() != settings_.graphics.fullScreen)
        surface_.setFullScreen(settings_.graphics.fullScreen);
    surface_.setVerticalSync(settings_.graphics.verticalSync);
}

void Game::useWeather(std::string const& source) {
    try {
        session_->world().loadWeather(source);
        session_->input(WeatherInput{.source = source});
        session_->world().forgetUnused();
    } catch (core::Error const& error) {
        messages_.say(error.what(), ui::MessageKind::bad, session_->simulation().seconds());
    }
}

ui::MenuWeather Game::menuWeather() const {
    static std::vector<ui::MenuWeather::Source> const kOffered = offeredWeather();
    weather::Field const& field = session_->world().field();
    bool const preset = field.origin().mode == weather::SourceMode::Preset;
    return {kOffered, session_->world().source(), session_->simulation().utc(), field.start(),
            preset ? field.start() : field.end()};
}
}  // namespace luftpost::app
