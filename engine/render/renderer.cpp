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

namespace luftpost::render {
namespace {
using Clock = std::chrono::steady_clock;
constexpr unsigned kFrameBinding = 0;
/// Square views of a panorama: a little over 90 degrees, so that their edges have neighbours to be filtered with.
constexpr double kViewTangent = 1.02;

/// The finished picture, in the size of the window.
struct Display {
    explicit Display(glm::ivec2 const& size)
        : picture{gl::Format::rgba8, size, 1, "display"}, target{{&picture}, nullptr, "display"} {}
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

/// GL's rows start at the bottom, an image's at the top.
template <class T>
assets::ImageOf<T> flipped(std::vector<T> const& values, glm::ivec2 const& size) {
    assets::ImageOf<T> image{size.x, size.y, 4, {}};
    std::size_t const row = static_cast<std::size_t>(size.x) * 4;
    image.values.reserve(values.size());
    for (int y = size.y - 1; y >= 0; --y) {
        auto const start = values.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y));
        image.values.insert(image.values.end(), start, start + static_cast<std::ptrdiff_t>(row));
    }
    return image;
}
}  // namespace

struct Renderer::Parts {
    explicit Parts(RendererOptions const& wanted)
        : options{wanted},
          sky{programs},
          clouds{programs},
          land{wanted.workers},
          terrain{programs},
          water{programs},
          vegetation{programs},
          composite{programs},
          weatherLight{programs},
          precipitation{programs},
          exposure{programs},
          models{programs},
          puffs{programs},
          post{programs},
          ui{programs},
          resample{programs.graphics(gl::GraphicsStages{"fullscreen", "resample", ""})},
          frameBuffer{sizeof(glsl::FrameBlock), "frame"},
          display{std::in_place, wanted.size} {}

    void begin(Snapshot const& snapshot);
    void upload() { frameBuffer.update(gl::bytesOf(frame)); }
    void clear(Targets const& to) const;
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
    p.begin(snapshot);
    FrameContext const context{snapshot, p.frame, *p.targets, p.number, p.historyValid};
    auto const pass = [&](char const* name, auto&& draw) { p.timer.pass(name, draw); };

    pass("sky tables", [&] { p.sky.draw(context); });
    pass("cloud shadow", [&] { p.clouds.prepare(context); });
    pass("model shadow", [&] { p.models.drawShadow(context); });
    pass("clear", [&] { p.clear(*p.targets); });
    p.drawOpaque(context);
    pass("composite", [&] { p.composite.draw(context); });
    pass("cloud march", [&] { p.clouds.march(context); });
    pass("cloud resolve", [&] { p.clouds.resolve(context); });
    pass("cloud composite", [&] { p.clouds.composite(context); });
    pass("weather light", [&] { p.weatherLight.draw(context, p.clouds); });
    pass("precipitation", [&] { p.precipitation.draw(context); });
    pass("smoke", [&] { p.puffs.draw(context); });
    pass("glass", [&] { p.models.drawBlended(context); });
    pass("exposure", [&] { p.exposure.draw(context); });
    pass("bloom", [&] { p.post.drawBloom(context); });
    pass("tone map", [&] { p.post.drawToneMap(context, p.display->target); });
    pass("menus", [&] { p.drawUi(snapshot); });
    if (p.timing) p.times = p.timer.collect();
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

void Renderer::Parts::begin(Snapshot const& snapshot) {
    reloadShaders();
    glm::ivec2 const size = scaled(options.size, snapshot.graphics.resolution);
    historyValid = !snapshot.still && targets && projection == snapshot.camera.projection && history;
    if (!targets || targets->size != size) targets.emplace(size);
    if (!historyValid) history.reset();
    projection = snapshot.camera.projection;
    ++number;
    describeView(snapshot, size, number, history, frame);
    sky.describe(snapshot, frame);
    clouds.describe(snapshot);
    weatherLight.describe(snapshot, frame);
    models.describe(snapshot, frame);
    upload();
    frameBuffer.bindUniform(kFrameBinding);
    history = ViewHistory{clipFromWorld(snapshot.camera, static_cast<double>(size.x) / size.y), snapshot.camera.positionWorld};
    timer.setOn(timing);
}

void Renderer::Parts::clear(Targets const& to) const {
    to.opaque.clearColour(0, glm::vec4{0.0f, 0.0f, 0.0f, 1.0f});
    to.opaque.clearColour(1, glm::vec4{0.0f});
    to.opaque.clearDepth();
}

/// Rasterised passes know perspective alone: six square views, resampled by ray.
void Renderer::Parts::drawAround(FrameContext const& context) {
    int const side = std::max(context.targets.size.x / 4, context.targets.size.y / 2);
    if (!square || square->size.x != side) square.emplace(glm::ivec2{side});
    glsl::FrameBlock const whole = frame;
    int const views = context.snapshot.camera.projection == Projection::dome ? 5 : 6;
    for (int view = 0; view < views; ++view) {
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
    describeView(looking, square->size, number, std::nullopt, frame);
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
    assets::Image image = flipped(parts_->display->picture.readBytes(), parts_->options.size);
    for (std::size_t i = 3; i < image.values.size(); i += 4) image.values[i] = 255;
    return image;
}

assets::FloatImage Renderer::readHdr() {
    CHECK(parts_->targets, "no frame was drawn yet");
    assets::FloatImage image = flipped(parts_->targets->colour.readFloats(), parts_->targets->size);
    float const scale = 1.0f / parts_->frame.exposure.x;
    for (std::size_t i = 0; i < image.values.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) image.values[i + c] *= scale;
        image.values[i + 3] = 1.0f - image.values[i + 3];
    }
    return image;
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
