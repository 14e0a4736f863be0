#include "game/app/session.h"

#include <algorithm>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/platform/paths.h"
#include "game/app/bots.h"
#include "game/app/instruments.h"

namespace luftpost::app {
namespace {
/// Every weather that the script will use, loaded before the first tick.
void loadScriptedWeather(World& world, std::vector<StampedInput> const& script) {
    for (StampedInput const& input : script)
        if (auto const* change = std::get_if<WeatherInput>(&input.what); change && change->recording.empty())
            world.loadWeather(change->source);
}
}  // namespace

Session::Session(SessionOptions options)
    : options_{std::move(options)},
      world_{options_.plan.weather, options_.plan.place, options_.plan.simulation.seed, options_.plan.weatherLatest},
      simulation_{world_, loadHangar(), options_.plan.simulation},
      log_{world_.place()},
      track_{world_.place(), simulation_.utc()} {
    std::string const& found = world_.field().origin().sha256;
    if (found != options_.plan.weatherSha256)
        throw core::Error{options_.plan.weather.source, "",
                          "expected the recording of the replay, sha256 " + options_.plan.weatherSha256 +
                              ", found " + found};
    loadScriptedWeather(world_, options_.script);
    if (!options_.bot.empty())
        pilot_ = makePilot(options_.bot, world_, simulation_.aircraft().airframe(),
                           options_.plan.simulation.settings.pilot.assist, options_.plan.simulation.time);
    keepRow();
    keepWay();
    if (options_.weather) flown_.begin(world_.field(), simulation_.utc());
}

std::string Session::weatherText() {
    bool const changed = std::any_of(inputs_.begin(), inputs_.end(), [](StampedInput const& input) { return std::holds_alternative<WeatherInput>(input.what); });
    if (changed) {
        CHECK(options_.weather, "the weather was not kept");
        flown_.end(world_.field(), simulation_.utc());
        return weather::recordingText(flown_.recording());
    }
    if (!options_.plan.weather.recording.empty()) return options_.plan.weather.recording;
    bool const preset = world_.field().origin().mode == weather::SourceMode::Preset;
    return preset ? weather::recordingText(world_.field().recording()) : core::readFile(world_.field().recording().file);
}

void Session::input(FlightInput const& what) {
    bool const cut = options_.weather && (std::holds_alternative<WeatherInput>(what) || std::holds_alternative<ClockInput>(what));
    if (cut) flown_.end(world_.field(), simulation_.utc());
    simulation_.apply(what);
    if (cut) flown_.begin(world_.field(), simulation_.utc());
    inputs_.push_back({simulation_.tick(), what});
}

std::optional<std::string> Session::enterOffered() {
    auto const offered = world_.takeOffered(simulation_.utc());
    if (!offered) return std::nullopt;
    if (!offered->error.empty()) return offered->error;
    input(offered->input);
    return std::nullopt;
}

void Session::tick() {
    while (scriptDone_ < options_.script.size() && options_.script[scriptDone_].tick <= simulation_.tick())
        input(options_.script[scriptDone_++].what);
    if (pilot_) pilot_->look(simulation_.aircraft().state());
    if (pilot_ && simulation_.tick() % bot::kTicksPerDecision == 0) askPilot();
    simulation_.step();
    keepRow();
    keepWay();
    if (simulation_.tick() % core::kTicksPerSecond == 0) hashes_.push_back(simulation_.stateHash());
}

void Session::goTo(Moment const& moment) {
    CHECK(!pilot_ && !options_.log && !options_.track && !options_.weather, "only a script can be gone through both ways");
    simulation_.goTo(moment.simulation);
    scriptDone_ = moment.scriptDone;
    inputs_.assign(options_.script.begin(), options_.script.begin() + static_cast<std::ptrdiff_t>(scriptDone_));
}

void Session::askPilot() {
    ui::InputSample const sample = pilot_->decide(instruments(simulation_));
    if (sample == sample_) return;
    sample_ = sample;
    input(sample);
}

void Session::keepRow() {
    if (options_.log && simulation_.tick() % FlightLog::kTicksPerRow == 0)
        log_.add(simulation_.seconds(), simulation_.aircraft().state());
}

void Session::keepWay() {
    if (options_.track) track_.add(simulation_.tick(), simulation_.aircraft().state());
}

FlightTrack Session::track() const {
    CHECK(options_.track, "the way was not kept");
    FlightTrack track = track_;
    track.markDrops(simulation_.delivery().drops());
    for (Simulation::Crash const& crash : simulation_.crashed()) track.mark("Crash", crash.seconds, crash.positionWorld);
    return track;
}

FlightReport Session::report() const {
    delivery::Delivery const& delivery = simulation_.delivery();
    FlightReport report;
    report.seconds = simulation_.seconds();
    report.deliveries = delivery.deliveries();
    report.score = delivery.score();
    report.crashes = simulation_.crashes();
    report.drops = delivery.drops();
    report.landings = simulation_.landings();
    report.stateHashes = hashes_;
    if (pilot_ && pilot_->figures()) report.card = CardReport{options_.bot, pilot_->finished(), *pilot_->figures()};
    return report;
}
}  // namespace luftpost::app
