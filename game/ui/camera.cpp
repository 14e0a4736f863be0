#include "game/ui/camera.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::ui {
namespace {
constexpr double kChaseBack = 16.0;    // m behind the centre of gravity at rest
constexpr double kChaseUp = 5.0;     // so high that what lies ahead is seen over the wing
constexpr double kChaseSeconds = 0.28;  // the lag with which it follows a turn
constexpr double kAheadSeconds = 0.9;   // it looks at where the aircraft will be, a little over the nose
constexpr double kCruise = 55.0;        // m/s: the breath's unit

/// A camera that is screwed to the aircraft. Body frame of assets/models/plane.glb.
struct Mount {
    glm::dvec3 eyeBody{0.0}, aimBody{0.0};
    double widening = 1.0;  // of the field of view
};
constexpr Mount kWingMount{{-1.6, 1.5, 5.4}, {1.4, 0.2, 0.0}, 1.1};
constexpr Mount kHatchMount{{-0.4, -0.95, 0.0}, {2.0, -3.2, 0.0}, 1.0};

double follow(double seconds, double lag) { return 1.0 - std::exp(-seconds / lag); }

/// The frame that looks along `ahead` (any length), its top as near to `up` as can be.
glm::dquat lookingAlong(glm::dvec3 const& ahead, glm::dvec3 const& up) {
    glm::dvec3 const back = -glm::normalize(ahead);
    glm::dvec3 right = glm::cross(up, back);
    if (glm::dot(right, right) < 1e-12) right = glm::cross(glm::dvec3{1.0, 0.0, 0.0}, back);
    right = glm::normalize(right);
    return glm::quat_cast(glm::dmat3{right, glm::cross(back, right), back});
}

/// Level heading of the aircraft: its nose, or its flight path when the nose points up or down.
glm::dvec3 levelAhead(CameraSubject const& subject) {
    glm::dvec3 const nose = subject.worldFromBody * glm::dvec3{1.0, 0.0, 0.0};
    glm::dvec3 ahead{nose.x, 0.0, nose.z};
    if (glm::length(ahead) < 0.2) ahead += 0.02 * glm::dvec3{subject.velocityWorld.x, 0.0, subject.velocityWorld.z};
    if (glm::length(ahead) < 1e-6) ahead = {0.0, 0.0, -1.0};
    return glm::normalize(ahead);
}

glm::dvec3 chaseOffset(CameraSubject const& subject, double distance) {
    glm::dvec3 ahead = levelAhead(subject);
    glm::dvec3 const& v = subject.velocityWorld;
    double const speed = glm::length(v);
    if (speed > 5.0) ahead.y = std::clamp(v.y / speed, -0.6, 0.6);
    return distance * (-kChaseBack * glm::normalize(ahead) + glm::dvec3{0.0, kChaseUp, 0.0});
}
}  // namespace

void Cameras::next(bool parcelFalls) {
    int const last = static_cast<int>(parcelFalls ? CameraMode::parcel : CameraMode::free);
    int const next = static_cast<int>(mode_) + 1;
    select(static_cast<CameraMode>(next > last ? 0 : next));
}

void Cameras::select(CameraMode mode) {
    if (mode == CameraMode::free && mode_ != CameraMode::free) {
        glm::dvec3 const ahead = pose_.worldFromCamera * glm::dvec3{0.0, 0.0, -1.0};
        freeAngles_ = {std::atan2(ahead.x, -ahead.z), std::asin(std::clamp(ahead.y, -1.0, 1.0))};
        freeVelocity_ = glm::dvec3{0.0};
    }
    mode_ = mode;
    around_ = glm::dvec2{0.0};
    closer_ = 1.0;
    watchPost_.reset();
}

void Cameras::reset(CameraSubject const& subject, GroundHeight const& ground) {
    breath_ = glm::length(subject.velocityWorld);
    head_ = 0.0;
    around_ = glm::dvec2{0.0};
    offsetWorld_ = chaseOffset(subject, distance_);
    watchPost_.reset();
    if (mode_ == CameraMode::free || mode_ == CameraMode::parcel) mode_ = CameraMode::chase;
    advance(subject, {}, ground, 0.0, 0.0);
}

void Cameras::advance(CameraSubject const& subject, CameraInput const& input, GroundHeight const& ground, double seconds,
                      double wallSeconds) {
    switch (mode_) {
        case CameraMode::chase: advanceChase(subject, input, seconds); break;
        case CameraMode::cockpit: advanceCockpit(subject, input, seconds); break;
        case CameraMode::wing:
        case CameraMode::hatch: advanceMounted(subject, input, seconds); break;
        case CameraMode::tower: advanceTower(subject, input, ground); break;
        case CameraMode::free: advanceFree(input, wallSeconds); break;
        case CameraMode::parcel: advanceParcel(subject, seconds); break;
    }
    keepAboveGround(ground);
}

void Cameras::advanceChase(CameraSubject const& subject, CameraInput const& input, double seconds) {
    distance_ = std::clamp(distance_ * std::exp(-0.12 * input.zoom), 0.6, 6.0);
    around_ = {around_.x + input.look.x, std::clamp(around_.y + input.look.y, -1.2, 1.2)};
    breath_ += (glm::length(subject.velocityWorld) - breath_) * follow(seconds, 0.8);
    head_ += (std::clamp(subject.loadFactor - 1.0, -1.5, 3.0) - head_) * follow(seconds, 0.5);
    offsetWorld_ += (chaseOffset(subject, distance_) - offsetWorld_) * follow(seconds, kChaseSeconds);
    // Faster is farther and wider, so that speed is seen, and a pull draws it nearer; the way to the aircraft keeps its length
    // in turns.
    double const pace = std::clamp(breath_ / kCruise, 0.0, 2.0);
    double const reach = distance_ * std::hypot(kChaseBack, kChaseUp) * (0.86 + 0.16 * pace - 0.035 * head_);
    glm::dquat const turned = glm::angleAxis(-around_.x, glm::dvec3{0.0, 1.0, 0.0});
    glm::dvec3 offset = turned * (reach * glm::normalize(offsetWorld_));
    glm::dvec3 const side = glm::normalize(glm::cross(glm::dvec3{0.0, 1.0, 0.0}, offset));
    offset = glm::angleAxis(-around_.y, side) * offset;
    pose_.positionWorld = subject.positionWorld + offset;
    double const ahead = std::max(0.0, std::cos(around_.x)) * kAheadSeconds * 12.0;
    glm::dvec3 const aim = subject.positionWorld + ahead * levelAhead(subject) + glm::dvec3{0.0, 0.9 * distance_, 0.0};
    glm::dvec3 const bodyUp = subject.worldFromBody * glm::dvec3{0.0, 1.0, 0.0};
    glm::dvec3 const up = glm::normalize(glm::dvec3{0.0, 1.0, 0.0} + 0.16 * bodyUp * (bodyUp.y > 0.0 ? 1.0 : 0.0));
    pose_.worldFromCamera = lookingAlong(aim - pose_.positionWorld, up);
    pose_.horizontalFov = std::min(2.0, fieldOfView_ * (0.95 + 0.07 * pace));
    pose_.near = 0.5;
}

/// Lenses narrow where the wheel would bring a camera that cannot move nearer.
void Cameras::comeNearer(double notches, double widest) { closer_ = std::clamp(closer_ * std::exp(-0.12 * notches), 0.3, widest); }

void Cameras::advanceCockpit(CameraSubject const& subject, CameraInput const& input, double seconds) {
    comeNearer(input.zoom, 1.2);
    around_ = {std::clamp(around_.x + input.look.x, -2.6, 2.6), std::clamp(around_.y + input.look.y, -1.2, 1.2)};
    // The head gives way to the load and comes back.
    head_ += (std::clamp(subject.loadFactor - 1.0, -2.0, 3.0) - head_) * follow(seconds, 0.25);
    glm::dvec3 const eye = kPilotEyeBody - glm::dvec3{0.0, 0.012 * head_, 0.0};
    pose_.positionWorld = subject.positionWorld + subject.worldFromBody * eye;
    glm::dquat const bodyFromAhead =
        lookingAlong(glm::dvec3{1.0, -0.17, 0.0}, glm::dvec3{0.0, 1.0, 0.0});  // a little down: the panel and what lies over it
    pose_.worldFromCamera = glm::normalize(subject.worldFromBody * glm::angleAxis(-around_.x, glm::dvec3{0.0, 1.0, 0.0}) *
                                           bodyFromAhead * glm::angleAxis(around_.y, glm::dvec3{1.0, 0.0, 0.0}));
    pose_.horizontalFov = std::min(2.0, fieldOfView_ * 1.08 * closer_);
    pose_.near = 0.08;
}

void Cameras::advanceMounted(CameraSubject const& subject, CameraInput const& input, double seconds) {
    Mount const& mount = mode_ == CameraMode::wing ? kWingMount : kHatchMount;
    comeNearer(input.zoom, 1.2);
    around_ = {std::clamp(around_.x + input.look.x, -2.6, 2.6), std::clamp(around_.y + input.look.y, -1.2, 1.2)};
    head_ += (std::clamp(subject.loadFactor - 1.0, -2.0, 3.0) - head_) * follow(seconds, 0.15);
    pose_.positionWorld = subject.positionWorld + subject.worldFromBody * mount.eyeBody;
    glm::dquat const bodyFromAhead = lookingAlong(mount.aimBody - mount.eyeBody, glm::dvec3{0.0, 1.0, 0.0});
    pose_.worldFromCamera = glm::normalize(subject.worldFromBody * glm::angleAxis(-around_.x, glm::dvec3{0.0, 1.0, 0.0}) * bodyFromAhead *
                                           glm::angleAxis(around_.y, glm::dvec3{1.0, 0.0, 0.0}));
    pose_.horizontalFov = std::min(2.0, fieldOfView_ * mount.widening * closer_);
    pose_.near = 0.08;
}

/// From the airfield's tower as far as one sees the aircraft from there; farther away from a place beside its way, and from the next
/// one when it has gone by.
void Cameras::advanceTower(CameraSubject const& subject, CameraInput const& input, GroundHeight const& ground) {
    constexpr double kSight = 4000.0, kPast = 450.0, kAhead = 330.0, kAside = 45.0, kEye = 6.0;  // m
    around_ = {around_.x + input.look.x, std::clamp(around_.y + input.look.y, -1.2, 1.2)};
    comeNearer(input.zoom, 4.0);
    pose_.positionWorld = towerWorld_;
    if (glm::distance(towerWorld_, subject.positionWorld) > kSight) {
        if (!watchPost_ || glm::distance(*watchPost_, subject.positionWorld) > kPast) {
            glm::dvec3 const ahead = levelAhead(subject);
            glm::dvec3 post = subject.positionWorld + kAhead * ahead + kAside * glm::cross(ahead, glm::dvec3{0.0, 1.0, 0.0});
            post.y = std::max(ground(post.x, -post.z) + kEye, subject.positionWorld.y + 6.0 * subject.velocityWorld.y - 25.0);
            watchPost_ = post;
        }
        pose_.positionWorld = *watchPost_;
    }
    keepAboveGround(ground);  // before it aims
    glm::dvec3 const away = subject.positionWorld - pose_.positionWorld;
    pose_.worldFromCamera = glm::normalize(glm::angleAxis(-around_.x, glm::dvec3{0.0, 1.0, 0.0}) * lookingAlong(away, glm::dvec3{0.0, 1.0, 0.0}) *
                                           glm::angleAxis(around_.y, glm::dvec3{1.0, 0.0, 0.0}));
    // Binoculars: the aircraft is about an eighth of the picture's width, as far as they magnify.
    double const wanted = 2.0 * std::atan(45.0 / std::max(glm::length(away), 1.0)) * closer_;
    pose_.horizontalFov = std::clamp(wanted, 0.09, fieldOfView_);
    pose_.near = 0.5;
}

void Cameras::advanceFree(CameraInput const& input, double seconds) {
    freeAngles_ = {std::remainder(freeAngles_.x + input.look.x, 2.0 * core::kPi),
                   std::clamp(freeAngles_.y + input.look.y, -1.55, 1.55)};
    double const c = std::cos(freeAngles_.y);
    glm::dvec3 const ahead{c * std::sin(freeAngles_.x), std::sin(freeAngles_.y), -c * std::cos(freeAngles_.x)};
    pose_.worldFromCamera = lookingAlong(ahead, glm::dvec3{0.0, 1.0, 0.0});
    glm::dvec3 const wanted = pose_.worldFromCamera * input.move * (input.fast ? 300.0 : 40.0);
    freeVelocity_ += (wanted - freeVelocity_) * follow(seconds, 0.15);
    pose_.positionWorld += freeVelocity_ * seconds;
    pose_.horizontalFov = fieldOfView_;
    pose_.near = 0.2;
}

void Cameras::advanceParcel(CameraSubject const& subject, double seconds) {
    // Beside the parcel, on the aircraft's side of it, a little below: the canopy stands against the sky.
    glm::dvec3 away = subject.positionWorld - parcelWorld_;
    away.y = 0.0;
    if (glm::length(away) < 1.0) away = levelAhead(subject);
    glm::dvec3 const wanted = 13.0 * glm::normalize(away) + glm::dvec3{0.0, 1.0, 0.0};
    offsetWorld_ += (wanted - offsetWorld_) * follow(seconds, 1.2);
    pose_.positionWorld = parcelWorld_ + offsetWorld_;
    pose_.worldFromCamera = lookingAlong(parcelWorld_ + glm::dvec3{0.0, 2.6, 0.0} - pose_.positionWorld,
                                         glm::dvec3{0.0, 1.0, 0.0});
    pose_.horizontalFov = std::min(fieldOfView_, 1.0);
    pose_.near = 0.3;
}

void Cameras::keepAboveGround(GroundHeight const& ground) {
    if (mode_ == CameraMode::cockpit || mode_ == CameraMode::wing || mode_ == CameraMode::hatch)
        return;  // the aircraft itself stands on the ground
    double const lowest = ground(pose_.positionWorld.x, -pose_.positionWorld.z) + kCameraClearance;
    pose_.positionWorld.y = std::max(pose_.positionWorld.y, lowest);
}
}  // namespace luftpost::ui
