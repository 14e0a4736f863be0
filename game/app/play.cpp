#include "game/app/play.h"

#include <cmath>

#include "engine/core/file.h"
#include "engine/terrain/streamer.h"
#include "game/app/report.h"
#include "game/app/session.h"
#include "game/ui/camera.h"

namespace luftpost::app {
namespace {
constexpr std::size_t kChunkBytes = 160'000'000;

/// The last tick that frame `number` (from 1) has seen.
long long tickOfFrame(long long number, double frameRate) {
    return static_cast<long long>(
        std::floor(static_cast<double>(number) * core::kTicksPerSecond / frameRate));
}

/// What the chase camera of a drawn flight would see.
terrain::CameraView viewOf(flight::AircraftState const& state) {
    return {.positionWorld = state.positionWorld,
            .forward = state.worldFromBody * glm::dvec3{1.0, 0.0, 0.0},
            .up = state.worldFromBody * glm::dvec3{0.0, 1.0, 0.0}};
}

/// Flies all ticks without any picture; the land is still built around the aircraft, frame by frame.
void flyBlind(Session& session, RunOptions const& run, FlightReport& report) {
    terrain::Streamer streamer{session.world().land(), run.workers, kChunkBytes};
    long long const last = *run.ticks;
    for (long long frame = 1; session.simulation().tick() < last; ++frame) {
        long long const until = std::min(tickOfFrame(frame, run.frameRate), last);
        while (session.simulation().tick() < until) session.tick();
        streamer.update(viewOf(session.simulation().aircraft().state()));
        session.takeEvents();
    }
    terrain::StreamerStats const stats = streamer.stats();
    report.chunks = {stats.made, stats.cached, stats.evicted, stats.peakBytes};
}
}  // namespace

int playFlight(PlayOptions options) {
    RunOptions const& run = options.run;
    Session session{std::move(options.session)};
    FlightReport cost;
    flyBlind(session, run, cost);
    FlightReport report = session.report();
    report.chunks = cost.chunks;
    Settings settings = run.settings;
    report.changed = core::changedSettings(settingList(settings));
    if (!run.log.empty()) core::writeFileAtomically(run.log, session.logText());
    if (!run.report.empty()) core::writeFileAtomically(run.report, reportText(report));
    if (!run.saveReplay.empty()) core::writeFileAtomically(run.saveReplay, replayText(session.replay()));
    return 0;
}
}  // namespace luftpost::app
