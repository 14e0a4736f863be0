// `luftpost bench`: how long frames, passes, chunks and the start take, with a yardstick that scales other machines.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/gl/context.h"
#include "engine/platform/surface.h"
#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/render/yardstick.h"
#include "engine/sky/sky_state.h"
#include "engine/terrain/chunk.h"
#include "engine/terrain/land.h"
#include "engine/weather/source.h"
#include "game/app/commands.h"
#include "game/app/report.h"

namespace luftpost::app {
namespace {
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
constexpr unsigned kSeed = 1;
constexpr int kWarmUp = 18;  // frames: after 16 every ray was marched once
constexpr int kMeasured = 30;
constexpr int kYardstickRepeats = 3;

struct BenchScene {
    char const* name;
    char const* weather;
    char const* time;
    double altitude;      // m above sea level
    double azimuth_deg, elevation_deg;
};
constexpr std::array<BenchScene, 6> kScenes{{
    {"noon", "preset:fair", "2023-06-21T11:30Z", 1000.0, 30.0, 2.0},
    {"overcast", "preset:overcast", "2023-06-21T11:30Z", 700.0, 200.0, 2.0},
    {"storm", "preset:storm", "2023-06-21T15:00Z", 900.0, 250.0, 3.0},
    {"sunset", "preset:broken", "2023-06-21T19:00Z", 800.0, 300.0, 3.0},
    {"night", "preset:fair", "2023-06-21T23:30Z", 800.0, 60.0, 5.0},
    {"high", "preset:broken", "2023-06-21T11:30Z", 10000.0, 120.0, -4.0},
}};

double milliseconds(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

render::Snapshot snapshotOf(BenchScene const& scene, weather::Field const& field, CommonOptions const& common,
                            bool peerTerms) {
    render::Snapshot snapshot;
    snapshot.camera.positionWorld = {0.0, scene.altitude, 0.0};
    snapshot.camera.worldFromCamera =
        glm::angleAxis(-core::radians(scene.azimuth_deg), glm::dvec3{0.0, 1.0, 0.0}) *
        glm::angleAxis(core::radians(scene.elevation_deg), glm::dvec3{1.0, 0.0, 0.0});
    snapshot.graphics = common.settings.graphics;
    snapshot.clouds = common.settings.flight.clouds;
    render::applyQuality(snapshot.graphics.quality, snapshot.graphics, snapshot.clouds);
    if (peerTerms) {
        snapshot.clouds.rays = 1.0f;
        snapshot.graphics.cloudSteps = 64;
    }
    snapshot.time = *core::parseUtc(scene.time);
    snapshot.seed = kSeed;
    snapshot.place = field.place();
    snapshot.sky = sky::skyState(snapshot.place, snapshot.time);
    snapshot.field = &field;
    snapshot.weather = field.at(0.0, 0.0, snapshot.time);
    return snapshot;
}

/// Mean opacity of the clouds over the picture.
double cloudAlpha(render::Renderer& renderer) {
    assets::FloatImage const image = renderer.readHdr();
    double sum = 0.0;
    for (std::size_t i = 3; i < image.values.size(); i += 4) sum += static_cast<double>(image.values[i]);
    return sum / (static_cast<double>(image.values.size()) / 4.0);
}

/// The first frame waits for all chunks; then the clouds' history fills; then frames with frozen time are measured.
Json measured(render::Renderer& renderer, BenchScene const& scene, CommonOptions const& common, bool peerTerms) {
    weather::Field const field = weather::loadWeather(scene.weather);
    render::Snapshot snapshot = snapshotOf(scene, field, common, peerTerms);
    snapshot.still = true;
    renderer.draw(snapshot);
    snapshot.still = false;
    renderer.setTiming(true);
    std::vector<double> frames;
    std::map<std::string, std::vector<double>> passes;
    for (int i = 0; i < kWarmUp + kMeasured; ++i) {
        gl::finish();
        auto const start = Clock::now();
        renderer.draw(snapshot);
        gl::finish();
        if (i < kWarmUp) continue;
        frames.push_back(milliseconds(start, Clock::now()));
        for (render::PassTime const& time : renderer.passTimes()) passes[time.name].push_back(time.milliseconds);
    }
    renderer.setTiming(false);
    Json result{{"name", scene.name}, {"passes", Json::object()}};
    for (auto const& [name, times] : passes)
        result["passes"][name] = {{"p50", percentile(times, 0.5)}, {"p99", percentile(times, 0.99)}};
    result["frame_ms"] = {{"p50", percentile(frames, 0.5)}, {"p99", percentile(frames, 0.99)}, {"p999", percentile(frames, 0.999)}};
    result["cloud_alpha"] = cloudAlpha(renderer);
    return result;
}

/// Samples of the land's function a second, on one core, as chunks are made.
double chunkSamplesPerSecond() {
    terrain::Land const land{kSeed, 0.0};
    auto const start = Clock::now();
    std::size_t samples = 0;
    for (std::int32_t i = 0; i < 6; ++i) samples += terrain::makeChunk(land, {i % 3, 3 * i, i}).samples.size();
    return static_cast<double>(samples) / (milliseconds(start, Clock::now()) * 1e-3);
}

std::vector<BenchScene> chosenScenes(std::string const& name) {
    std::vector<BenchScene> scenes;
    std::vector<std::string> names;
    for (BenchScene const& scene : kScenes) {
        names.emplace_back(scene.name);
        if (name.empty() || name == scene.name) scenes.push_back(scene);
    }
    if (scenes.empty())
        throw core::Error{"--scene", "", fmt::format("expected one of {}, found {}", fmt::join(names, ", "), name)};
    return scenes;
}

struct BenchTexts {
    std::string scene;
    std::filesystem::path json;
    bool peerTerms = false;
};

int runBench(BenchTexts const& texts, CommonOptions const& common) {
    std::vector<BenchScene> const scenes = chosenScenes(texts.scene);
    if (texts.json.empty()) throw core::Error{"--json", "", "expected FILE"};
    core::checkOutputFolder("--json", texts.json);
    auto const start = Clock::now();
    auto const surface = platform::openHeadless(common.size);
    gl::prepareContext();
    render::Renderer renderer{{.size = common.size}};
    weather::Field const field = weather::loadWeather(scenes[0].weather);
    renderer.draw(snapshotOf(scenes[0], field, common, texts.peerTerms));
    gl::finish();
    double const startup = milliseconds(start, Clock::now());

    Json result{{"renderer", gl::rendererName()},
                {"size", {common.size.x, common.size.y}},
                {"peer_terms", texts.peerTerms},
                {"scenes", Json::array()}};
    for (BenchScene const& scene : scenes) result["scenes"].push_back(measured(renderer, scene, common, texts.peerTerms));
    auto const megabytes = [](std::size_t bytes) { return static_cast<double>(bytes) * 1e-6; };
    render::YardstickResult const yard = render::yardstick(kYardstickRepeats);
    result["yardstick"] = {{"ms", yard.milliseconds}, {"cloud", yard.cloud}, {"size", {1280, 720}}};
    result["chunk"] = {{"samples_per_s_per_core", chunkSamplesPerSecond()}};
    result["startup_ms"] = startup;
    result["memory"] = {{"rss_mb", residentMemory_mb()},
                        {"gpu_mb", megabytes(gl::allocatedBytes())},
                        {"cloud_mb", megabytes(renderer.cloudBytes())},
                        {"sky_mb", megabytes(renderer.skyBytes())}};
    core::writeFileAtomically(texts.json, result.dump(2) + "\n");
    return 0;
}
}  // namespace

void addBenchCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    CLI::App* bench = app.add_subcommand("bench", "times of frames, passes, chunks and the start, and memory, as JSON");
    auto const texts = std::make_shared<BenchTexts>();
    bench->add_option("--scene", texts->scene, "one scene only: noon, overcast, storm, sunset, night, high");
    bench->add_flag("--peer-terms", texts->peerTerms, "clouds with every pixel marched, 64 steps, 6 light samples, no history");
    bench->add_option("--json", texts->json, "FILE that takes the figures");
    bench->callback([texts, &common, &chosen] { chosen = [texts, &common] { return runBench(*texts, common); }; });
}
}  // namespace luftpost::app
