// Where things of the HUD stand on the screen: pure functions, pixels with y down, north up on the navigation bar.
#pragma once
#include <optional>

#include <glm/glm.hpp>

#include "game/ui/camera.h"

namespace luftpost::ui {
/// The field of the navigation bar: half its size, the radius of its circle (the accepted distance) and the dot's.
struct NavBarLayout {
    glm::vec2 half_px{150.0f, 46.0f};
    float circle_px = 34.0f;
    float dot_px = 6.5f;
};

/// Offsets are from the bar's centre, where the aircraft is.
struct NavBar {
    glm::vec2 arrow_px{0.0f};           // tip of the velocity's arrow
    glm::vec2 dot_px{0.0f};             // the target
    std::optional<glm::vec2> landing_px;  // where a parcel released now would land
    double distance = 0.0;              // m, over the ground
    std::optional<double> secondsToGo;  // at the present closing speed; none when not closing
    bool within = false;                // closer than the accepted radius
};

/// Way from the centre (px) at which something `distance` metres away is drawn: straight to the circle's edge at the
/// accepted radius, from there a fixed step for each doubling.
float navBarReach(double distance, double radius, NavBarLayout const& layout);
/// The offset of a place `eastNorth` metres away, cut off at the bar's edge along its direction.
glm::vec2 navBarOffset(glm::dvec2 eastNorth, double radius, NavBarLayout const& layout);
/// All of the bar. World frame; `landing` may be absent.
NavBar navBar(glm::dvec3 const& positionWorld, glm::dvec3 const& velocityWorld, glm::dvec3 const& targetWorld, double radius,
              std::optional<glm::dvec3> const& landingWorld, NavBarLayout const& layout);

/// Where a point of the world is seen: pixels from the upper left; none behind the camera. Bent with the Earth, as the
/// picture is.
std::optional<glm::vec2> seenAt(CameraPose const& camera, glm::vec2 size_px, glm::dvec3 const& pointWorld);

/// The marker of a point: on it when it is seen inside the margins, else on their edge with the way to turn.
struct EdgeMarker {
    glm::vec2 at_px{0.0f};
    glm::vec2 outward{0.0f};  // unit, zero when the point itself is seen
};
EdgeMarker edgeMarker(CameraPose const& camera, glm::vec2 size_px, glm::vec2 margin_px, glm::dvec3 const& pointWorld);
/// Which way the wind's arrow points on the screen (x right, y down), of length 1: the nose is up, so that a headwind points
/// down. `windWorld` is where the air goes to and not calm, `heading` rad.
glm::vec2 windArrow(glm::dvec3 const& windWorld, double heading);
}  // namespace luftpost::ui
