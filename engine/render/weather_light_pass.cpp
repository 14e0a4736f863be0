#include "engine/render/weather_light_pass.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/gl/draw.h"
#include "engine/render/cloud_field.h"
#include "engine/sky/particle_phase.h"
#include "engine/weather/field.h"
#include "engine/weather/lightning.h"
#include "engine/weather/showers.h"
#include "shaders/lib/lightning.glsl"
#include "shaders/lib/sky_optics.glsl"

namespace luftpost::render {
namespace {
constexpr double kReach = 40'000.0;        // m: as the layers' fields
constexpr double kFlashReach = 60'000.0;   // m
constexpr int kFlightBlock = 4;               // pixels each way for which one ray of shafts stands in flight
constexpr int kStillSamples = 128, kFlightSamples = 40;  // along a ray
constexpr double kDroplet = 8e-6;          // m, effective radius where glories are seen
/// Radiant intensity of a strong stroke: some 4e5 J of light (Turman 1977 saw 1e5 to 1e7 from space) which a frame of a sixtieth of a second
/// gathers, into all directions, against the sun's 1361 W/m2 of which half is light.
constexpr double kFlashIntensity = 4e5 * 60.0 / (4.0 * core::kPi) / (0.5 * 1361.0);

/// Rows of rain, droplets and ice, as lib/sky_optics knows them.
std::vector<float> phaseTexels() {
    std::vector<float> texels;
    for (sky::PhaseTable const& table : {sky::rainPhase(), sky::dropletPhase(kDroplet), sky::icePhase()})
        for (glm::vec4 const& value : table) texels.insert(texels.end(), {value.x, value.y, value.z, value.w});
    return texels;
}

std::array<weather::Shower, weather::kMaxLayers> showersIn(weather::Weather const& weather, weather::CloudSettings const& settings) {
    std::array<double, weather::kMaxLayers> visible{};
    for (std::size_t i = 0; i < visible.size(); ++i)
        visible[i] = std::clamp(static_cast<double>(weather.layers[i].cover - settings.densityThreshold), 0.0, 1.0);
    return weather::showersOf(weather, visible);
}

glsl::LayerFall fallOf(weather::Shower const& shower, weather::CloudSettings const& settings) {
    glsl::LayerFall fall{};
    fall.shower = {static_cast<float>(shower.root), static_cast<float>(shower.drying), static_cast<float>(shower.from) + settings.height,
                   shower.storm ? 1.0f : 0.0f};
    fall.lag = {static_cast<float>(shower.lag.x), static_cast<float>(-shower.lag.y), 0.0f, 0.0f};
    return fall;
}

/// Above sea level, m: over it nothing is drawn that falls.
float highestFall(weather::Weather const& sky, std::array<glsl::LayerFall, weather::kMaxLayers> const& falls) {
    constexpr float kInto = 400.0f;  // m of cloud
    float top = 0.0f;
    for (std::size_t i = 0; i < falls.size(); ++i)
        if (falls[i].shower.x > 0.0f) top = std::max(top, sky.layers[i].base + kInto);
    return top;
}

glm::vec4 relative(glm::dvec3 const& world, Snapshot const& snapshot, double w) {
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    return glm::vec4{glm::dvec4{world.x - camera.x, world.y, world.z - camera.z, w}};
}
}  // namespace

std::array<glsl::LayerFall, weather::kMaxLayers> layerFalls(Snapshot const& snapshot, weather::Weather const& sky) {
    std::array<glsl::LayerFall, weather::kMaxLayers> falls{};
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    // A plane through the places around: camera, east, west, north, south.
    std::array<glm::dvec2, 5> const offsets{glm::dvec2{0.0}, {kReach, 0.0}, {-kReach, 0.0}, {0.0, kReach}, {0.0, -kReach}};
    std::array<std::array<float, 5>, weather::kMaxLayers> roots{};
    for (std::size_t place = 0; place < (snapshot.field != nullptr ? offsets.size() : 1); ++place) {
        weather::Weather const there =
            place == 0 ? snapshot.weather : snapshot.field->at(camera.x + offsets[place].x, -camera.z + offsets[place].y, snapshot.time);
        auto const showers = showersIn(there, snapshot.clouds);
        for (std::size_t i = 0; i < static_cast<std::size_t>(there.layerCount); ++i)
            for (std::size_t k = 0; k < static_cast<std::size_t>(sky.layerCount); ++k) {
                if (sky.layers[k].pattern != there.layers[i].pattern) continue;
                roots[k][place] = static_cast<float>(showers[i].root);
                if (falls[k].shower.x < roots[k][place]) falls[k] = fallOf(showers[i], snapshot.clouds);
            }
    }
    for (std::size_t k = 0; k < falls.size(); ++k) {
        float const perMetre = static_cast<float>(0.5 / kReach);
        falls[k].root = {roots[k][0], (roots[k][1] - roots[k][2]) * perMetre, (roots[k][4] - roots[k][3]) * perMetre, 0.0f};
    }
    return falls;
}

std::vector<glsl::Stroke> strokesNow(Snapshot const& snapshot) {
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    auto flashes = weather::flashes(snapshot.weather, snapshot.seed, snapshot.time - weather::kFlashSeconds, snapshot.time + 1e-3, {camera.x, -camera.z},
                                    kFlashReach, snapshot.place.altitude_m);
    std::vector<glsl::Stroke> strokes;
    for (weather::Flash const& flash : flashes) {
        double const intensity = kFlashIntensity * flash.power * weather::flashLight(flash, snapshot.time - flash.time);
        if (intensity < 1e-3 * kFlashIntensity) continue;
        strokes.push_back({relative(flash.sourceWorld, snapshot, intensity), relative(flash.groundWorld, snapshot, flash.toGround ? 1.0 : 0.0),
                           glm::vec4{static_cast<float>(flash.seed), 0.0f, 0.0f, 0.0f}});
    }
    auto const here = [&](glsl::Stroke const& s) {
        return glsl::strokeIrradiance(s.source.w, glm::length(glm::vec3{s.source} - glm::vec3{0.0f, static_cast<float>(camera.y), 0.0f}));
    };
    std::sort(strokes.begin(), strokes.end(), [&](auto const& a, auto const& b) { return here(a) > here(b); });
    strokes.resize(std::min(strokes.size(), static_cast<std::size_t>(glsl::kMostStrokes)));
    return strokes;
}

WeatherLightPass::WeatherLightPass(gl::ProgramLibrary& programs)
    : program_{programs.compute("weather_light")}, quietProgram_{programs.compute("weather_light", {"STORMY false"})}, fallingProgram_{programs.compute("falling")}, computing_{std::async(std::launch::async, phaseTexels)}, buffer_{sizeof(glsl::FallBlock), "what falls"} {}

void WeatherLightPass::describe(Snapshot const& snapshot, glsl::FrameBlock& frame) {
    block_ = {};
    if (snapshot.field == nullptr || !snapshot.drawClouds) return;
    weather::Weather const sky = skyAround(snapshot);
    auto const falls = layerFalls(snapshot, sky);
    std::copy(falls.begin(), falls.end(), std::begin(block_.falls));
    bool const falling = std::any_of(falls.begin(), falls.end(), [](glsl::LayerFall const& f) { return f.shower.x > 0.0f; });
    weather::Weather const& here = snapshot.weather;
    double const everywhere = here.precipitation == weather::Precipitation::None ? 0.0 : here.precipitationRate;
    block_.fallAll.melting = glm::vec4{glm::dvec4{here.freezingLevel, weather::liquidAtGround(here.precipitation, here.temperature),
                                                  snapshot.place.altitude_m, everywhere}};
    std::vector<glsl::Stroke> const strokes = strokesNow(snapshot);
    std::copy(strokes.begin(), strokes.end(), std::begin(block_.strokes));
    block_.optics = {falling ? 1.0f : 0.0f, highestFall(sky, falls), static_cast<float>(strokes.size()), 0.0f};
    for (glsl::Stroke const& stroke : strokes) {
        float const away = glm::length(glm::vec3{stroke.source} - glm::vec3{0.0f, static_cast<float>(snapshot.camera.positionWorld.y), 0.0f});
        float const light = glsl::strokeIrradiance(stroke.source.w, away);
        frame.skyIrradiance += glm::vec4{light * glm::vec3{0.92f, 0.96f, 1.12f}, 0.0f};
        frame.groundIrradiance += glm::vec4{0.15f * light * glm::vec3{0.92f, 0.96f, 1.12f}, 0.0f};
    }
}

WeatherLightPass::Shafts::Shafts(glm::ivec2 const& pixels, int size)
    : picture{pixels},
      block{size},
      light{gl::Format::rgba16f, (pixels + size - 1) / size, 1, "shafts"},
      lit{gl::Format::rgba16f, (pixels + size - 1) / size, 1, "lit rain"} {}

void WeatherLightPass::takePhases() {
    if (phases_) return;
    phases_.emplace(gl::Format::rgba32f, glm::ivec2{sky::kPhaseAngles, static_cast<int>(glsl::kPhaseRows)}, 1, "phase functions");
    std::vector<float> const texels = computing_.get();
    phases_->upload(std::span<float const>{texels});
    phases_->setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::clampToEdge);
}

/// Whether there is anything to draw: what falls or flashes, ice for a halo, cloud under the camera for a glory.
bool WeatherLightPass::adds(FrameContext const& context, CloudScene const& scene) const {
    if (block_.optics.x > 0.5f || block_.optics.z > 0.5f) return true;
    for (int i = 0; i < scene.block().march.x; ++i) {
        glsl::LayerShape const& shape = scene.block().shapes[i];
        if (shape.look.z > 0.5f || static_cast<double>(shape.extent.x) < context.snapshot.camera.positionWorld.y) return true;
    }
    return false;
}

void WeatherLightPass::drawShafts(FrameContext const& context) {
    bool const every = context.snapshot.still;
    int const block = every ? 1 : kFlightBlock;
    if (!shafts_ || shafts_->picture != context.targets.size || shafts_->block != block) shafts_.emplace(context.targets.size, block);
    fallingProgram_.use();
    fallingProgram_.set("block", block);
    fallingProgram_.set("samples", every ? kStillSamples : kFlightSamples);
    context.targets.colour.bind(2);
    shafts_->light.bindImage(0, gl::Access::write);
    shafts_->lit.bindImage(1, gl::Access::write);
    gl::dispatchOver(shafts_->light.size(), {8, 8});
    gl::barrier(gl::Barrier::textureFetch);
    shafts_->light.bind(3);
    shafts_->lit.bind(4);
}

void WeatherLightPass::draw(FrameContext const& context, CloudPass const& clouds) {
    gl::Texture2D const* facts = clouds.facts();
    if (facts == nullptr || !adds(context, clouds.scene())) return;
    buffer_.update(gl::bytesOf(block_));
    buffer_.bindUniform(static_cast<unsigned>(glsl::kFallBlockBinding));
    clouds.scene().bind();
    context.targets.depth.bind(0);
    facts->bind(1);
    takePhases();
    phases_->bind(static_cast<unsigned>(glsl::kPhaseUnit));
    bool const falling = block_.optics.x > 0.5f;
    if (falling) drawShafts(context);
    bool const stormy = falling || block_.optics.z > 0.5f;
    (stormy ? program_ : quietProgram_).use();
    if (stormy) program_.set("block", falling ? shafts_->block : 1);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    gl::dispatchOver(context.targets.size, {8, 8});
    gl::barrier(gl::Barrier::all);
}
}  // namespace luftpost::render
