#include "game/app/play_options.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/platform/paths.h"
#include "engine/platform/surface.h"
#include "engine/weather/source.h"
#include "game/app/bots.h"
#include "game/app/instruments.h"
#include "game/app/live_weather.h"
#include "game/app/photo_box.h"
#include "game/app/player_files.h"
#include "game/app/weather_source.h"
#include "game/ui/input_csv.h"

namespace luftpost::app {
namespace {
constexpr double kLongestFlight = 1.0e6;       // s
constexpr double kDefaultHeight = 350.0;       // m above the airfield
constexpr double kDefaultTas = 50.0;           // m/s
constexpr double kDefaultHeading_deg = 250.0;  // along the low sun's light, the glow to the right
constexpr int kMostWorkers = 256;

void checkOutputs(PlayTexts const& texts) {
    std::map<std::filesystem::path, char const*> taken;
    auto const check = [&](char const* option, std::filesystem::path const& file) {
        if (file.empty()) return;
        core::checkOutputFolder(option, file);
        std::error_code ignored;
        auto const whole = std::filesystem::weakly_canonical(std::filesystem::absolute(file), ignored);
        auto const [other, fresh] = taken.emplace(whole, option);
        if (!fresh && !std::filesystem::is_other(file, ignored))
            throw core::Error{file.string(), option,
                              fmt::format("expected another file than that of {}", other->second)};
    };
    check("--log", texts.log);
    check("--export", texts.exported);
    check("--report", texts.report);
    check("--screenshot", texts.screenshot);
    check("--save-replay", texts.saveReplay);
    check("--save-weather", texts.saveWeather);
    check("--save", texts.save);
    if (!texts.screenshot.empty() && texts.screenshot.extension() != ".png")
        throw core::Error{"--screenshot", "",
                          fmt::format("expected FILE.png, found {}", texts.screenshot.string())};
    if (!texts.exported.empty()) exportKind("--export", texts.exported.string());
    if (!texts.save.empty()) namedCareer(texts.save);
}

RunOptions runOptions(PlayTexts const& texts, CommonOptions const& common) {
    checkOutputs(texts);
    RunOptions run;
    run.headless = texts.headless || texts.noRender;
    run.noRender = texts.noRender;
    run.size = common.size;
    run.log = texts.log;
    run.exported = texts.exported;
    run.report = texts.report;
    run.screenshot = texts.screenshot;
    run.saveReplay = texts.saveReplay;
    run.saveWeather = texts.saveWeather;
    run.save = texts.save;
    for (auto const& [option, file] : {std::pair{"--screenshot", &texts.screenshot}, std::pair{"--photo", &texts.photo}})
        if (run.noRender && !file->empty())
            throw core::Error{option, "", "expected not with --no-render, which draws nothing"};
    if (!texts.seconds.empty()) {
        double const seconds = numberOption("--seconds", texts.seconds, 0.0, kLongestFlight);
        run.ticks = ui::tickAtOrAfter(seconds);
    }
    if (!texts.frameRate.empty()) run.frameRate = numberOption("--frame-rate", texts.frameRate, 0.01, 1000.0);
    unsigned const cores = std::max(std::thread::hardware_concurrency(), 1u);
    run.workers = static_cast<int>(std::clamp(cores - 1, 1u, 8u));
    if (!texts.workers.empty())
        run.workers = static_cast<int>(wholeOption("--workers", texts.workers, 1, kMostWorkers));
    return run;
}

FlightStart startOption(std::string const& text, double airfieldAltitude) {
    FlightStart start{false, airfieldAltitude + kDefaultHeight, kDefaultTas,
                      core::radians(kDefaultHeading_deg)};
    if (text.empty()) return start;
    if (text == "runway") return {.runway = true};
    constexpr char const* kForm = "air:ALT_M,TAS_MPS,HEADING_DEG or runway";
    if (!text.starts_with("air:"))
        throw core::Error{"--start", "", fmt::format("expected {}, found {}", kForm, text)};
    auto const numbers = numbersOption("--start", std::string_view{text}.substr(4), 3, 3, kForm);
    if (numbers[0] > 12000.0 || numbers[1] < 10.0 || numbers[1] > 150.0 || std::abs(numbers[2]) > 720.0)
        throw core::Error{
            "--start", "",
            fmt::format("expected ALT_M up to 12000, TAS_MPS 10..150, HEADING_DEG -720..720, found {}",
                        text)};
    return {false, numbers[0], numbers[1], core::radians(numbers[2])};
}

/// What the feed has at once, without a window after a request: the weather that the flight begins in.
std::optional<WeatherInput> firstNews(WeatherFeed& feed, CommonOptions const& common) {
    core::UtcSeconds const now = feedTime(common);
    auto const news = feed.poll(now, feedPlace(common));
    if (!news) return std::nullopt;
    FeedStatus const status = feed.status(now);
    return liveInput(*news, status.given.value_or(now), status.stale);
}

/// Live weather is waited for in the bundled one, at the hour of now.
weather::Field waitingField(CommonOptions& common) {
    common.time = feedTime(common);
    common.weather = bundledSource();
    return loadField(bundledSource(), placeWish(common), common);
}

/// The field that the flight begins in; with live weather also the feed. It is made here to complain early.
weather::Field firstField(FlightPlan& plan, CommonOptions& common, RunOptions& run) {
    if (!plan.weather.recording.empty()) return fieldOf(plan.weather, placeWish(common));  // a bot's own
    if (!wantsLive(common)) return weatherField(common);
    run.feed = std::make_shared<WeatherFeed>(common.settings.weather, run.headless ? FeedPace::inLine : FeedPace::beside,
                                             feedCacheFolder(common.settings.weather, !run.headless));
    auto const news = firstNews(*run.feed, common);
    if (!news) return waitingField(common);
    try {
        weather::Field field = fieldOf(*news, placeWish(common));
        plan.weather = *news;
        return field;
    } catch (core::Error const& error) {
        fmt::print("{}\n", error.what());
        return waitingField(common);
    }
}

/// The weather's source, place and hour; gives the field that the flight begins in.
weather::Field planWeather(FlightPlan& plan, CommonOptions common, RunOptions& run) {
    plan.weatherLatest = feedTime(common);
    weather::Field field = firstField(plan, common, run);
    bool const preset = field.origin().mode == weather::SourceMode::Preset;
    if (plan.weather.recording.empty())  // so that the replay finds it from any folder
        plan.weather.source =
            preset ? weatherSource(common) : "recorded:" + std::filesystem::absolute(field.recording().file).string();
    plan.weatherSha256 = field.origin().sha256;
    plan.place = field.place();
    plan.simulation.time = startTime(common, field);
    return field;
}

FlightPlan flightPlan(PlayTexts const& texts, CommonOptions const& common, WeatherInput first, RunOptions& run) {
    FlightPlan plan;
    plan.weather = std::move(first);
    weather::Field const field = planWeather(plan, common, run);
    SimulationOptions& simulation = plan.simulation;
    simulation.seed = common.seed.value_or(1);
    simulation.start = startOption(texts.start, plan.place.altitude_m);
    simulation.settings = common.settings.flight;
    Hangar const hangar = loadHangar();
    flight::Airframe const& airframe = chosen(hangar, simulation.settings.pilot.airframe);
    if (!texts.payload.empty())
        simulation.payload = numberOption("--payload", texts.payload, 0.0, airframe.payloadMax);
    if (!texts.fuel.empty()) simulation.fuel = numberOption("--fuel", texts.fuel, 0.0, airframe.fuelMax);
    planStartForBot(texts.bot, field, airframe, plan);
    return plan;
}

void refuseTogether(bool both, char const* option, char const* other) {
    if (both) throw core::Error{option, "", fmt::format("expected not together with {}", other)};
}

std::vector<StampedInput> scriptFrom(std::filesystem::path const& file) {
    std::vector<StampedInput> script;
    for (ui::StampedSample const& stamped : ui::readInputCsv(file))
        script.push_back({stamped.tick, stamped.sample});
    return script;
}

/// The session keeps what is written at its end.
void keepWritten(SessionOptions& session, PlayTexts const& texts) {
    bool const exports = !texts.exported.empty();
    bool const rows = exports && exportKind("--export", texts.exported.string()) == ExportKind::csv;
    session.log = !texts.log.empty() || rows;
    session.track = exports && !rows;
    session.weather = !texts.saveWeather.empty();
}

void checkModes(PlayTexts const& texts, RunOptions const& run) {
    if (run.headless && !run.ticks)
        throw core::Error{"--seconds", "", "expected with --headless: the seconds of flight"};
    refuseTogether(!texts.bot.empty() && !texts.input.empty(), "--input", "--bot");
}
}  // namespace

PlayOptions playOptions(PlayTexts const& texts, CommonOptions const& given) {
    CommonOptions common = given;
    PlayOptions options;
    options.run = runOptions(texts, common);
    checkModes(texts, options.run);
    checkBot(texts, given);
    if (!options.run.headless) usePlayerFiles(common, options.run);
    if (!texts.assist.empty()) {
        core::SettingList list = settingList(common.settings);
        core::assignSetting(*core::findSetting(list, "aircraft.assist"), "--assist", texts.assist);
    }
    WeatherInput botWeather = prepareForBot(texts, common);
    common.settings.weather.live = wantsLive(common);
    options.run.settings = common.settings;
    options.session.plan = flightPlan(texts, common, std::move(botWeather), options.run);
    options.session.bot = texts.bot;
    keepWritten(options.session, texts);
    if (!texts.input.empty()) options.session.script = scriptFrom(texts.input);
    if (!texts.photo.empty()) options.run.photos = photosOption(texts.photo, options.session.plan.simulation.time);
    return options;
}

namespace {
/// The file holds the flight: what would make it another one is refused.
void refuseAnotherFlight(CommonOptions const& common) {
    auto const refuse = [](bool given, char const* option, std::string const& key = "") {
        if (given)
            throw core::Error{option, key, "expected not with replay, whose file holds the whole flight"};
    };
    refuse(!common.weather.empty(), "--weather");
    refuse(common.place.has_value(), "--place");
    refuse(common.time.has_value(), "--time");
    refuse(common.seed.has_value(), "--seed");
    FlightSettings flight;
    core::SettingList list;
    appendFlightSettings(list, flight);
    for (std::string const& assignment : common.assignments) {
        std::string const key = assignment.substr(0, assignment.find('='));
        refuse(core::findSetting(list, key), "--set", key);
    }
}

/// Whoever asks for nothing but the flight wants to see it.
bool wantsWindow(PlayTexts const& texts) {
    bool const writes = !(texts.log.empty() && texts.exported.empty() && texts.report.empty() && texts.screenshot.empty());
    return !texts.headless && !writes && platform::hasDisplay();
}
}  // namespace

PlayOptions replayOptions(std::filesystem::path const& file, PlayTexts const& texts,
                          CommonOptions const& given) {
    CommonOptions common = given;
    PlayOptions options;
    options.run = runOptions(texts, common);
    refuseAnotherFlight(common);
    options.run.watch = wantsWindow(texts);
    options.run.headless = !options.run.watch;
    if (options.run.watch) {
        usePlayerFiles(common, options.run);
        options.run.save.clear();  // what was delivered was counted when it was flown
        options.run.settings = common.settings;
        options.run.settings.weather.live = false;
    }
    options.run.noRender = options.run.headless && texts.screenshot.empty();
    Replay replay = readReplay(file, loadHangar());
    options.run.ticks = replay.ticks;
    options.run.settings.flight = replay.plan.simulation.settings;
    options.session.plan = std::move(replay.plan);
    options.session.script = std::move(replay.inputs);
    keepWritten(options.session, texts);
    return options;
}
}  // namespace luftpost::app
