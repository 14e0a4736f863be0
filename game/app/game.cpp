#include "game/app/game.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/assets/image.h"
#include "engine/core/error.h"
#include "engine/gl/context.h"
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

render::RendererOptions rendererOptions(RunOptions const& run) {
    return {.size = run.size, .workers = run.workers, .hotReload = !run.headless};
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
      renderer_{rendererOptions(run_)},
      models_{renderer_},
      desk_{plan_.plan.weather.source} {
    if (!run_.photos.empty()) photo_.emplace(run_.photos);
    if (surface_.hasWindow()) sounds_.emplace();
    if (!run_.save.empty()) career_ = loadCareer(run_.save);
    restart();
}

void Game::frame(FrameStep const& step) {
    readDevices(step);
    takeWeather();
    advance(step);
    takeEvents();
    moveCamera(step);
    resolution_.note(step.wall, settings_.graphics.framesPerSecond);
    desk_.advance(step.wall, paused(), *session_);
    if (photo_) complain(photo_->follow(session_->simulation().utc()));
    drawPicture(step, drawScreen(step), false);
    if (sounds_)
        sounds_->play(session_->simulation(), cameras_.pose(), cameras_.inside(), paused(), settings_.audio,
                      step.wall);
    if ((sinceChange_ += step.wall) > kSaveAfter) saveChanges();
}

void Game::readDevices(FrameStep const& step) {
    if (!surface_.hasWindow()) return;
    input_ = &surface_.poll();
    reading_ = devices_.read(*input_, screen_.wantsText(), screen_.wantsPointer(), step.wall);
    obey(reading_);
    if (surface_.closeRequested()) quit_ = true;
    if (!plan_.bot.empty() || reading_.flight == sample_) return;
    sample_ = reading_.flight;
    session_->input(sample_);
}

void Game::takeWeather() {
    if (feed_) complain(followFeed(*session_, *feed_));
    complain(session_->enterOffered());
}

void Game::advance(FrameStep const& step) {
    long long const last = run_.ticks.value_or(session_->simulation().tick() + step.ticks);
    for (long long i = 0; i < step.ticks && session_->simulation().tick() < last; ++i) session_->tick();
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

void Game::moveCamera(FrameStep const& step) {
    Simulation const& simulation = session_->simulation();
    auto const parcel = shownParcel(simulation, step.share);
    cameras_.watchParcel(parcel ? parcel->positionWorld : simulation.aircraft().state().positionWorld);
    cameras_.setFieldOfView(core::radians(settings_.graphics.fieldOfView_deg));
    cameras_.advance(cameraSubject(simulation, shownPose(simulation, step.share)), reading_.camera,
                     groundHeight(), paused() ? 0.0 : step.seconds, step.wall);
}

ImDrawData const* Game::drawScreen(FrameStep const& step) {
    screen_.begin(renderer_.size(), settings_.hud.scale, step.wall, input_);
    if (photo_) ui::drawPhoto(photo_->state());
    if (settings_.hud.air) drawAir();
    ui::drawHud(hudState());
    drawPages();
    return screen_.end();
}

render::Snapshot Game::pictureOf(FrameStep const& step, ImDrawData const* screen, bool still) const {
    FrameView const view{cameras_.pose(), cameras_.inside(), step.share, paused() ? 0.0 : step.seconds};
    render::Snapshot snapshot = snapshotOf(session_->simulation(), models_, settings_, view);
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
    if (simulation.seconds() < kPromptSeconds) hud.prompts = devices_.firstPrompts();
    hud.camera = cameras_.pose();
    return hud;
}
}  // namespace luftpost::app
