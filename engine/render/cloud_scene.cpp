#include "engine/render/cloud_scene.h"

#include <algorithm>
#include <cmath>

#include "engine/gl/draw.h"
#include "engine/platform/paths.h"
#include "engine/render/cloud_field.h"
#include "engine/weather/cloud_column.h"
#include "engine/weather/noise_volume.h"
#include "shaders/lib/cloud.glsl"

namespace luftpost::render {
namespace {
constexpr unsigned kMapUnit = 10, kShapeUnit = 11, kDetailUnit = 12, kCurlUnit = 13;
constexpr int kTileBudget = 2;          // tiles uploaded a frame, half a megabyte each
constexpr int kStillSteps = 192;       // at least: a still may look far through tall clouds
constexpr float kShortestStep = 26.0f;  // m
constexpr float kStepPerDistance = 0.014f;
constexpr float kReach = 390'000.0f;    // m: the horizon of 12 km

/// A volume, or the plane of one that is a texel high.
template <class Texture, class Size>
Texture noiseTexture(weather::NoiseVolume const& volume, std::string_view label) {
    Texture texture{volume.channels() == 1 ? gl::Format::r8 : gl::Format::rgba8, Size{volume.size()}, volume.levelCount(), label};
    for (int level = 0; level < volume.levelCount(); ++level)
        texture.upload(std::span<std::uint8_t const>{volume.texels(level)}, level);
    return texture;
}

bool sameTrack(weather::Layer const& a, weather::Layer const& b) { return a.pattern == b.pattern && a.genus == b.genus; }
}  // namespace

CloudScene::CloudScene(gl::ProgramLibrary& programs)
    : programs_{programs},
      map_{gl::Format::r16, {weather::kMapSize, weather::kMapSize}, weather::kMapLevels * weather::kMaxLayers, 1, "cloud map"},
      repeat_{{.minFilter = gl::Filter::linearMipNearest, .wrap = gl::Wrap::repeat}, "cloud noise"},
      clamp_{{}, "cloud map"},
      buffer_{sizeof(glsl::CloudBlock), "cloud block"},
      tiles_{2} {
    loadVolumes();
}

void CloudScene::loadVolumes() {
    weather::NoiseVolumes const noise = weather::loadNoise(platform::dataFile("generated/noise_shape.bin").parent_path());
    shape_ = noiseTexture<gl::Texture3D, glm::ivec3>(noise.shape, "cloud shape noise");
    detail_ = noiseTexture<gl::Texture3D, glm::ivec3>(noise.detail, "cloud detail noise");
    curl_ = noiseTexture<gl::Texture2D, glm::ivec2>(noise.curl, "cloud curl noise");
    noiseSeed_ = static_cast<int>(weather::kNoiseSeed);
}

void CloudScene::remakeVolumes(unsigned seed) {
    auto const remake = [&](char const* name, gl::Texture& texture, glm::ivec3 const& size) {
        gl::Program const& program = programs_.compute(name);
        program.use();
        program.set("seed", seed);
        texture.bindImage(0, gl::Access::write);
        gl::dispatch({size.x / 8, size.y / 8, size.z});
        gl::barrier(gl::Barrier::all);
        texture.generateMipmaps();
    };
    remake("noise_shape", shape_, shape_.size());
    remake("noise_detail", detail_, detail_.size());
    remake("noise_curl", curl_, {curl_.size(), 1});
    noiseSeed_ = static_cast<int>(seed);
}

/// A layer keeps its slot as long as it lives: the order of layers changes, their maps need not.
void CloudScene::assignSlots(weather::Weather const& weather) {
    weather::MapLayers const before = slots_;
    std::array<bool, weather::kMaxLayers> used{};
    slots_ = {};
    slotOfLayer_.fill(-1);
    auto const put = [&](int layer, std::size_t slot) {
        used[slot] = true;
        slotOfLayer_[static_cast<std::size_t>(layer)] = static_cast<int>(slot);
        slots_[slot] = weather.layers[static_cast<std::size_t>(layer)];
    };
    for (int layer = 0; layer < weather.layerCount; ++layer)
        for (std::size_t slot = 0; slot < before.size(); ++slot)
            if (!used[slot] && before[slot] && sameTrack(*before[slot], weather.layers[static_cast<std::size_t>(layer)])) {
                put(layer, slot);
                break;
            }
    for (int layer = 0; layer < weather.layerCount; ++layer)
        for (std::size_t slot = 0; slot < used.size() && slotOfLayer_[static_cast<std::size_t>(layer)] < 0; ++slot)
            if (!used[slot]) put(layer, slot);
}

void CloudScene::takeTiles(int budget) {
    for (int i = 0; i < budget; ++i) {
        std::optional<weather::CloudMap::Ready> const ready = tiles_.take();
        if (!ready) return;
        int const slice = ready->level * weather::kMaxLayers + ready->slot;
        map_.uploadLayer(slice, std::span<std::uint16_t const>{ready->tile.ranks});
        slices_[static_cast<std::size_t>(ready->slot)][static_cast<std::size_t>(ready->level)] = {ready->key, ready->tile.corner};
    }
}

void CloudScene::placeMaps(Snapshot const& snapshot, weather::Weather const& sky) {
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    for (int layer = 0; layer < block_.march.x; ++layer) {
        weather::Layer const& now = sky.layers[static_cast<std::size_t>(layer)];
        int const slot = slotOfLayer_[static_cast<std::size_t>(layer)];
        for (int level = 0; level < weather::kMapLevels; ++level) {
            Slice const& slice = slices_[static_cast<std::size_t>(slot)][static_cast<std::size_t>(level)];
            bool const fits = slice.key && slice.key->pattern == now.pattern && slice.key->genus == now.genus &&
                              slice.key->seed == snapshot.seed && slice.key->scale == snapshot.clouds.weatherScale;
            glm::dvec2 const offset = glm::dvec2{camera.x - now.drift.x, camera.z + now.drift.y} - slice.corner;
            block_.mapPlaces[level * glsl::kCloudLayers + layer] =
                glm::vec4{glm::vec2{offset}, 1.0 / weather::kMapWidths[static_cast<std::size_t>(level)],
                          fits ? static_cast<float>(level * weather::kMaxLayers + slot + 1) : 0.0f};
        }
    }
}

void CloudScene::fillMarch(Snapshot const& snapshot, std::uint64_t frameNumber) {
    double const weatherSeconds = snapshot.time - weatherBefore_.value_or(snapshot.time);
    weatherBefore_ = snapshot.time;
    leapt_ = std::abs(weatherSeconds) > kOldestWeatherSeconds;
    bool const all = snapshot.still || leapt_ || snapshot.camera.projection != Projection::perspective;
    if (!all) blocks_.note(snapshot.frameSeconds, std::abs(weatherSeconds));
    int const side = all ? 1 : blocks_.side(blockSide(snapshot.clouds.rays));
    block_.light = {snapshot.clouds.hg, snapshot.clouds.powder, snapshot.clouds.shadows ? 1.0f : 0.0f, 0.0f};
    block_.march = {block_.march.x, snapshot.still ? std::max(snapshot.graphics.cloudSteps, kStillSteps) : snapshot.graphics.cloudSteps, static_cast<int>(frameNumber % static_cast<std::uint64_t>(side * side)), side};
    block_.step = {kShortestStep, kStepPerDistance, kReach, static_cast<float>(weatherSeconds)};
}

bool CloudScene::hasTowers() const {
    return std::any_of(block_.shapes, block_.shapes + block_.march.x, [](glsl::LayerShape const& shape) { return glsl::hasTowers(shape); });
}

void CloudScene::update(Snapshot const& snapshot, std::uint64_t frameNumber) {
    glm::dvec2 const eastNorth{snapshot.camera.positionWorld.x, -snapshot.camera.positionWorld.z};
    if (snapshot.clouds.noise != noiseSeed_) remakeVolumes(static_cast<unsigned>(snapshot.clouds.noise));
    weather::Weather const sky = snapshot.drawClouds ? skyAround(snapshot) : weather::Weather{};
    block_.march.x = sky.layerCount;
    if (sky.layerCount == 0) return;
    assignSlots(sky);
    tiles_.want(slots_, eastNorth, snapshot.seed, snapshot.clouds.weatherScale, snapshot.still);
    takeTiles(snapshot.still ? weather::kMapLevels * weather::kMaxLayers : kTileBudget);
    glsl::CloudShape const shape = weather::cloudShape(sky, snapshot.seed, eastNorth, snapshot.clouds);
    std::copy(std::begin(shape.layers), std::end(shape.layers), std::begin(block_.shapes));
    auto const fields = layerFields(snapshot, sky);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        block_.fields[i] = fields[i];
        block_.shapes[i].extent.x = fields[i].low.y;
        block_.shapes[i].extent.y = fields[i].high.z;
    }
    placeMaps(snapshot, sky);
    fillMarch(snapshot, frameNumber);
}

void CloudScene::bind() const {
    buffer_.bindUniform(static_cast<unsigned>(glsl::kCloudBlockBinding));
    map_.bind(kMapUnit);
    shape_.bind(kShapeUnit);
    detail_.bind(kDetailUnit);
    curl_.bind(kCurlUnit);
    clamp_.bind(kMapUnit);
    for (unsigned unit : {kShapeUnit, kDetailUnit, kCurlUnit}) repeat_.bind(unit);
}
}  // namespace luftpost::render
