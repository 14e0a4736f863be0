#include <CLI/CLI.hpp>
#include <memory>

#include "game/app/commands.h"
#include "game/app/play.h"

namespace luftpost::app {
namespace {
/// What play and replay have in common.
void addRunOptions(CLI::App& command, PlayTexts& texts) {
    command.add_option("--log", texts.log, "FILE.csv: a row every 0.1 s");
    command.add_option("--export", texts.exported, "FILE.csv (as --log), FILE.kml or FILE.gpx: the way for maps");
    command.add_option("--report", texts.report, "FILE.json: what happened and what it cost");
    command.add_option("--screenshot", texts.screenshot, "FILE.png: the last frame, with every ray");
    command.add_option("--frame-rate", texts.frameRate, "frames of simulated time a second (default 60)");
    command.add_option("--workers", texts.workers, "threads that build land and clouds");
}
}  // namespace

void addPlayCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    auto const texts = std::make_shared<PlayTexts>();
    CLI::App* const play = app.add_subcommand("play", "the game (the default)");
    play->add_flag("--headless", texts->headless, "no window, a simulated clock, as fast as it can");
    play->add_flag("--no-render", texts->noRender, "no GL context at all");
    play->add_option("--bot", texts->bot, "courier, circuit, or card:NAME of a test card: the bot flies");
    play->add_option("--input", texts->input,
                     "FILE.csv: t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop");
    play->add_option("--save-replay", texts->saveReplay, "FILE: the flight, to be flown again by `replay`");
    play->add_option("--save-weather", texts->saveWeather, "FILE: the weather of this flight as a recording");
    play->add_option("--save", texts->save, "FILE: score and deliveries so far");
    play->add_option("--photo", texts->photo, "FILE or folder: a photograph laid over the picture (F5), the one nearest in time");
    play->add_option("--start", texts->start, "air:ALT_M,TAS_MPS,HEADING_DEG or runway");
    play->add_option("--assist", texts->assist, "sim, light, normal or easy (default normal)");
    play->add_option("--payload", texts->payload, "kg (default 240)");
    play->add_option("--fuel", texts->fuel, "kg (default 100)");
    play->add_option("--seconds", texts->seconds, "of flight; compulsory with --headless");
    addRunOptions(*play, *texts);
    play->callback([texts, &common, &chosen] {
        chosen = [texts, &common] { return playFlight(playOptions(*texts, common)); };
    });
}

void addReplayCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    auto const texts = std::make_shared<PlayTexts>();
    auto const file = std::make_shared<std::filesystem::path>();
    CLI::App* const replay = app.add_subcommand("replay", "a flight again, bit for bit: in a window, to be watched, unless a file is asked for");
    replay->add_option("file", *file, "what --save-replay wrote")->required();
    replay->add_flag("--headless", texts->headless, "no window: whether the file can be flown");
    addRunOptions(*replay, *texts);
    replay->callback([texts, file, &common, &chosen] {
        chosen = [texts, file, &common] { return playFlight(replayOptions(*file, *texts, common)); };
    });
}
}  // namespace luftpost::app
