// From the state of the flight to what one frame shows. Plain data; no GL.
#pragma once
#include "engine/render/renderer.h"
#include "engine/render/snapshot.h"
#include "game/app/settings.h"
#include "game/app/simulation.h"
#include "game/ui/camera.h"

namespace luftpost::app {
/// The models of the game in the renderer.
struct GameModels {
    explicit GameModels(render::Renderer& renderer);
    std::array<render::ModelId, kAirframeModels.size()> planes;  // by AirframeChoice
    render::ModelId parcel, parachute, windsock, hangar, dropZone;
};

/// The aircraft as this frame shows it: `share` of the way from the tick before to the tick now.
flight::AircraftPose shownPose(Simulation const& simulation, double share);
ui::CameraSubject cameraSubject(Simulation const& simulation, flight::AircraftPose const& pose);
/// The parcel in the air as this frame shows it.
std::optional<delivery::Parcel> shownParcel(Simulation const& simulation, double share);

/// What of a frame does not come from the simulation.
struct FrameView {
    ui::CameraPose camera;
    bool inside = false;   // from the seat: the aircraft's outside is hidden
    double share = 1.0;    // between the last two ticks
    double seconds = 0.0;  // of simulated time since the frame before
    double eyeSeconds = 0.0;     // of the player's time since then
    core::UtcSeconds utc = 0.0;  // the hour whose sky and weather are shown
};
render::Snapshot snapshotOf(Simulation const& simulation, GameModels const& models, Settings const& settings,
                            FrameView const& view);
}  // namespace luftpost::app
