// How fine the picture is.
#pragma once
#include <array>
#include <string_view>
#include <tuple>

#include "engine/core/settings.h"

namespace luftpost::render {
/// `own`: what the settings below say; else a preset decides resolution, triangles, steps, trees and edges.
enum class Quality { own, low, medium, high, ultra };
inline constexpr std::array<std::string_view, 5> kQualityWords{"own", "low", "medium", "high", "ultra"};

struct GraphicsSettings {
    Quality quality = Quality::own;
    int framesPerSecond = 0;      // held by the size of the picture; 0: no such thing
    float resolution = 1.0f;      // of the HDR picture against the window's, per side
    float exposure_ev = 0.0f;     // added to the automatic exposure
    float bloom = 0.04f;          // share of the light that glows
    float fieldOfView_deg = 75.0f;
    int triangles = 300'000;      // budget of the terrain
    int cloudSteps = 96;          // most steps of a ray through the clouds
    bool vegetation = true;
    bool smoothEdges = true;
    bool verticalSync = true;
    bool fullScreen = false;
};

inline constexpr std::tuple graphicsFields{
    core::Field{&GraphicsSettings::quality, "graphics.quality", kQualityWords,
                "A preset for resolution, triangles, cloud steps, trees and edges (ultra: more cloud rays, too); own: what those say"},
    core::Field{&GraphicsSettings::framesPerSecond, "graphics.frames_per_second", 0, 240,
                "Frame rate that is held by drawing the picture smaller, down to two fifths per side; 0: never smaller"},
    core::Field{&GraphicsSettings::resolution, "graphics.resolution", 0.25f, 1.0f, "Size of the drawn picture against the window's, per side"},
    core::Field{&GraphicsSettings::exposure_ev, "graphics.exposure_ev", -4.0f, 4.0f, "Brighter or darker than the automatic exposure, in stops"},
    core::Field{&GraphicsSettings::bloom, "graphics.bloom", 0.0f, 0.3f, "Share of the light that glows around bright things"},
    core::Field{&GraphicsSettings::fieldOfView_deg, "graphics.field_of_view_deg", 40.0f, 110.0f, "Horizontal field of view, degrees"},
    core::Field{&GraphicsSettings::triangles, "graphics.triangles", 50'000, 3'000'000, "Budget of the terrain, triangles a frame"},
    core::Field{&GraphicsSettings::cloudSteps, "graphics.cloud_steps", 32, 256, "Most steps of a ray through the clouds"},
    core::Field{&GraphicsSettings::vegetation, "graphics.vegetation", "Trees and bushes are drawn"},
    core::Field{&GraphicsSettings::smoothEdges, "graphics.smooth_edges", "Edges are smoothed"},
    core::Field{&GraphicsSettings::verticalSync, "graphics.vertical_sync", "Frames wait for the screen"},
    core::Field{&GraphicsSettings::fullScreen, "graphics.full_screen", "The game fills the screen"}};
}  // namespace luftpost::render
