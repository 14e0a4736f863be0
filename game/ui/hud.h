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

/// Calibrated airspeeds that the tape marks, m/s.
struct HudMarks {
    double stall = 26.0, stallFlaps = 23.0, flapLimit = 44.0, cruiseLimit = 66.0, neverExceed = 84.0;
};

/// How one came down, from flight to rest or off again.
struct HudLanding {
    double touchdownSpeed = 0.0;  // m/s across the ground, of the first touch
    double speed = 0.0;           // m/s calibrated, there
    double loadFactor = 1.0;      // the highest within the second after it
    double drift = 0.0;           // m/s across the nose's heading over the ground, + to the right
    double bank = 0.0;            // rad, + right wing down
    int bounces = 0;
    bool touchAndGo = false;
    bool onAirfield = false;      // the two below hold
    double beyondAim = 0.0;       // m along the runway beyond the aiming point, - before it
    double offLine = 0.0;         // m right of the centre line as one lands
    double age = 0.0;             // s since it was over
};
inline constexpr double kLandingSeconds = 12.0;

/// How much of the HUD is shown: all; speed, height, levers, navigation; or only what one cannot do without.
enum class HudDensity { full, reduced, minimal };

/// All that one frame of the HUD shows. Frames: world (x east, y up, z south). Angles in radians.
struct HudState {
    double time = 0.0;               // s of simulated time: blinking and fading follow it, never the wall clock
    core::UtcSeconds utc = 0.0;
    bool visible = true;
    HudDensity density = HudDensity::full;

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
    std::optional<double> fuelSeconds;  // how long it lasts as it flows now; none while none flows
    HudMarks marks;
    double alpha = 0.0;               // rad, of the body's x axis
    double stallMargin = 0.25;        // rad more until the first strip of the wing stalls
    double loadFactor = 1.0;          // along body up
    double sideLoad = 0.0;            // along body right, in g
    double turnRate = 0.0;            // rad/s, nose right
    double elevatorTrim = 0.0, rudderTrim = 0.0;  // -1..1, of the wheels
    bool trimActs = false;            // the assist leaves them to the pilot
    std::optional<glm::vec2> mouseStick;  // where the mouse holds the stick: + right, + pulled
    std::optional<HudLanding> landing;
    bool inside = false;              // seen from the seat: the panel shows what flies the aircraft, and must stay free
    bool stuck = false;               // it will not fly on from here
    std::string respawnCap;           // the key that helps then
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
