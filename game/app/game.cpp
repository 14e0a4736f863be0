#include "game/app/game.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/assets/image.h"
#include "engine/core/error.h"
#include "engine/core/frames.h"
#include "engine/gl/context.h"
#include "engine/gl/draw.h"
#include "game/app/instruments.h"
#include "game/app/live_weather.h"
#include "game/app/player_files.h"
#include "game/app/weather_source.h"
#include "engine/weather/source.h"

namespace luftpost::app {
namespace {
constexpr double kPromptSeconds = 60.0;  // the first minute
constexpr double kShownAge = 1.0;         // s: a line that stays is neither coming nor going
constexpr double kSaveAfter = 0.5;       // s without another change
constexpr std::chrono::milliseconds kBetweenBars{100};

/// Some drivers take a minute for the shaders when they see them for the first time: a bar tells how far they are.
void showProgress(platform::Surface& surface, std::size_t ready, std::size_t all) {
    constexpr glm::vec3 kBack{0.10f, 0.16f, 0.24f}, kRail{0.18f, 0.26f, 0.36f}, kBar{0.86f, 0.90f, 0.94f};
    glm::ivec2 const size = surface.size();
    glm::ivec4 const rail{size.x / 4, size.y / 2, size.x / 2, std::max(size.y / 120, 2)};
    gl::clearWindow({0, 0, size}, kBack);
    gl::clearWindow(rail, kRail);
    gl::clearWindow({rail.x, rail.y, static_cast<int>(static_cast<std::size_t>(rail.z) * ready / all), rail.w}, kBar);
    surface.setTitle("Luftpost: preparing the shaders");
    surface.swap();
    surface.poll();
}

render::RendererOptions rendererOptions(RunOptions const& run, platform::Surface& surface) {
    render::RendererOptions options{.size = run.size, .workers = run.workers, .hotReload = !run.headless};
    if (!surface.hasWindow()) return options;
    showProgress(surface, 0, 1);
    using Clock = std::chrono::steady_clock;
    options.progress = [&surface, shown = Clock::now()](std::size_t ready, std::size_t all) mutable {
        if (Clock::now() - shown < kBetweenBars) return;  // a swap may wait for the screen
        showProgress(surface, ready, all);
        shown = Clock::now();
    };
    return options;
}

/// Where a parcel released now would land, with the wind that is here.
std::optional<glm::dvec3> predictedLanding(Simulation const& simulation) {
    if (!simulation.delivery().parcelAboard()) return std::nullopt;
    flight::AircraftState const& state = simulation.aircraft().state();
    core::AirSample air;
    air.windWorld = {state.readings.windWorld.x, 0.0, state.readings.windWorld.z};
    air.density = state.readings.density;
    return delivery::predictedLanding({state.positionWorld, state.velocityWorld, 0.0, 0.0},
                                      simulation.delivery().parcelData(), air,
                                      simulation.delivery().target().height)
        .positionWorld;
}
}  // namespace

Game::Game(PlayOptions options, platform::Surface& surface)
    : plan_{std::move(options.session)},
      run_{std::move(options.run)},
      surface_{surface},
      settings_{run_.settings},
      list_{settingList(settings_)},
      stored_{run_.settingsFile},
      session_{std::make_unique<Session>(plan_)},
      feed_{run_.feed},
      renderer_{rendererOptions(run_, surface_)},
      models_{renderer_},
      desk_{plan_.plan.weather.source} {
    if (!run_.photos.empty()) photo_.emplace(run_.photos);
    if (surface_.hasWindow()) {
        surface_.setTitle("Luftpost");
        sounds_.emplace();
    }
    if (run_.watch) replay_.emplace(plan_, *run_.ticks);
    if (!run_.save.empty()) career_ = loadCareer(run_.save);
    restart();
}

void Game::frame(FrameStep const& step) {
    readDevices(step);
    if (!studio_) takeWeather();
    advance(step);
    takeEvents();
    moveCamera(step);
    moveTrails(step);
    resolution_.note(step.wall, settings_.graphics.framesPerSecond);
    desk_.advance(step.wall, paused(), *session_);
    if (photo_) complain(photo_->follow(session_->simulation().utc()));
    ImDrawData const* const screen = drawScreen(step);
    if (studio_ && studio_->saving()) drawSaving(screen);
    else drawPicture(step, screen, false);
    if (sounds_) sounds_->play(session_->simulation(), pose(), inside(), paused(), settings_.audio, step.wall);
    if ((sinceChange_ += step.wall) > kSaveAfter) saveChanges();
}

void Game::readDevices(FrameStep const& step) {
    if (!surface_.hasWindow()) return;
    input_ = &surface_.poll();
    bool const listening = bindingsPage_.listening();
    for (ui::SettingChange const& wanted : bindingsPage_.listen(*input_, settings_.bindings, screen_.wantsPointer())) change(wanted);
    ui::Listeners const others{screen_.wantsText(), screen_.wantsPointer(), mouseHeld_};
    reading_ = devices_.read(listening ? platform::Input{} : *input_, settings_.bindings, settings_.mouse, others, step.wall,
                             static_cast<float>(surface_.size().y));
    if (!listening)
        for (std::string const& news : devices_.takeNews()) messages_.say(news, ui::MessageKind::info, session_->simulation().seconds());
    obey(reading_);
    holdMouse();
    if (surface_.closeRequested()) quit_ = true;
    if (studio_ || replay_ || !plan_.bot.empty() || reading_.flight == sample_) return;
    sample_ = reading_.flight;
    session_->input(sample_);
}

/// While the mouse is the stick it has no pointer, and menus give it back.
void Game::holdMouse() {
    bool const hold = settings_.mouse.flight && input_->focused && !paused() && !configOpen_ && !keysOpen_ && !studio_ && !replay_;
    if (hold == mouseHeld_) return;
    mouseHeld_ = hold;
    surface_.captureMouse(hold);
}

void Game::takeWeather() {
    if (feed_) complain(followFeed(*session_, *feed_));
    complain(session_->enterOffered());
}

void Game::advance(FrameStep const& step) {
    long long const last = run_.ticks.value_or(session_->simulation().tick() + step.ticks);
    for (long long i = 0; i < step.ticks && session_->simulation().tick() < last; ++i) session_->tick();
    if (replay_) replay_->follow(session_->simulation());
}

void Game::takeEvents() {
    double const now = session_->simulation().seconds();
    for (FlightEventAt const& event : session_->takeEvents()) {
        messages_.sayEvent(event, now);
        if (sounds_) sounds_->note(event);
        count(event);
        bool const parcelGone = event.event == FlightEvent::delivered || event.event == FlightEvent::lost;
        if (parcelGone && cameras_.mode() == ui::CameraMode::parcel &&
            settings_.view.camera != ui::CameraMode::parcel)
            cameras_.select(ui::CameraMode::chase);
        if (event.event == FlightEvent::respawned) trails_.clear();
        if (event.event == FlightEvent::respawned)
            cameras_.reset(cameraSubject(session_->simulation(), shownPose(session_->simulation(), 1.0)),
                           groundHeight());
    }
}

/// The career is written with every parcel: a killed game loses nothing.
void Game::count(FlightEventAt const& event) {
    if (!countParcel(career_, session_->simulation(), event) || run_.save.empty()) return;
    try {
        saveCareer(run_.save, career_);
    } catch (core::Error const& error) {
        if (!surface_.hasWindow()) throw;
        messages_.say(error.what(), ui::MessageKind::bad, session_->simulation().seconds());
    }
}

ui::GroundHeight Game::groundHeight() const {
    return [this](double east, double north) { return session_->world().ground()(east, north).height; };
}

/// Beside the middle of the runway.
glm::dvec3 Game::towerEye() const {
    constexpr double kBeside = 90.0, kHigh = 14.0;  // m
    terrain::Runway const& runway = session_->world().land().runway();
    glm::dvec2 const right{runway.directionEastNorth.y, -runway.directionEastNorth.x};
    glm::dvec2 const at = right * kBeside;
    return core::worldFromEastNorth(at.x, at.y, session_->world().ground()(at.x, at.y).height + kHigh);
}

void Game::moveCamera(FrameStep const& step) {
    Simulation const& simulation = session_->simulation();
    if (studio_) return studio_->move(reading_, cameraSubject(simulation, shownPose(simulation, step.share)), groundHeight(), step.wall);
    auto const parcel = shownParcel(simulation, step.share);
    cameras_.watchParcel(parcel ? parcel->positionWorld : simulation.aircraft().state().positionWorld);
    cameras_.setTower(towerEye());
    cameras_.setFieldOfView(core::radians(settings_.graphics.fieldOfView_deg));
    cameras_.advance(cameraSubject(simulation, shownPose(simulation, step.share)), reading_.camera,
                     groundHeight(), paused() ? 0.0 : step.seconds, step.wall);
}

void Game::moveTrails(FrameStep const& step) {
    Simulation const& simulation = session_->simulation();
    flight::AircraftState const& aircraft = simulation.aircraft().state();
    glm::dvec3 const& at = aircraft.positionWorld;
    core::AirSample const air = simulation.airNow().at(at);
    weather::Weather const weather = session_->world().field().at(at.x, -at.z, simulation.utc());
    // In cloud the air is saturated; below, the spread closes with height from the ground's to none where lifted air condenses.
    double const ground = session_->world().ground()(at.x, -at.z).height;
    double const risen = std::clamp((at.y - ground) / std::max(weather.condensationLevel - ground, 1.0), 0.0, 1.0);
    double const spread = air.visibility < 1000.0 ? 0.0 : (weather.temperature - weather.dewPoint) * (1.0 - risen);
    trails_.advance({simulation.aircraft().airframe(), aircraft, shownPose(simulation, step.share), air, session_->world().ground(), spread},
                    paused() ? 0.0 : step.seconds);
}

ImDrawData const* Game::drawScreen(FrameStep const& step) {
    screen_.begin(renderer_.size(), settings_.hud.scale, step.wall, input_);
    if (studio_) {
        drawStudio();
        return screen_.end();
    }
    if (replay_) drawReplay();  // before what shows where it is
    if (photo_) ui::drawPhoto(photo_->state());
    if (settings_.hud.air) drawAir();
    ui::drawHud(hudState());
    drawPages();
    return screen_.end();
}

render::Snapshot Game::pictureOf(FrameStep const& step, ImDrawData const* screen, bool still) const {
    Simulation const& simulation = session_->simulation();
    FrameView const view{pose(), inside(), step.share, paused() ? 0.0 : step.seconds, paused() ? step.wall : step.seconds, studio_ ? studio_->utc() : simulation.utc()};
    render::Snapshot snapshot = snapshotOf(simulation, models_, settings_, view);
    if (studio_) studio_->expose(snapshot);
    trails_.addTo(snapshot.puffs);
    snapshot.still = still;
    if (!still) snapshot.graphics.resolution = resolution_.scale(snapshot.graphics.resolution, settings_.graphics.framesPerSecond);
    snapshot.debug = debug_;
    snapshot.ui = screen;
    snapshot.fontVersion = screen_.fontVersion();
    if (photo_) snapshot.photo = photo_->image(), snapshot.photoVersion = photo_->version();
    return snapshot;
}

void Game::drawPicture(FrameStep const& step, ImDrawData const* screen, bool still) {
    if (surface_.hasWindow()) renderer_.resize(surface_.size());
    renderer_.draw(pictureOf(step, screen, still));
    show();
}

/// The next tile of the studio's picture, and the page over the picture as it was drawn whole.
void Game::drawSaving(ImDrawData const* screen) {
    studio_->saveNext();
    render::Snapshot menus;
    menus.ui = screen;
    menus.fontVersion = screen_.fontVersion();
    menus.graphics = settings_.graphics;
    renderer_.drawMenus(menus);
    show();
}

void Game::show() {
    if (!surface_.hasWindow()) return gl::finish();
    renderer_.present(surface_.size());
    surface_.swap();
}

void Game::writePicture(std::filesystem::path const& file) {
    FrameStep const now{0, 1.0, 0.0, 0.0};
    if (photo_) photo_->finish();
    drawPicture(now, drawScreen(now), true);
    assets::writePng(file, renderer_.readPixels());
}

void Game::restart() {
    if (session_->simulation().tick() > 0) {
        plan_.plan.simulation.settings = settings_.flight;
        if (feed_) planAgain(plan_.plan, *feed_, session_->simulation());
        session_ = std::make_unique<Session>(plan_);
    }
    beginFlight();
}

void Game::beginFlight() {
    sample_ = {};
    trails_.clear();
    cameras_.reset(cameraSubject(session_->simulation(), shownPose(session_->simulation(), 1.0)),
                   groundHeight());
    cameras_.select(settings_.view.camera);
}

void Game::saveChanges() {
    try {
        stored_.write();
    } catch (core::Error const& error) {
        messages_.say(error.what(), ui::MessageKind::bad, session_->simulation().seconds());
    }
}

ui::HudWeather Game::hudWeather() const {
    Simulation const& simulation = session_->simulation();
    weather::Origin const& origin = session_->world().field().origin();
    ui::HudWeather shown{origin.name, std::string{weather::modeWord(origin.mode)}, session_->world().field().age(simulation.utc()), {}};
    if (isLive(origin.mode)) shown.age = std::max(simulation.utc() - origin.fetched, 0.0);
    if (!feed_) return shown;
    core::UtcSeconds const now = feedTime(*feed_, simulation);
    FeedStatus const status = feed_->status(now);
    shown.note = status.line;
    if (!status.given || !isLive(origin.mode)) return shown;  // another weather until there is live one
    shown.mode = status.stale ? "stale" : "live";
    shown.age = std::max(now - *status.given, 0.0);
    return shown;
}

ui::HudState Game::hudState() {
    Simulation const& simulation = session_->simulation();
    ui::HudState hud = instruments(simulation);
    hud.visible = settings_.hud.visible;
    hud.density = settings_.hud.density;
    if (auto const& stick = devices_.mouseStick()) hud.mouseStick = glm::vec2{stick->roll, stick->pitch};
    hud.respawnCap = devices_.capOf(ui::FlightKey::respawn, settings_.bindings);
    hud.paused = paused_ && !pauseOpen_ && !keysOpen_;
    hud.score =
        static_cast<int>(std::lround(run_.save.empty() ? simulation.delivery().score() : career_.score));
    hud.deliveries = run_.save.empty() ? simulation.delivery().deliveries() : career_.deliveries;
    hud.fuelCapacity_kg = simulation.aircraft().airframe().fuelMax;
    hud.predictedLandingWorld = predictedLanding(simulation);
    hud.clockRate = simulation.clockRate();
    hud.weather = hudWeather();
    hud.messages = messages_.at(simulation.seconds());
    if (std::string text = simulation.autopilotText(); !text.empty()) hud.messages.push_back({std::move(text), ui::MessageKind::info, kShownAge});
    if (replay_) hud.prompts = replay_->playing() ? std::vector<ui::HudPrompt>{} : devices_.replayPrompts(settings_.bindings);
    else if (simulation.seconds() < kPromptSeconds) hud.prompts = devices_.firstPrompts(settings_.bindings);
    hud.camera = cameras_.pose();
    hud.inside = cameras_.inside();
    return hud;
}
}  // namespace luftpost::app
