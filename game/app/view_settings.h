// How the player looks at the flight.
#pragma once
#include <array>
#include <tuple>

#include "engine/core/settings.h"
#include "game/ui/camera.h"

namespace luftpost::app {
inline constexpr std::array<std::string_view, 7> kCameraWords{"chase", "cockpit", "wing", "hatch", "tower", "free", "parcel"};

struct ViewSettings {
    ui::CameraMode camera = ui::CameraMode::chase;
};
inline constexpr std::tuple viewFields{
    core::Field{&ViewSettings::camera, "view.camera", kCameraWords, "The camera that a flight starts with"}};
}  // namespace luftpost::app
