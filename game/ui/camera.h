// The cameras: chase, cockpit, wing, hatch, tower, free, parcel. Advanced in simulated time, so that the same flight gives the same pictures
// at any frame rate up to the length of a step.
#pragma once
#include <functional>
#include <optional>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/render/snapshot.h"

namespace luftpost::ui {
using CameraPose = render::Camera;

enum class CameraMode { chase, cockpit, wing, hatch, tower, free, parcel };

/// The aircraft as the picture shows it (interpolated between ticks). Body frame: x forward, y up, z right.
struct CameraSubject {
    glm::dvec3 positionWorld{0.0};  // centre of gravity
    glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 velocityWorld{0.0};
    double loadFactor = 1.0;        // shifts the pilot's head a little
};

/// The player's wish for the free camera (and for looking around in the others), from mouse and keys.
struct CameraInput {
    glm::dvec2 look{0.0};   // radians turned since the last frame: x right, y up
    glm::dvec3 move{0.0};   // -1..1 in the camera's frame: right, up, back
    bool fast = false;
    double zoom = 0.0;      // notches of the wheel, + nearer
    bool looking = false;   // the key that makes the mouse look around is held
};

/// Height of the ground, m above sea level.
using GroundHeight = std::function<double(double east, double north)>;

class Cameras {
public:
    CameraMode mode() const { return mode_; }
    /// The next in the order of CameraMode and round again; the parcel's only while one falls. The free camera starts where
    /// the picture is.
    void next(bool parcelFalls = false);
    void select(CameraMode mode);
    /// Horizontal, radians; chase and free. The cockpit sees a little wider.
    void setFieldOfView(double angle) { fieldOfView_ = angle; }
    /// Stands at once where a long flight in this state would have brought it (start, respawn, replay).
    void reset(CameraSubject const& subject, GroundHeight const& ground);
    /// Moves on by `seconds` of simulated time (0 while paused; the free camera then moves by `wallSeconds`).
    void advance(CameraSubject const& subject, CameraInput const& input, GroundHeight const& ground, double seconds,
                 double wallSeconds);
    /// Never less than kCameraClearance over the ground (the pilot's eye stands where the aircraft has it).
    CameraPose const& pose() const { return pose_; }
    /// Whether the aircraft's own outside hides the view and its cockpit should be drawn instead.
    bool inside() const { return mode_ == CameraMode::cockpit; }
    /// Where the tower of the airfield stands: its eye.
    void setTower(glm::dvec3 const& eyeWorld) { towerWorld_ = eyeWorld; }
    /// A parcel to watch from beside it; nothing changes unless the mode is `parcel`.
    void watchParcel(glm::dvec3 const& positionWorld) { parcelWorld_ = positionWorld; }

private:
    void advanceChase(CameraSubject const& subject, CameraInput const& input, double seconds);
    void advanceCockpit(CameraSubject const& subject, CameraInput const& input, double seconds);
    void advanceFree(CameraInput const& input, double seconds);
    void comeNearer(double notches, double widest);
    void advanceMounted(CameraSubject const& subject, CameraInput const& input, double seconds);
    void advanceTower(CameraSubject const& subject, CameraInput const& input, GroundHeight const& ground);
    void advanceParcel(CameraSubject const& subject, double seconds);
    void keepAboveGround(GroundHeight const& ground);

    CameraMode mode_ = CameraMode::chase;
    CameraPose pose_;
    glm::dvec3 parcelWorld_{0.0};
    glm::dvec3 towerWorld_{0.0};
    std::optional<glm::dvec3> watchPost_;  // tower, far from the airfield: a place beside the way
    glm::dvec3 offsetWorld_{0.0};  // chase: from the aircraft, smoothed
    glm::dvec2 around_{0.0};       // all but free and parcel: the player's look around, radians
    glm::dvec2 freeAngles_{0.0};   // free: azimuth clockwise from north, elevation
    glm::dvec3 freeVelocity_{0.0};
    double distance_ = 1.0;        // chase: factor by the wheel
    double breath_ = 0.0;          // chase: smoothed speed, m/s
    double fieldOfView_ = 1.309;
    double closer_ = 1.0;          // cockpit, wing, hatch, tower: factor of the field of view by the wheel
    double head_ = 0.0;            // smoothed load factor - 1: shifts the pilot's head, and the chase comes nearer
};

inline constexpr double kCameraClearance = 1.5;  // m
/// The pilot's eye in the body frame of assets/models/plane.glb.
inline constexpr glm::dvec3 kPilotEyeBody{0.05, 0.58, -0.27};
}  // namespace luftpost::ui
