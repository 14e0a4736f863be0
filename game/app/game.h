// The game as one sees it: devices in, ticks, sound and a picture out. Main thread; the GL context is
// current.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "engine/platform/surface.h"
#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "game/app/frame_clock.h"
#include "game/app/messages.h"
#include "game/app/photo_box.h"
#include "game/app/play_options.h"
#include "game/app/response_trial.h"
#include "game/app/player_files.h"
#include "game/app/replay_view.h"
#include "game/app/session.h"
#include "game/app/snapshot_builder.h"
#include "game/app/sound_stage.h"
#include "game/app/studio.h"
#include "game/app/trails.h"
#include "game/app/weather_desk.h"
#include "game/delivery/career.h"
#include "game/ui/air_overlay.h"
#include "game/ui/bindings_page.h"
#include "game/ui/devices.h"
#include "game/ui/menu.h"
#include "game/ui/screen_frame.h"

namespace luftpost::app {
class Game {
public:
    /// `surface` is current and prepared and outlives the game. Throws core::Error where data does not load.
    Game(PlayOptions options, platform::Surface& surface);

    /// One frame: what the devices say, so many ticks, sound, picture.
    void frame(FrameStep const& step);
    /// The present state once more with every ray, read back and written.
    void writePicture(std::filesystem::path const& file);

    bool paused() const {
        return paused_ || pauseOpen_ || studio_ || (replay_ && !replay_->playing());
    }
    /// Seconds of flight to one of the player's.
    double pace() const { return replay_ ? replay_->speed() : 1.0; }
    bool over() const { return quit_; }
    Session& session() { return *session_; }
    Settings const& settings() const { return settings_; }
    render::Renderer& renderer() { return renderer_; }
    /// Writes the settings if the player has changed one since they were written.
    void saveChanges();

private:
    void readDevices(FrameStep const& step);
    void takeWeather();
    void advance(FrameStep const& step);
    void takeEvents();
    void moveCamera(FrameStep const& step);
    void moveTrails(FrameStep const& step);
    ImDrawData const* drawScreen(FrameStep const& step);
    void drawPages();
    void holdMouse();
    render::Snapshot pictureOf(FrameStep const& step, ImDrawData const* screen, bool still) const;
    void drawPicture(FrameStep const& step, ImDrawData const* screen, bool still);
    void drawSaving(ImDrawData const* screen);
    void show();
    ui::CameraPose const& pose() const { return studio_ ? studio_->pose() : cameras_.pose(); }
    bool inside() const { return !studio_ && cameras_.inside(); }
    void obey(ui::DeviceReading const& reading);
    void escape();
    void nextDensity();
    void takePicture();
    void obeyFlying(ui::DeviceReading const& reading);
    void obeyView(ui::DeviceReading const& reading);
    core::SettingList viewersSettings() const;
    void obeyReplay(ui::DeviceReading const& reading);
    void drawReplay();
    void jumped();
    void openStudio();
    void obeyStudio(ui::DeviceReading const& reading);
    void drawStudio();
    void saveStudioPicture();
    void answerConfig(ui::ConfigAnswer const& answer);
    void answerPause(ui::PauseChoice choice);
    void change(ui::SettingChange const& change);
    void leavePreset(std::string const& key);
    void answerWeather(ui::WeatherAnswer const& answer);
    void flyHour(RealHour const& hour);
    void nextPhotoMode();
    void comparePhoto();
    void drawAir();
    void complain(std::optional<std::string> const& what);
    void followWeatherSettings();
    ui::MenuWeather menuWeather();
    ui::HudWeather hudWeather() const;
    void restart();
    void beginFlight();
    void count(FlightEventAt const& event);
    void applyGraphics();
    ui::HudState hudState();
    ui::GroundHeight groundHeight() const;
    glm::dvec3 towerEye() const;

    SessionOptions plan_;
    RunOptions run_;
    platform::Surface& surface_;
    Settings settings_;
    core::SettingList list_;
    StoredSettings stored_;
    std::optional<ReplayView> replay_;  // of a replay that is watched; the session may have weather of its reel
    std::unique_ptr<Session> session_;
    std::shared_ptr<WeatherFeed> feed_;  // of live weather
    render::Renderer renderer_;
    GameModels models_;
    ui::ScreenFrame screen_;
    ui::Devices devices_;
    ui::BindingsPage bindingsPage_;
    std::optional<ResponseTrial> response_;  // while the config menu is open
    platform::Input const* input_ = nullptr;  // none without a window
    ui::DeviceReading reading_;
    ui::InputSample sample_;
    ui::Cameras cameras_;
    Trails trails_;
    std::optional<SoundStage> sounds_;  // with a window
    Messages messages_;
    WeatherDesk desk_;
    std::optional<PhotoBox> photo_;  // of --photo
    std::optional<Studio> studio_;   // while it is open
    ui::AirProbe air_;
    delivery::Career career_;
    render::DebugViews debug_;
    render::ResolutionScale resolution_;
    bool configOpen_ = false, keysOpen_ = false, pauseOpen_ = false;
    bool weatherPage_ = false;  // the config menu opens there
    bool paused_ = false;
    bool quit_ = false;
    bool mouseHeld_ = false;  // the pointer is hidden: the mouse is the stick
    double sinceChange_ = 0.0;  // s of the player's time
};
}  // namespace luftpost::app
