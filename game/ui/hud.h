// What the player sees over the picture while flying. Plain SI data in, Dear ImGui draw lists out; nothing here knows
// GL, devices or the simulation. Main thread, between ScreenFrame::begin and end (ui/screen_frame.h).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "engine/core/environment.h"
#include "game/ui/camera.h"

namespace luftpost::ui {
/// The drop zone of the job at hand.
struct HudTarget {
    std::string name;           // shown beside the marker
    glm::dvec3 positionWorld{0.0};  // on the ground
    double radius = 150.0;      // m, accepted distance
};

enum class MessageKind { info, good, bad };

/// One line that fades: "Delivered: 82 points, 27 m from the centre".
struct HudMessage {
    std::string text;
    MessageKind kind = MessageKind::info;
    double age = 0.0;  // s since it appeared; lines older than kMessageSeconds are not drawn
};
inline constexpr double kMessageSeconds = 6.0;

/// A key or button and what it does: {"W", "more thrust"}. The caps come from the device and layout in hand.
struct HudPrompt {
    std::string cap;
    std::string action;
};

/// Where the weather comes from, as the source says it.
struct HudWeather {
    std::string name;      // "Basel, 23 June 2023"
    std::string mode;      // recorded, live, stale, preset
    double age = 0.0;      // s since the report the field uses here
    std::string note{};    // whose data it is, or what is waited for; empty: nothing
};

/// All that one frame of the HUD shows. Frames: world (x east, y up, z south). Angles in radians.
struct HudState {
    double time = 0.0;               // s of simulated time: blinking and fading follow it, never the wall clock
    core::UtcSeconds utc = 0.0;
    bool visible = true;

    glm::dvec3 positionWorld{0.0};
    glm::dvec3 velocityWorld{0.0};   // over the ground
    glm::dvec3 windWorld{0.0};       // where the air goes to
    double indicatedSpeed = 0.0;     // m/s
    double height = 0.0;             // m, of the lowest wheel over the ground
    double heading = 0.0;            // clockwise from true north
    double pitch = 0.0;
    double roll = 0.0;
    double throttle = 0.0;           // 0..1, the lever
    double flaps = 0.0;              // 0..1
    double brakes = 0.0;             // 0..1
    double rpm = 0.0;
    double fuel_kg = 0.0;
    double fuelCapacity_kg = 100.0;
    bool stalled = false;
    bool onGround = false;
    bool paused = false;              // and no page says so already

    std::optional<HudTarget> target;
    bool parcelReady = true;
    /// Where a parcel released now would land, if the game predicts it.
    std::optional<glm::dvec3> predictedLandingWorld;

    int score = 0;
    int deliveries = 0;
    HudWeather weather;
    double clockRate = 1.0;          // how many times as fast the weather's clock runs
    std::vector<HudMessage> messages;
    std::vector<HudPrompt> prompts;  // empty once the first minute is over

    CameraPose camera;               // of this frame, for the drop zone's marker
};

/// Draws the HUD over the whole of ImGui's display. Nothing when `visible` is false.
void drawHud(HudState const& state);
}  // namespace luftpost::ui
