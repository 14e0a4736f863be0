#include "engine/render/renderer.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <chrono>
#include <map>
#include <optional>

#include "engine/assets/model.h"
#include "engine/core/check.h"
#include "engine/gl/draw.h"
#include "engine/gl/program_library.h"
#include "engine/platform/paths.h"
#include "engine/render/cloud_pass.h"
#include "engine/render/composite_pass.h"
#include "engine/render/exposure_pass.h"
#include "engine/render/frame_context.h"
#include "engine/render/land_scene.h"
#include "engine/render/model_pass.h"
#include "engine/render/pass_timer.h"
#include "engine/render/post_pass.h"
#include "engine/render/precipitation_pass.h"
#include "engine/render/puff_pass.h"
#include "engine/render/sky_pass.h"
#include "engine/render/terrain_pass.h"
#include "engine/render/ui_pass.h"
#include "engine/render/vegetation_pass.h"
#include "engine/render/view.h"
#include "engine/render/water_pass.h"
#include "engine/render/weather_light_pass.h"
#include "engine/render/windscreen_pass.h"
#include "shaders/lib/camera.glsl"

namespace luftpost::render {
namespace {
using Clock = std::chrono::steady_clock;
constexpr unsigned kFrameBinding = 0;
/// Square views of a panorama: a little over 90 degrees, so that their edges have neighbours to be filtered with.
constexpr double kViewTangent = 1.02;

/// Pixels around a tile that are drawn with it and cut off: edges are smoothed over three, clouds and shafts look at their neighbours.
constexpr int kTileMargin = 8;

/// The finished picture, in the size of the window or of a tile.
struct Display {
    explicit Display(glm::ivec2 const& pixels)
        : size{pixels}, picture{gl::Format::rgba8, pixels, 1, "display"}, target{{&picture}, nullptr, "display"} {}
    glm::ivec2 size;
    gl::Texture2D picture;
    gl::Framebuffer target;
};

glm::ivec2 scaled(glm::ivec2 const& size, float resolution) {
    return glm::max(glm::ivec2{glm::round(glm::vec2{size} * resolution)}, glm::ivec2{1});
}

/// The six square views around the camera: north, east, south, west, up, down.
glm::dquat viewOrientation(int view) {
    double const quarter = 0.5 * core::kPi;
    if (view < 4) return glm::angleAxis(-quarter * view, glm::dvec3{0, 1, 0});
    return glm::angleAxis(view == 4 ? quarter : -quarter, glm::dvec3{1, 0, 0});
}

/// Whether rays of the tile may go through this view of the six; asked of a grid of rays, with a tenth to spare for those between.
bool sees(Tile const& tile, Projection projection, int view) {
    constexpr int kGrid = 32;
    glm::dquat const viewFromWorld = glm::conjugate(viewOrientation(view));
    for (int y = 0; y <= kGrid; ++y)
        for (int x = 0; x <= kGrid; ++x) {
            glm::vec2 const at = (glm::vec2{tile.corner} + glm::vec2{tile.size} * glm::vec2{x, y} / float{kGrid}) / glm::vec2{tile.picture};
            glm::vec3 const ray = projection == Projection::dome ? glsl::domeRay(at) : glsl::panoramaRay(at);
            glm::dvec3 const looked = viewFromWorld * glm::dvec3{ray};
            if (-looked.z > 0.9 * std::max(std::abs(looked.x), std::abs(looked.y))) return true;
        }
    return false;
}

/// The part of a texture's pixels (`width` in a row) that is asked for. GL's rows start at the bottom, an image's at the top.
template <class T>
assets::ImageOf<T> imageOf(std::vector<T> const& values, int width, glm::ivec2 const& corner, glm::ivec2 const& size) {
    assets::ImageOf<T> image{size.x, size.y, 4, {}};
    image.values.reserve(image.index(0, size.y, 0));
    for (int y = size.y - 1; y >= 0; --y) {
        auto const start = values.begin() + 4 * (static_cast<std::ptrdiff_t>(corner.y + y) * width + corner.x);
        image.values.insert(image.values.end(), start, start + 4 * size.x);
    }
    return image;
}

assets::Image opaque(assets::Image image) {
    for (std::size_t i = 3; i < image.values.size(); i += 4) image.values[i] = 255;
    return image;
}

/// From what the HDR target holds to radiance and the clouds' cover.
assets::FloatImage radiance(assets::FloatImage image, float preExposure) {
    float const scale = 1.0f / preExposure;
    for (std::size_t i = 0; i < image.values.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) image.values[i + c] *= scale;
        image.values[i + 3] = 1.0f - image.values[i + 3];
    }
    return image;
}

/// The targets of one size, made anew where they have another.
template <class T>
T& sized(std::optional<T>& targets, glm::ivec2 const& size) {
    if (!targets || targets->size != size) targets.emplace(size);
    return *targets;
}
}  // namespace

struct Renderer::Parts {
    explicit Parts(RendererOptions const& wanted)
        : options{wanted},
          programs{gl::ProgramLibrary::Compiling::together},
          sky{programs},
          clouds{programs},
          land{wanted.workers},
          terrain{programs},
          water{programs},
          vegetation{programs},
          composite{programs},
          weatherLight{programs},
          precipitation{programs},
          windscreen{programs},
          exposure{programs},
          models{programs},
          puffs{programs},
          post{programs},
          ui{programs},
          resample{programs.graphics(gl::GraphicsStages{"fullscreen", "resample", ""})},
          frameBuffer{sizeof(glsl::FrameBlock), "frame"},
          display{std::in_place, wanted.size} {
        programs.finish(options.progress);
    }

    void begin(Snapshot const& snapshot, Tile const& tile);
    void upload() { frameBuffer.update(gl::bytesOf(frame)); }
    void clear(Targets const& to) const;
    void drawScene(FrameContext const& context);
    void drawOpaque(FrameContext const& context);
    void drawLand(FrameContext const& context);
    void drawAround(FrameContext const& context);
    void drawNormals(FrameContext const& context);
    void drawView(FrameContext const& context, int view);
    void drawUi(Snapshot const& snapshot);
    void reloadShaders();

    RendererOptions options;
    gl::ProgramLibrary programs;
    PassTimer timer;
    bool timing = false;
    std::vector<PassTime> times;

    SkyPass sky;
    CloudPass clouds;
    LandScene land;
    TerrainPass terrain;
    WaterPass water;
    VegetationPass vegetation;
    CompositePass composite;
    WeatherLightPass weatherLight;
    PrecipitationPass precipitation;
    WindscreenPass windscreen;
    ExposurePass exposure;
    ModelPass models;
    PuffPass puffs;
    PostPass post;
    UiPass ui;
    gl::Program const& resample;

    gl::Buffer frameBuffer;
    glsl::FrameBlock frame{};
    std::optional<Targets> targets;
    std::optional<Targets> square;  // of a panorama's views
    std::optional<Display> display;
    glsl::FrameBlock shown{};       // of the picture in the display
    std::optional<Targets> tileTargets;
    std::optional<Display> tileDisplay;
    Tile tile, tileDrawn;           // asked for, and with its margin
    std::optional<ViewHistory> history;
    Projection projection = Projection::perspective;
    std::uint64_t number = 0;
    bool historyValid = false;
    std::map<std::string, ModelId> named;
    Clock::time_point looked = Clock::now();
};

Renderer::Renderer(RendererOptions const& options) : parts_{std::make_unique<Parts>(options)} {}
Renderer::~Renderer() = default;

ModelId Renderer::loadModel(std::string const& name) {
    auto const known = parts_->named.find(name);
    if (known != parts_->named.end()) return known->second;
    return parts_->named[name] = addModel(assets::readModel(platform::dataFile("assets/models/" + name + ".glb")));
}

ModelId Renderer::addModel(assets::Model const& model) { return parts_->models.add(model); }

glm::ivec2 Renderer::size() const { return parts_->options.size; }

void Renderer::resize(glm::ivec2 const& size) {
    if (size == parts_->options.size) return;
    parts_->options.size = size;
    parts_->display.emplace(size);
}

void Renderer::draw(Snapshot const& snapshot) {
    Parts& p = *parts_;
    glm::ivec2 const size = scaled(p.options.size, snapshot.graphics.resolution);
    p.historyValid = !snapshot.still && p.history && p.targets && p.projection == snapshot.camera.projection;
    p.begin(snapshot, wholeOf(size));
    FrameContext const context{snapshot, p.frame, sized(p.targets, size), p.number, p.historyValid};
    auto const pass = [&](char const* name, auto&& draw) { p.timer.pass(name, draw); };

    p.drawScene(context);
    pass("exposure", [&] { p.exposure.draw(context); });
    pass("bloom", [&] { p.post.drawBloom(context); });
    pass("tone map", [&] { p.post.drawToneMap(context, p.display->target); });
    pass("menus", [&] { p.drawUi(snapshot); });
    p.shown = p.frame;
    p.projection = snapshot.camera.projection;
    p.history = ViewHistory{clipFromWorld(snapshot.camera, static_cast<double>(size.x) / size.y), snapshot.camera.positionWorld};
    if (p.timing) p.times = p.timer.collect();
}

void Renderer::drawMenus(Snapshot const& snapshot) {
    Parts& p = *parts_;
    CHECK(p.targets, "no frame was drawn yet");
    p.frame = p.shown;
    p.upload();
    p.frameBuffer.bindUniform(kFrameBinding);
    p.exposure.bind();
    p.post.drawToneMap(FrameContext{snapshot, p.frame, *p.targets}, p.display->target);
    p.drawUi(snapshot);
}

void Renderer::drawTile(Snapshot const& snapshot, Tile const& tile) {
    Parts& p = *parts_;
    CHECK(p.targets && snapshot.still, "a tile is a part of a still that was drawn whole");
    p.tile = tile;
    p.tileDrawn = withMargin(tile, kTileMargin);
    p.historyValid = false;
    p.history.reset();
    p.begin(snapshot, p.tileDrawn);
    FrameContext const context{snapshot, p.frame, sized(p.tileTargets, p.tileDrawn.size), p.number, false, p.tileDrawn};
    p.drawScene(context);
    p.exposure.bind();
    p.post.drawToneMap(context, sized(p.tileDisplay, p.tileDrawn.size).target);
}

/// From the tables to the finished HDR picture.
void Renderer::Parts::drawScene(FrameContext const& context) {
    auto const pass = [&](char const* name, auto&& draw) { timer.pass(name, draw); };
    pass("sky tables", [&] { sky.draw(context); });
    pass("cloud shadow", [&] { clouds.prepare(context); });
    pass("model shadow", [&] { models.drawShadow(context); });
    pass("clear", [&] { clear(context.targets); });
    drawOpaque(context);
    pass("composite", [&] { composite.draw(context, sky.starsShow()); });
    pass("cloud march", [&] { clouds.march(context); });
    pass("cloud resolve", [&] { clouds.resolve(context); });
    pass("cloud composite", [&] { clouds.composite(context); });
    pass("weather light", [&] { weatherLight.draw(context, clouds); });
    pass("precipitation", [&] { precipitation.draw(context); });
    pass("smoke", [&] { puffs.draw(context); });
    pass("glass", [&] { models.drawBlended(context); });
    pass("windscreen", [&] { windscreen.draw(context); });
}

/// What all projections draw before the sky is put behind it.
void Renderer::Parts::drawOpaque(FrameContext const& context) {
    if (context.snapshot.camera.projection != Projection::perspective) return drawAround(context);
    if (context.snapshot.drawTerrain) drawLand(context);
    timer.pass("models", [&] { models.drawOpaque(context); });
    if (context.snapshot.debug.normals) timer.pass("normals", [&] { drawNormals(context); });
}

/// The debug view of F2.
void Renderer::Parts::drawNormals(FrameContext const& context) {
    models.drawNormals(context);
    if (context.snapshot.drawTerrain) terrain.drawNormals(context, land);
}

void Renderer::Parts::drawLand(FrameContext const& context) {
    timer.pass("chunks", [&] { land.update(context); });
    timer.pass("terrain", [&] { terrain.draw(context, land); });
    timer.pass("trees", [&] { vegetation.draw(context, land); });
    timer.pass("water", [&] { water.draw(context, land); });
}

void Renderer::Parts::begin(Snapshot const& snapshot, Tile const& part) {
    reloadShaders();
    if (!historyValid) history.reset();
    ++number;
    describeView(snapshot, part, number, history, frame);
    sky.describe(snapshot, frame);
    clouds.describe(snapshot);
    weatherLight.describe(snapshot, frame);
    models.describe(snapshot, frame);
    upload();
    frameBuffer.bindUniform(kFrameBinding);
    timer.setOn(timing);
}

void Renderer::Parts::clear(Targets const& to) const {
    to.opaque.clearColour(0, glm::vec4{0.0f, 0.0f, 0.0f, 1.0f});
    to.opaque.clearColour(1, glm::vec4{0.0f});
    to.opaque.clearDepth();
}

/// Rasterised passes know perspective alone: six square views, resampled by ray.
void Renderer::Parts::drawAround(FrameContext const& context) {
    int const side = std::max(context.picture().x / 4, context.picture().y / 2);
    sized(square, glm::ivec2{side});
    glsl::FrameBlock const whole = frame;
    int const views = context.snapshot.camera.projection == Projection::dome ? 5 : 6;
    for (int view = 0; view < views; ++view) {
        if (context.tile && !sees(*context.tile, context.snapshot.camera.projection, view)) continue;
        drawView(context, view);
        frame = whole;
        upload();
        context.targets.blended.bind();
        gl::DrawState state;
        state.depthWrite = true;
        gl::apply(state);
        resample.use();
        resample.set("viewFromWorld", glm::mat3{glm::mat4_cast(glm::quat{glm::conjugate(viewOrientation(view))})});
        resample.set("tangentHalf", static_cast<float>(kViewTangent));
        square->colour.bind(0);
        square->depth.bind(1);
        gl::drawFullscreen();
    }
}

void Renderer::Parts::drawView(FrameContext const& context, int view) {
    Snapshot looking = context.snapshot;
    looking.camera.projection = Projection::perspective;
    looking.camera.horizontalFov = 2.0 * std::atan(kViewTangent);
    looking.camera.worldFromCamera = viewOrientation(view);
    describeView(looking, wholeOf(square->size), number, std::nullopt, frame);
    upload();
    clear(*square);
    drawOpaque(FrameContext{looking, frame, *square, number, false});
}

void Renderer::Parts::drawUi(Snapshot const& snapshot) {
    if (snapshot.photo) ui.usePhoto(*snapshot.photo, snapshot.photoVersion);
    if (snapshot.ui) ui.draw(*snapshot.ui, snapshot.fontVersion, display->target);
}

void Renderer::Parts::reloadShaders() {
    if (!options.hotReload || Clock::now() - looked < std::chrono::seconds{1}) return;
    looked = Clock::now();
    programs.reloadChanged();
}

void Renderer::present(glm::ivec2 const& windowSize) { parts_->display->target.copyToWindow(windowSize); }

assets::Image Renderer::readPixels() {
    glm::ivec2 const size = parts_->display->size;
    return opaque(imageOf(parts_->display->picture.readBytes(), size.x, glm::ivec2{0}, size));
}

assets::FloatImage Renderer::readHdr() {
    CHECK(parts_->targets, "no frame was drawn yet");
    glm::ivec2 const size = parts_->targets->size;
    return radiance(imageOf(parts_->targets->colour.readFloats(), size.x, glm::ivec2{0}, size), parts_->shown.exposure.x);
}

assets::Image Renderer::readTilePixels() {
    Parts const& p = *parts_;
    CHECK(p.tileDisplay, "no tile was drawn yet");
    return opaque(imageOf(p.tileDisplay->picture.readBytes(), p.tileDrawn.size.x, p.tile.corner - p.tileDrawn.corner, p.tile.size));
}

assets::FloatImage Renderer::readTileHdr() {
    Parts const& p = *parts_;
    CHECK(p.tileTargets, "no tile was drawn yet");
    auto part = imageOf(p.tileTargets->colour.readFloats(), p.tileDrawn.size.x, p.tile.corner - p.tileDrawn.corner, p.tile.size);
    return radiance(std::move(part), p.frame.exposure.x);
}

void Renderer::setTiming(bool on) {
    parts_->timing = on;
    if (!on) parts_->times.clear();
}
terrain::StreamerStats Renderer::chunkStats() const { return parts_->land.stats(); }
std::size_t Renderer::cloudBytes() const { return parts_->clouds.bytes(); }
std::size_t Renderer::skyBytes() const { return parts_->sky.bytes() + parts_->clouds.bytes() + parts_->clouds.screenBytes(); }
std::vector<PassTime> const& Renderer::passTimes() const { return parts_->times; }
}  // namespace luftpost::render
