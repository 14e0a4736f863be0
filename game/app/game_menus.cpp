// The game's pages and commands: config, pause, keys.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/platform/paths.h"
#include "engine/weather/source.h"
#include "game/app/game.h"
#include "game/app/live_weather.h"

namespace luftpost::app {
namespace {
bool changesFlight(std::string const& key) {
    FlightSettings settings;
    core::SettingList list;
    appendFlightSettings(list, settings);
    return core::findSetting(list, key) != nullptr;
}

std::filesystem::path pictureFile(std::string const& ending) {
    std::filesystem::path const folder = platform::dataFolder() / "pictures";
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    auto const now =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    std::string name = core::formatUtc(now);
    std::replace(name.begin(), name.end(), ':', '-');
    return folder / (name + ending);
}
}  // namespace

void Game::obey(ui::DeviceReading const& reading) {
    using ui::Command;
    if (studio_) return obeyStudio(reading);
    if (reading.pressed(Command::studio)) openStudio();
    if (replay_) return obeyReplay(reading);
    obeyFlying(reading);
    obeyView(reading);
}

/// What a flight has and a replay has not.
void Game::obeyFlying(ui::DeviceReading const& reading) {
    using ui::Command;
    if (reading.pressed(Command::pause)) paused_ = !paused_;
    if (reading.pressed(Command::weather)) configOpen_ = weatherPage_ = true;
    if (reading.pressed(Command::photo)) nextPhotoMode();
    if (reading.pressed(Command::escape)) escape();
}

void Game::obeyView(ui::DeviceReading const& reading) {
    using ui::Command;
    if (reading.pressed(Command::camera))
        cameras_.next(session_->simulation().delivery().parcel().has_value());
    if (reading.mode) cameras_.select(*reading.mode);
    if (reading.pressed(Command::hudDensity)) nextDensity();
    if (reading.pressed(Command::mouseFlight)) change({"controls.mouseFlight", !settings_.mouse.flight});
    if (reading.pressed(Command::config)) configOpen_ = !configOpen_;
    if (reading.pressed(Command::normals)) debug_.normals = !debug_.normals;
    if (reading.pressed(Command::wireframe)) debug_.wireframe = !debug_.wireframe;
    if (reading.pressed(Command::keys)) keysOpen_ = !keysOpen_;
    if (reading.pressed(Command::air)) change({"hud.air", !settings_.hud.air});
    if (reading.pressed(Command::fullScreen))
        change({"graphics.full_screen", !settings_.graphics.fullScreen});
    if (reading.pressed(Command::picture)) takePicture();
}

/// Those that do not change the flight: a replay keeps its own.
core::SettingList Game::viewersSettings() const {
    core::SettingList settings = list_;
    std::erase_if(settings, [](core::Setting const& setting) { return changesFlight(std::string{setting.key}) || setting.key.starts_with("weather."); });
    return settings;
}

void Game::obeyReplay(ui::DeviceReading const& reading) {
    using ui::Command;
    obeyView(reading);
    if (reading.pressed(Command::pause)) replay_->toggle(*session_);
    if (replay_->obey(reading.flight, *session_)) jumped();
    if (!reading.pressed(Command::escape)) return;
    if (keysOpen_ || configOpen_) escape();
    else quit_ = true;
}

void Game::drawReplay() {
    ui::ReplayAnswer const answer = ui::drawReplayBar(replay_->bar(session_->simulation()));
    if (answer.toggle) replay_->toggle(*session_);
    if (answer.speed) replay_->setSpeed(*answer.speed);
    if (answer.seconds) replay_->seek(*answer.seconds, *session_);
    if (answer.seconds || answer.toggle) jumped();
}

/// The replay is somewhere else: what was said is past, and the camera stands where the aircraft is.
void Game::jumped() {
    messages_ = {};
    ui::CameraMode const mode = cameras_.mode();
    if (mode == ui::CameraMode::free) return;
    cameras_.reset(cameraSubject(session_->simulation(), shownPose(session_->simulation(), 1.0)), groundHeight());
    if (mode == ui::CameraMode::cockpit) cameras_.select(mode);
}

void Game::nextDensity() {
    auto const next = (static_cast<std::size_t>(settings_.hud.density) + 1) % ui::kDensityWords.size();
    change({"hud.density", std::string{ui::kDensityWords[next]}});
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
    std::filesystem::path const file = pictureFile(".png");
    try {
        writePicture(file);
        messages_.say("Picture: " + file.string(), ui::MessageKind::info, now);
    } catch (core::Error const& error) {
        messages_.say(error.what(), ui::MessageKind::bad, now);
    }
}

void Game::openStudio() {
    configOpen_ = keysOpen_ = false;
    studio_.emplace(cameras_, session_->simulation().utc(), settings_.graphics);
}

void Game::obeyStudio(ui::DeviceReading const& reading) {
    using ui::Command;
    if (reading.pressed(Command::fullScreen)) change({"graphics.full_screen", !settings_.graphics.fullScreen});
    if (reading.pressed(Command::picture) && !studio_->saving()) saveStudioPicture();
    if (!reading.pressed(Command::escape) && !reading.pressed(Command::studio)) return;
    if (studio_->saving()) studio_->stop();
    else studio_.reset();
}

void Game::drawStudio() {
    ui::StudioAnswer const answer = ui::drawStudioPage(studio_->page(renderer_.size()));
    studio_->setView(answer.view);
    if (answer.stop) studio_->stop();
    if (answer.save) saveStudioPicture();
    if (answer.close) studio_.reset();
}

/// Draws the whole once, without the page; the tiles follow, one a frame.
void Game::saveStudioPicture() {
    FrameStep const now{0, 1.0, 0.0, 0.0};
    render::Snapshot still = pictureOf(now, nullptr, true);
    still.photo = nullptr;
    still.graphics.resolution = Studio::wholeResolution(renderer_.size());
    try {
        renderer_.draw(still);
        studio_->save(renderer_, still, renderer_.size(), pictureFile(studio_->view().linear ? ".exr" : ".png"));
    } catch (core::Error const& error) {
        studio_->note(error.what(), true);
    }
}

void Game::drawPages() {
    if (configOpen_ && replay_) {
        answerConfig(ui::drawConfigMenu(viewersSettings(), {std::nullopt, settings_.bindings, bindingsPage_, input_}));
    } else if (configOpen_) {
        constexpr int kTrialTicks = 480;  // a frame: some three milliseconds
        if (!response_) response_.emplace(session_->simulation().aircraft().airframe());
        response_->follow(settings_.flight.pilot, settings_.flight.assist, kTrialTicks);
        answerConfig(ui::drawConfigMenu(
            list_, {menuWeather(), settings_.bindings, bindingsPage_, input_, std::exchange(weatherPage_, false), &response_->curves()}));
    } else {
        response_.reset();
        bindingsPage_.giveUp();
    }
    if (pauseOpen_) answerPause(ui::drawPauseMenu());
    if (keysOpen_ && ui::drawKeysPage(ui::keyHelp(settings_.bindings))) keysOpen_ = false;
}

void Game::answerConfig(ui::ConfigAnswer const& answer) {
    for (ui::SettingChange const& wanted : answer.changes) change(wanted);
    answerWeather(answer.weather);
    if (answer.close) configOpen_ = false;
}

void Game::answerPause(ui::PauseChoice choice) {
    using ui::PauseChoice;
    if (choice == PauseChoice::none) return;
    if (sounds_) sounds_->click();
    if (choice == PauseChoice::config) configOpen_ = true;
    if (choice == PauseChoice::keys) keysOpen_ = true;
    if (choice == PauseChoice::studio) openStudio();
    if (choice == PauseChoice::restart) restart();
    if (choice == PauseChoice::quit) quit_ = true;
    if (choice == PauseChoice::resume || choice == PauseChoice::restart) pauseOpen_ = paused_ = false;
}

/// Whoever moves what a preset decides goes on from the preset with settings of their own.
void Game::leavePreset(std::string const& key) {
    if (settings_.graphics.quality == render::Quality::own || !render::decidedByQuality(key)) return;
    weather::CloudSettings clouds = settings_.flight.clouds;
    render::applyQuality(settings_.graphics.quality, settings_.graphics, clouds);
    settings_.graphics.quality = render::Quality::own;
    for (core::Setting const& setting : list_)
        if (setting.key == "graphics.quality" || render::decidedByQuality(setting.key)) stored_.change(setting.key, setting.get());
}

/// Applies a setting at once: to the flight as a stamped input, to everything else directly.
void Game::change(ui::SettingChange const& wanted) {
    core::Setting* const setting = core::findSetting(list_, wanted.key);
    if (!setting || setting->get() == wanted.value) return;
    leavePreset(wanted.key);
    setting->set(wanted.value);
    if (changesFlight(wanted.key)) session_->input(SettingInput{wanted.key, wanted.value});
    if (wanted.key == "view.camera") cameras_.select(settings_.view.camera);
    applyGraphics();
    followWeatherSettings();
    stored_.change(wanted.key, wanted.value);
    sinceChange_ = 0.0;
}

void Game::applyGraphics() {
    if (!surface_.hasWindow()) return;
    if (surface_.fullScreen() != settings_.graphics.fullScreen)
        surface_.setFullScreen(settings_.graphics.fullScreen);
    surface_.setVerticalSync(settings_.graphics.verticalSync);
}

/// The feed is the one that the settings ask for; none where they ask for none.
void Game::followWeatherSettings() {
    WeatherSettings const& wanted = settings_.weather;
    if (!wanted.live) return feed_.reset();
    if (feed_ && feed_->settings() == wanted) return;
    bool const window = surface_.hasWindow();
    if (!feed_ && window) session_->input(ClockInput{weather::contextOfNow().latest});  // live is now
    feed_ = std::make_shared<WeatherFeed>(wanted, window ? FeedPace::beside : FeedPace::inLine, feedCacheFolder(wanted, window));
}

void Game::complain(std::optional<std::string> const& what) {
    if (what) messages_.say(*what, ui::MessageKind::bad, session_->simulation().seconds());
}

ui::MenuWeather Game::menuWeather() {
    ui::MenuWeather menu = desk_.menu(*session_);
    if (photo_) menu.photo = photo_->state();
    if (!feed_) return menu;
    ProviderFacts const& facts = factsOf(feed_->settings().provider);
    FeedStatus const status = feed_->status(feedTime(*feed_, session_->simulation()));
    menu.current = kLiveSource;
    menu.live = {fmt::format("{} ({}).", facts.attribution, facts.limits)};
    if (status.line != facts.attribution) menu.live.push_back(status.line);
    return menu;
}

void Game::answerWeather(ui::WeatherAnswer const& answer) {
    // Another weather than the feed's ends it: it would come back with the next arrival.
    if (answer.source) change({"weather.live", *answer.source == kLiveSource});
    if (answer.hand || answer.startFromHere || answer.hour) change({"weather.live", false});
    auto const hour = desk_.obey(answer, *session_);
    complain(desk_.takeComplaint());
    if (answer.photo && photo_) photo_->view() = *answer.photo;
    if (answer.comparePhoto) comparePhoto();
    if (hour) flyHour(*hour);
}

/// A new flight there and then.
void Game::flyHour(RealHour const& hour) {
    try {
        SessionOptions plan = plan_;
        plan.plan = planFor(hour, plan_.plan);
        plan.script.clear();
        plan.plan.simulation.settings = settings_.flight;
        session_ = std::make_unique<Session>(plan);
        plan_ = std::move(plan);
        air_ = {};
        beginFlight();
        messages_.say(hour.name, ui::MessageKind::info, session_->simulation().seconds());
    } catch (core::Error const& error) {
        complain(error.what());
    }
}

/// Over the picture, split, side by side, hidden, and round again.
void Game::nextPhotoMode() {
    if (!photo_) return complain("No photograph: start with --photo FILE");
    using ui::PhotoMode;
    PhotoMode& mode = photo_->view().mode;
    mode = mode == PhotoMode::over ? PhotoMode::split : mode == PhotoMode::split ? PhotoMode::beside : mode == PhotoMode::beside ? PhotoMode::hidden : PhotoMode::over;
}

/// The picture alone, without instruments and photograph, beside the photograph.
void Game::comparePhoto() {
    if (!photo_) return;
    FrameStep const now{0, 1.0, 0.0, 0.0};
    renderer_.draw(pictureOf(now, nullptr, false));
    photo_->compare(renderer_.readPixels());
}

void Game::drawAir() {
    Simulation const& simulation = session_->simulation();
    flight::AircraftState const& aircraft = simulation.aircraft().state();
    ui::AirSubject const subject{aircraft.positionWorld, aircraft.readings.heading};
    weather::AirInstant const air = simulation.airNow();
    air_.update([&](glm::dvec3 const& p, core::UtcSeconds) { return air.at(p); }, session_->world().ground(), subject, simulation.utc());
    ui::drawAirOverlay({subject, {air_.winds().begin(), air_.winds().end()}, air_.lift(), cameras_.pose()});
}
}  // namespace luftpost::app
