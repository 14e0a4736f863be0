#include "game/app/play.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/gl/context.h"
#include "engine/platform/surface.h"
#include "engine/terrain/streamer.h"
#include "engine/weather/recording.h"
#include "game/app/frame_clock.h"
#include "game/app/game.h"
#include "game/app/live_weather.h"
#include "game/app/player_files.h"
#include "game/app/report.h"
#include "game/app/session.h"

namespace luftpost::app {
namespace {
using WallClock = std::chrono::steady_clock;
constexpr std::size_t kChunkBytes = 160'000'000;
constexpr double kBytesPerMegabyte = 1.0e6;

double secondsSince(WallClock::time_point start) {
    return std::chrono::duration<double>(WallClock::now() - start).count();
}

ChunkFigures chunkFigures(terrain::StreamerStats const& stats) {
    return {stats.made, stats.cached, stats.evicted, stats.peakBytes};
}

/// What the pilot sees ahead.
terrain::CameraView viewOf(flight::AircraftState const& state) {
    return {.positionWorld = state.positionWorld,
            .forward = state.worldFromBody * glm::dvec3{1.0, 0.0, 0.0},
            .up = state.worldFromBody * glm::dvec3{0.0, 1.0, 0.0}};
}

std::string exportText(Session const& session, std::filesystem::path const& file) {
    ExportKind const kind = exportKind("--export", file.string());
    if (kind == ExportKind::csv) return session.logText();
    return kind == ExportKind::kml ? session.track().kml() : session.track().gpx();
}

/// What was asked for, written when the flight is over.
void writeFiles(Session& session, RunOptions const& run, FlightReport const& report) {
    if (!run.log.empty()) core::writeFileAtomically(run.log, session.logText());
    if (!run.exported.empty()) core::writeFileAtomically(run.exported, exportText(session, run.exported));
    if (!run.saveReplay.empty()) core::writeFileAtomically(run.saveReplay, replayText(session.replay()));
    if (!run.saveWeather.empty())
        core::writeFileAtomically(run.saveWeather, session.weatherText());
    if (!run.report.empty()) core::writeFileAtomically(run.report, reportText(report));
    if (report.card) fmt::print("{}", cardText(*report.card));
}

/// The flight's own figures beside what the run cost.
FlightReport wholeReport(Session const& session, Settings settings, FlightReport const& cost) {
    FlightReport report = session.report();
    report.chunks = cost.chunks;
    report.frame_ms = cost.frame_ms;
    report.glErrors = cost.glErrors;
    report.gpu_mb = cost.gpu_mb;
    report.rss_mb = residentMemory_mb();
    settings.flight = session.simulation().settings();  // a replay's inputs change them, too
    report.changed = core::changedSettings(settingList(settings));
    std::erase_if(report.changed, [](auto const& entry) { return isSecret(entry.first); });
    return report;
}

/// Flies all ticks without any picture; the land is still built around the aircraft, frame by frame.
void flyBlind(PlayOptions options) {
    RunOptions const& run = options.run;
    Session session{std::move(options.session)};
    terrain::Streamer streamer{session.world().land(), run.workers, kChunkBytes};
    delivery::Career career = run.save.empty() ? delivery::Career{} : namedCareer(run.save);
    for (long long frame = 1; session.simulation().tick() < *run.ticks; ++frame) {
        FrameStep const step = simulatedStep(frame, run.frameRate);
        if (run.feed)
            if (auto const refused = followFeed(session, *run.feed)) spdlog::warn("{}", *refused);
        for (long long i = 0; i < step.ticks && session.simulation().tick() < *run.ticks; ++i) session.tick();
        streamer.update(viewOf(session.simulation().aircraft().state()));
        for (FlightEventAt const& event : session.takeEvents())
            if (countParcel(career, session.simulation(), event) && !run.save.empty())
                saveCareer(run.save, career);
    }
    FlightReport cost;
    cost.chunks = chunkFigures(streamer.stats());
    writeFiles(session, run, wholeReport(session, run.settings, cost));
}

/// Draws frame after frame of the simulated clock (headless) or of the player's until the flight is over.
void flyFrames(Game& game, RunOptions const& run, std::vector<double>& frame_ms) {
    FrameClock clock;
    WallClock::time_point before = WallClock::now();
    for (long long number = 1; !game.over(); ++number) {
        if (run.ticks && !run.watch && game.session().simulation().tick() >= *run.ticks) return;
        double const wall = secondsSince(before);
        before = WallClock::now();
        game.frame(run.headless ? simulatedStep(number, run.frameRate) : clock.step(wall, game.paused(), game.pace()));
        frame_ms.push_back(secondsSince(before) * 1000.0);
    }
}

void flyWithPicture(PlayOptions options) {
    RunOptions const run = options.run;
    std::unique_ptr<platform::Surface> const surface =
        run.headless ? platform::openHeadless(run.size)
                     : platform::openWindow({.size = run.size,
                                             .title = run.watch ? "Luftpost: replay" : "Luftpost",
                                             .fullScreen = run.settings.graphics.fullScreen,
                                             .verticalSync = run.settings.graphics.verticalSync});
    gl::prepareContext();
    Game game{std::move(options), *surface};
    FlightReport cost;
    flyFrames(game, run, cost.frame_ms);
    game.saveChanges();
    if (!run.screenshot.empty()) game.writePicture(run.screenshot);
    cost.chunks = chunkFigures(game.renderer().chunkStats());
    cost.glErrors = static_cast<std::size_t>(gl::errorCount());
    cost.gpu_mb = static_cast<double>(gl::allocatedBytes()) / kBytesPerMegabyte;
    writeFiles(game.session(), run, wholeReport(game.session(), game.settings(), cost));
}
}  // namespace

int playFlight(PlayOptions options) {
    if (options.run.noRender)
        flyBlind(std::move(options));
    else
        flyWithPicture(std::move(options));
    return 0;
}
}  // namespace luftpost::app
