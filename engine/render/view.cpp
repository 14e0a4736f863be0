#include "engine/render/view.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace luftpost::render {
glm::dmat4 clipFromWorld(Camera const& camera, double aspect) {
    double const tangent = std::tan(0.5 * camera.horizontalFov);
    glm::dmat4 clipFromCamera{0.0};
    clipFromCamera[0][0] = 1.0 / tangent;
    clipFromCamera[1][1] = aspect / tangent;
    clipFromCamera[2][3] = -1.0;
    clipFromCamera[3][2] = camera.near;
    return clipFromCamera * glm::mat4_cast(glm::conjugate(camera.worldFromCamera));
}

namespace {
int projectionMode(Projection projection) {
    switch (projection) {
        case Projection::panorama: return glsl::kProjectionPanorama;
        case Projection::dome: return glsl::kProjectionDome;
        default: return glsl::kProjectionPerspective;
    }
}

void describeTime(Snapshot const& snapshot, glsl::FrameBlock& frame) {
    frame.time = glm::vec4{glm::dvec4{std::fmod(snapshot.simulationSeconds, 3600.0), snapshot.frameSeconds,
                                      std::fmod(snapshot.time, 86400.0), snapshot.eyeSeconds}};
    // Waves take minutes to grow: they go by the mean wind over the ground, neither by gusts nor by that of the camera's height.
    glm::vec2 const wind{snapshot.weather.windSurface};
    frame.wind = {wind.x, 0.0f, -wind.y, static_cast<float>(snapshot.weather.gust)};
    bool const snow = snapshot.weather.precipitation == weather::Precipitation::Snow;
    double const rate = snapshot.weather.precipitationRate;
    frame.weather = glm::vec4{static_cast<float>(snapshot.weather.visibility), static_cast<float>(rate), snow ? 1.0f : 0.0f,
                              snow ? 0.0f : static_cast<float>(std::min(1.0, rate / 2.0))};
}
}  // namespace

void describeView(Snapshot const& snapshot, Tile const& tile, std::uint64_t number,
                  std::optional<ViewHistory> const& history, glsl::FrameBlock& frame) {
    Camera const& camera = snapshot.camera;
    glm::dvec2 const picture{tile.picture};
    double const aspect = picture.x / picture.y;
    glm::dmat4 const clip = tileFromPicture(tile) * clipFromWorld(camera, aspect);
    glm::dvec3 const moved = history ? camera.positionWorld - history->positionWorld : glm::dvec3{0.0};
    glm::dmat4 const before = history ? history->clipFromWorld : clip;
    frame.clipFromWorld = glm::mat4{clip};
    frame.worldFromClip = glm::mat4{glm::inverse(clip)};
    frame.previousClipFromWorld = glm::mat4{before * glm::translate(glm::dmat4{1.0}, moved)};
    frame.worldFromCamera = glm::mat4{glm::mat4_cast(camera.worldFromCamera)};
    frame.viewport = glm::vec4{glm::dvec4{tile.size, 1.0 / picture.x, 1.0 / picture.y}};
    frame.tile = glm::vec4{glm::vec2{tile.corner}, 0.0f, 0.0f};
    double const tangent = std::tan(0.5 * camera.horizontalFov);
    frame.projection = glm::vec4{glm::dvec4{tangent, tangent / aspect, camera.near, 2.0 * tangent / picture.x}};
    frame.mode = glm::ivec4{projectionMode(camera.projection),
                            (snapshot.debug.normals ? glsl::kDebugNormals : 0) |
                                (snapshot.debug.wireframe ? glsl::kDebugWireframe : 0),
                            static_cast<int>(number & 0x7fffffff), snapshot.still ? 1 : 0};
    frame.cameraWorld = glm::vec4{glm::vec3{camera.positionWorld}, 0.0f};
    frame.cameraMoved = glm::vec4{glm::vec3{moved}, 0.0f};
    frame.aircraft = glm::vec4{glm::vec3{snapshot.aircraftWorld - camera.positionWorld}, snapshot.hasAircraft ? 1.0f : 0.0f};
    describeTime(snapshot, frame);
}
}  // namespace luftpost::render
