// `luftpost sky`: stills of the sky and the land under it.
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/assets/image_mean.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/gl/context.h"
#include "engine/platform/paths.h"
#include "engine/platform/surface.h"
#include "engine/render/quality.h"
#include "engine/render/reference_picture.h"
#include "engine/render/renderer.h"
#include "engine/render/tiled_picture.h"
#include "engine/sky/sky_state.h"
#include "engine/terrain/land.h"
#include "engine/weather/air.h"
#include "engine/weather/source.h"
#include "game/app/colour_comparison.h"
#include "game/app/commands.h"
#include "game/app/photo_box.h"
#include "game/app/options.h"
#include "game/app/plan.h"
#include "game/app/video_file.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
namespace {
namespace fs = std::filesystem;
constexpr double kEyeHeight = 2.0;       // m above the ground
constexpr double kHighestEye = 20000.0;  // m above sea level
constexpr int kLargestWhole = 4096;      // pixels a side that are drawn at once; more by tiles
constexpr int kLargestMeasured = 2048;   // pixels a side of the picture that tiles take exposure and glow from
constexpr long long kMostFrames = 100000;
constexpr long long kMostSamples = 1 << 24;
constexpr int kMostAcross = 8;  // rays for a pixel, each way
constexpr unsigned kUsualSeed = 1;

/// The command's own options as the command line has them.
struct SkyTexts {
    std::string look, fov, exposure, frames, step, plan, reference, supersample;
    fs::path output, photo, beside, onto;
    bool panorama = false;
    bool dome = false;
};

/// What to draw, read and checked.
struct SkyRequest {
    glm::dvec2 look{0.0, 10.0};  // azimuth, elevation, degrees
    double fov_deg = 75.0;
    render::Projection projection = render::Projection::perspective;
    float exposure_ev = 0.0f;
    long long firstFrame = 0, lastFrame = 0;
    bool lapse = false;
    double step = 60.0;  // s
    fs::path output;
    double plan_km = 0.0;  // 0: a picture, else the plan of a square this wide
    int samples = 0;       // 0: as the game draws it, else so many paths for every pixel,
    fs::path onto;         // added to those of this picture
    int raysAcross = 1;    // for a pixel, which is the mean of so many squared
    std::vector<assets::PhotoFile> photos;  // to be compared with
    fs::path beside;                        // picture and photograph side by side
};

bool isExr(fs::path const& file) { return file.extension() == ".exr"; }

void readView(SkyRequest& request, SkyTexts const& texts) {
    if (texts.panorama && texts.dome)
        throw core::Error{"--dome", "", "expected not together with --panorama"};
    if (texts.panorama) request.projection = render::Projection::panorama;
    if (texts.dome) request.projection = render::Projection::dome;
    bool const whole = texts.panorama || texts.dome;
    if (whole && !(texts.look.empty() && texts.fov.empty()))
        throw core::Error{texts.look.empty() ? "--fov" : "--look", "",
                          "expected not together with --panorama or --dome"};
    if (!texts.look.empty()) {
        auto const angles = numbersOption("--look", texts.look, 2, 2, "AZ,EL");
        request.look = {angles[0], angles[1]};
        if (std::abs(request.look.x) > 720.0 || std::abs(request.look.y) > 90.0)
            throw core::Error{"--look", "",
                              fmt::format("expected AZ -720..720 and EL -90..90, found {}", texts.look)};
    }
    if (!texts.fov.empty()) request.fov_deg = numberOption("--fov", texts.fov, 0.1, 170.0);
}

void readLapse(SkyRequest& request, SkyTexts const& texts) {
    if (!texts.step.empty()) request.step = numberOption("--step", texts.step, 0.001, 1.0e6);
    if (texts.frames.empty()) {
        if (!texts.step.empty()) throw core::Error{"--step", "", "expected only together with --frames A:B"};
        return;
    }
    auto const colon = texts.frames.find(':');
    if (colon == std::string::npos)
        throw core::Error{"--frames", "", fmt::format("expected A:B, found {}", texts.frames)};
    std::string_view const text = texts.frames;
    request.lapse = true;
    request.firstFrame = wholeOption("--frames", text.substr(0, colon), 0, kMostFrames);
    request.lastFrame = wholeOption("--frames", text.substr(colon + 1), request.firstFrame, kMostFrames);
}

void readPlan(SkyRequest& request, SkyTexts const& texts) {
    if (texts.plan.empty()) return;
    request.plan_km = numberOption("--plan", texts.plan, 0.001, 2000.0);
    if (request.projection != render::Projection::perspective || !(texts.look.empty() && texts.fov.empty() && texts.exposure.empty()) || request.lapse)
        throw core::Error{"--plan", "", "expected not together with --look, --fov, --exposure, --panorama, --dome or --frames"};
    if (!isExr(request.output))
        throw core::Error{"-o", "", fmt::format("expected FILE.exr with --plan, found {}", request.output.string())};
}

void readReference(SkyRequest& request, SkyTexts const& texts) {
    if (texts.reference.empty()) {
        if (!texts.onto.empty()) throw core::Error{"--onto", "", "expected only together with --reference"};
        return;
    }
    if (!(texts.plan.empty() && texts.photo.empty())) throw core::Error{"--reference", "", "expected not together with --plan or --photo"};
    request.samples = static_cast<int>(wholeOption("--reference", texts.reference, 1, kMostSamples));
    if (texts.onto.empty()) return;
    if (request.lapse || !isExr(request.output)) throw core::Error{"--onto", "", "expected one picture, FILE.exr, at -o"};
    request.onto = texts.onto;
}

void readSupersample(SkyRequest& request, SkyTexts const& texts) {
    if (texts.supersample.empty()) return;
    if (!(texts.plan.empty() && texts.reference.empty())) throw core::Error{"--supersample", "", "expected not together with --plan or --reference"};
    request.raysAcross = static_cast<int>(wholeOption("--supersample", texts.supersample, 1, kMostAcross));
}

/// The photographs are read and refused here, before anything is drawn; which one is nearest is seen frame by frame.
void readPhotos(SkyRequest& request, SkyTexts const& texts) {
    if (texts.photo.empty()) {
        if (!texts.beside.empty()) throw core::Error{"--side-by-side", "", "expected only together with --photo"};
        return;
    }
    if (request.plan_km > 0.0) throw core::Error{"--photo", "", "expected not together with --plan"};
    request.photos = assets::findPhotos(texts.photo);
    for (assets::PhotoFile const& photo : request.photos) assets::readImage(photo.file);
    request.beside = texts.beside;
    if (request.beside.empty()) return;
    if (request.beside.extension() != ".png" || request.beside == request.output)
        throw core::Error{"--side-by-side", "", fmt::format("expected FILE.png, another than that of -o, found {}", request.beside.string())};
    core::checkOutputFolder("--side-by-side", request.beside);
}

SkyRequest skyRequest(SkyTexts const& texts) {
    SkyRequest request;
    readView(request, texts);
    readLapse(request, texts);
    if (!texts.exposure.empty())
        request.exposure_ev = static_cast<float>(numberOption("--exposure", texts.exposure, -30.0, 30.0));
    request.output = texts.output;
    if (request.output.empty()) throw core::Error{"-o", "", "expected FILE.png or FILE.exr"};
    if (isFilm(request.output)) {
        if (!request.lapse) throw core::Error{"-o", "", fmt::format("expected --frames with a film, found {}", request.output.string())};
        if (!canFilm()) throw core::Error{"-o", "", fmt::format("expected ffmpeg to be installed for {}", request.output.string())};
    } else if (!isExr(request.output) && request.output.extension() != ".png") {
        throw core::Error{"-o", "",
                          fmt::format("expected FILE.png or FILE.exr, found {}", request.output.string())};
    }
    core::checkOutputFolder("-o", request.output);
    readPlan(request, texts);
    readReference(request, texts);
    readSupersample(request, texts);
    readPhotos(request, texts);
    return request;
}

/// Weather, place and land of a still. The place's altitude is that of the nearest site: ALT_M of --place is
/// the eye.
struct Scene {
    explicit Scene(CommonOptions const& common)
        : field{loadField(weatherSource(common), groundWish(common), common)},
          seed{common.seed.value_or(kUsualSeed)},
          place{field.place()},
          land{seed, place.altitude_m},
          start{startTime(common, field)} {
        double const ground = land.ground(0.0, 0.0).height + kEyeHeight;
        eye = ground;
        if (common.place && common.place->altitude_m) eye = std::max(*common.place->altitude_m, ground);
        if (eye > kHighestEye)
            throw core::Error{"--place", "",
                              fmt::format("expected an eye no higher than {} m, found {}", kHighestEye, eye)};
    }

    static std::optional<weather::PlaceWish> groundWish(CommonOptions const& common) {
        auto wish = placeWish(common);
        if (wish) wish->altitude_m.reset();
        return wish;
    }

    weather::Field field;
    unsigned seed;
    core::Place place;
    terrain::Land land;
    weather::Air air{field, [this](double east, double north) { return land.ground(east, north); }, seed};
    core::UtcSeconds start;
    double eye = 0.0;  // m above sea level
};

glm::dquat orientation(glm::dvec2 const& look_deg) {
    // Azimuth turns clockwise, so against the y axis.
    return glm::angleAxis(-core::radians(look_deg.x), glm::dvec3{0.0, 1.0, 0.0}) *
           glm::angleAxis(core::radians(look_deg.y), glm::dvec3{1.0, 0.0, 0.0});
}

render::Snapshot snapshotOf(SkyRequest const& request, Scene const& scene, CommonOptions const& common,
                            double seconds) {
    render::Snapshot snapshot;
    snapshot.camera.positionWorld = {0.0, scene.eye, 0.0};
    snapshot.camera.worldFromCamera = orientation(request.look);
    snapshot.camera.horizontalFov = core::radians(request.fov_deg);
    snapshot.camera.projection = request.projection;
    snapshot.still = true;
    snapshot.graphics = common.settings.graphics;
    snapshot.clouds = common.settings.flight.clouds;
    render::applyQuality(snapshot.graphics.quality, snapshot.graphics, snapshot.clouds);
    snapshot.graphics.exposure_ev += request.exposure_ev;
    snapshot.graphics.resolution = 1.0f;  // a still has the size that was asked for
    snapshot.time = scene.start + seconds;
    snapshot.simulationSeconds = seconds;
    snapshot.frameSeconds = 0.0;
    snapshot.seed = scene.seed;
    snapshot.place = scene.place;
    core::Place eye = scene.place;
    eye.altitude_m = scene.eye;
    snapshot.sky = sky::skyState(eye, snapshot.time);
    snapshot.field = &scene.field;
    snapshot.weather = scene.field.at(0.0, 0.0, snapshot.time);
    snapshot.air = scene.air.instant(snapshot.time, snapshot.clouds).at(snapshot.camera.positionWorld);
    return snapshot;
}

/// FILE.png, or FILE_0007.png in a time lapse.
fs::path fileOfFrame(SkyRequest const& request, fs::path const& output, long long frame) {
    if (!request.lapse || isFilm(output)) return output;
    fs::path file = output;
    file.replace_filename(fmt::format("{}_{:04}{}", output.stem().string(), frame, output.extension().string()));
    return file;
}

/// Says how alike the colours of the picture and of the photograph nearest in time are, and puts both side by side.
void compareWithPhoto(SkyRequest const& request, assets::Image const& picture, long long frame, core::UtcSeconds time) {
    assets::PhotoFile const& photo = request.photos[assets::nearestPhoto(request.photos, time)];
    assets::Image const image = assets::readImage(photo.file);
    fmt::print("{} and {}, {}: {}\n", fileOfFrame(request, request.output, frame).string(), photo.file.string(), takenText(photo),
               comparisonText(compareColours(picture, image)));
    if (!request.beside.empty()) assets::writePng(fileOfFrame(request, request.beside, frame), sideBySide(picture, image));
}

/// Where a command's pictures go: one file, one for each frame, or a film of them.
class PictureFiles {
public:
    PictureFiles(SkyRequest const& request, glm::ivec2 const& size) : request_{request} {
        if (isFilm(request.output)) film_.emplace(request.output, size.x, size.y);
    }
    /// Whether the frame is wanted scene-linear.
    bool linear() const { return isExr(request_.output); }
    void add(assets::FloatImage const& picture, long long frame, assets::PictureFacts const& facts = {}) const {
        assets::writeExr(fileOfFrame(request_, request_.output, frame), picture, facts);
    }
    void add(assets::Image const& picture, long long frame) {
        if (film_) film_->add(picture);
        else assets::writePng(fileOfFrame(request_, request_.output, frame), picture);
    }
    void finish() {
        if (film_) film_->finish();
    }

private:
    SkyRequest const& request_;
    std::optional<VideoFile> film_;
};

/// A path-traced picture that was kept, to be added to.
render::ReferencePicture keptPicture(fs::path const& file, glm::ivec2 const& size) {
    assets::PictureFacts const facts = assets::readFacts(file);
    assets::FloatImage image = assets::readFloatImage(file);
    double const samples = facts.contains("samples") ? facts.at("samples") : 0.0;
    if (!(samples >= 1.0 && samples <= static_cast<double>(kMostSamples)) || !facts.contains("noise") || image.width != size.x || image.height != size.y || image.channels != 4)
        throw core::Error{file.string(), "", fmt::format("expected a picture of {} x {} that --reference made", size.x, size.y)};
    return {std::move(image), facts.at("noise"), static_cast<int>(samples)};
}

/// Path-traced frames; says how noisy each is.
void traceFrames(SkyRequest const& request, Scene const& scene, CommonOptions const& common) {
    weather::NoiseVolumes const noise = noiseVolumes(common.settings.flight.clouds.noise);
    PictureFiles files{request, common.size};
    std::optional<render::ReferencePicture> kept;
    if (!request.onto.empty()) kept = keptPicture(request.onto, common.size);
    for (long long frame = request.firstFrame; frame <= request.lastFrame; ++frame) {
        render::Snapshot const snapshot = snapshotOf(request, scene, common, static_cast<double>(frame) * request.step);
        auto traced = render::referencePicture(snapshot, common.size, request.samples, noise, toolWorkers(), kept ? kept->samples : 0);
        if (kept) traced = render::together(*kept, traced);
        if (files.linear()) files.add(traced.image, frame, {{"samples", traced.samples}, {"noise", traced.noise}});
        else files.add(render::developed(traced.image, snapshot.graphics.exposure_ev), frame);
        fmt::print("{}: median noise {:.2f} %\n", fileOfFrame(request, request.output, frame).string(), 100.0 * traced.noise);
    }
    files.finish();
}

/// Whether pictures of this size are drawn by tiles: stills alone, for a film is made of whole frames.
bool byTiles(SkyRequest const& request, glm::ivec2 const& size) { return std::max(size.x, size.y) > kLargestWhole && !isFilm(request.output); }

/// The size that the renderer draws whole.
glm::ivec2 wholeSize(SkyRequest const& request, glm::ivec2 size) {
    if (!byTiles(request, size)) return size;
    while (std::max(size.x, size.y) > kLargestMeasured) size = glm::max(size / 2, glm::ivec2{1});
    return size;
}

/// Frames as the game draws them.
void drawFrames(SkyRequest const& request, Scene const& scene, CommonOptions const& common) {
    int const across = request.raysAcross;
    if (across > 1 && std::max(common.size.x, common.size.y) * across > kLargestWhole)
        throw core::Error{"--supersample", "", fmt::format("expected at most {} pixels a side, N times --size, found {} times {}x{}", kLargestWhole, across, common.size.x, common.size.y)};
    glm::ivec2 const whole = wholeSize(request, across * common.size);
    auto const surface = platform::openHeadless(whole);
    gl::prepareContext();
    render::Renderer renderer{{.size = whole}};
    PictureFiles files{request, common.size};
    for (long long frame = request.firstFrame; frame <= request.lastFrame; ++frame) {
        render::Snapshot const snapshot = snapshotOf(request, scene, common, static_cast<double>(frame) * request.step);
        renderer.draw(snapshot);
        if (byTiles(request, common.size)) render::TiledPicture{renderer, snapshot, common.size, fileOfFrame(request, request.output, frame)}.finish();
        else if (files.linear()) files.add(assets::meanOf(renderer.readHdr(), across), frame);
        else files.add(assets::meanOf(renderer.readPixels(), across), frame);
        if (!request.photos.empty())
            compareWithPhoto(request, assets::meanOf(renderer.readPixels(), across), frame, scene.start + static_cast<double>(frame) * request.step);
    }
    files.finish();
}

int runSky(SkyTexts const& texts, CommonOptions const& common) {
    SkyRequest const request = skyRequest(texts);
    Scene const scene{common};
    if (request.plan_km > 0.0) {
        writePlan(scene.field, {request.plan_km * 1000.0, common.size, scene.start, scene.seed, common.settings.flight.clouds}, request.output);
        return 0;
    }
    if (request.samples > 0) {
        traceFrames(request, scene, common);
        return 0;
    }
    drawFrames(request, scene, common);
    return 0;
}
}  // namespace

void addSkyCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    CLI::App* sky = app.add_subcommand(
        "sky", "a still of the sky; ALT_M of --place is the eye (default: 2 m above ground)");
    auto const texts = std::make_shared<SkyTexts>();
    sky->add_option("--look", texts->look, "AZ,EL in degrees: clockwise from north, upward (default 0,10)");
    sky->add_option("--fov", texts->fov, "horizontal field of view, degrees (default 75)");
    sky->add_flag("--panorama", texts->panorama, "the whole sphere, equirectangular, north at the left edge");
    sky->add_flag("--dome", texts->dome, "the upper half, equal area, north up, east left");
    sky->add_option("-o", texts->output, "FILE.png (tone-mapped) or FILE.exr (scene-linear); of a time lapse also FILE.mp4, .mkv, .webm, by ffmpeg");
    sky->add_option("--supersample", texts->supersample, "N, 1..8: draws it N times as large each way; a pixel is the mean, and edges are smooth");
    sky->add_option("--plan", texts->plan, "KM: instead of a picture, the clouds' vertical optical depth over a square, north up");
    sky->add_option("--reference", texts->reference, "SPP: path-traced, with so many paths for each pixel; needs no OpenGL");
    sky->add_option("--onto", texts->onto, "FILE.exr: with --reference, adds its paths to those of a picture of the same sky that it made before");
    sky->add_option("--photo", texts->photo, "FILE or folder: says how alike the colours are (the photograph nearest in time)");
    sky->add_option("--side-by-side", texts->beside, "FILE.png: picture and photograph beside each other, with --photo");
    sky->add_option("--exposure", texts->exposure, "stops brighter than automatic");
    sky->add_option("--frames", texts->frames, "A:B: a time lapse, written to FILE_0000.png and so on, or to a film");
    sky->add_option("--step", texts->step, "seconds between frames (default 60)");
    sky->callback(
        [texts, &common, &chosen] { chosen = [texts, &common] { return runSky(*texts, common); }; });
}
}  // namespace luftpost::app
