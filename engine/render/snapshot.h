// All that one frame shows: plain data, made by the game (or a tool) once a frame. The game knows nothing of passes.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/core/environment.h"
#include "engine/core/frames.h"
#include "engine/render/graphics_settings.h"
#include "engine/sky/sky_state.h"
#include "engine/weather/cloud_settings.h"
#include "engine/weather/weather.h"

struct ImDrawData;

namespace luftpost::assets {
template <class T>
struct ImageOf;
}

namespace luftpost::weather {
class Field;
}

namespace luftpost::render {
/// What the lists name as their texture where the snapshot's photograph shall stand; everything else is letters.
inline char photoMark = 0;
inline void* const kPhotoTexture = &photoMark;

enum class Projection { perspective, panorama, dome };

/// Looks along -z of its own frame, y up. World: x east, y up, z south, metres.
struct Camera {
    glm::dvec3 positionWorld{0.0, 2.0, 0.0};
    glm::dquat worldFromCamera{1.0, 0.0, 0.0, 0.0};
    double horizontalFov = 1.309;  // radians; perspective only
    double near = 0.2;             // m
    Projection projection = Projection::perspective;
};

/// A model that the renderer holds (Renderer::loadModel).
enum class ModelId : int { none = -1 };

/// A node of the model moved from its rest: applied in the node's own frame, before its rest transform.
struct NodePose {
    std::string node;                          // its name in the glTF file
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 translation{0.0f};
    glm::vec3 scale{1.0f};                     // 0 hides the node and its children
};

struct ModelInstance {
    ModelId model = ModelId::none;
    glm::dvec3 positionWorld{0.0};
    glm::dquat worldFromModel{1.0, 0.0, 0.0, 0.0};
    glm::vec3 scale{1.0f};
    glm::vec4 tint{1.0f};                      // multiplies the base colour; alpha below 1 blends
    float emission = 0.0f;                     // added light, in units of the scene's key light (markers)
    bool castsShadow = false;                  // on the ground and on itself
    std::vector<NodePose> poses;
};

/// One soft ball of smoke or dust.
struct Puff {
    glm::dvec3 positionWorld{0.0};
    float radius = 1.0f;                       // m
    glm::vec4 colour{1.0f};                    // albedo, opacity in its middle
};

/// The glass around a camera in the cockpit, on which rain lies.
struct Windscreen {
    glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};  // x ahead, y up, z right
    double airspeed_mps = 0.0;                     // that drives the drops
    glm::vec3 cabin{0.0f};                         // m from the eye: ahead, up or down, and aside; what is nearer stands before the glass
};

/// The debug views (F2, F3).
struct DebugViews {
    bool normals = false;
    bool wireframe = false;
};

struct Snapshot {
    Camera camera;
    bool still = false;                        // every ray, no history: screenshots and tools
    bool dither = true;
    bool drawTerrain = true;
    bool drawClouds = true;
    GraphicsSettings graphics;
    weather::CloudSettings clouds;
    DebugViews debug;

    core::UtcSeconds time = 0.0;               // of the weather's clock
    double simulationSeconds = 0.0;            // what moves waves, trees and flags
    double frameSeconds = 1.0 / 60.0;          // since the previous frame; 0 when paused
    double eyeSeconds = 1.0 / 60.0;            // of the player's time since then: the eye adapts also while the flight stands still
    unsigned seed = 1;
    core::Place place;

    sky::SkyState sky;
    weather::Field const* field = nullptr;     // lives as long as the frame; null: no clouds
    weather::Weather weather;                  // at the camera
    core::AirSample air;                       // at the camera: what blows and falls there

    std::vector<ModelInstance> models;
    std::vector<Puff> puffs;
    glm::dvec3 aircraftWorld{0.0};
    bool hasAircraft = false;
    std::optional<Windscreen> windscreen;      // none: the camera is not behind glass

    ImDrawData const* ui = nullptr;            // lists of the HUD and menus, null: none
    int fontVersion = 0;                       // ui::ScreenFrame::fontVersion()
    assets::ImageOf<std::uint8_t> const* photo = nullptr;  // 4 channels, what kPhotoTexture stands for; null: none
    int photoVersion = 0;                      // another when the photograph is another
};
}  // namespace luftpost::render
