#include "game/ui/hud_geometry.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::ui {
namespace {
constexpr float kStepPerDoubling = 0.59f;  // of the circle's radius
constexpr double kFullArrow = 60.0;        // m/s at which the arrow touches the circle

glm::dvec2 eastNorth(glm::dvec3 const& world) { return {world.x, -world.z}; }

glm::dvec3 inCamera(CameraPose const& camera, glm::dvec3 const& pointWorld) {
    glm::dvec3 away = pointWorld - camera.positionWorld;
    away.y -= (away.x * away.x + away.z * away.z) / (2.0 * core::kEarthRadius);
    return glm::conjugate(camera.worldFromCamera) * away;
}

glm::vec2 project(CameraPose const& camera, glm::vec2 size_px, glm::dvec3 const& p) {
    double const focal = 0.5 * static_cast<double>(size_px.x) / std::tan(0.5 * camera.horizontalFov);
    return 0.5f * size_px + glm::vec2{glm::dvec2{focal * p.x / -p.z, -focal * p.y / -p.z}};
}
}  // namespace

float navBarReach(double distance, double radius, NavBarLayout const& layout) {
    if (distance <= radius) return layout.circle_px * static_cast<float>(distance / radius);
    return layout.circle_px * (1.0f + kStepPerDoubling * static_cast<float>(std::log2(distance / radius)));
}

glm::vec2 navBarOffset(glm::dvec2 away, double radius, NavBarLayout const& layout) {
    double const distance = glm::length(away);
    if (distance < 1e-6) return glm::vec2{0.0f};
    glm::vec2 const way{glm::dvec2{away.x, -away.y} / distance};
    glm::vec2 const limit = (layout.half_px - layout.dot_px) / glm::max(glm::abs(way), glm::vec2{1e-6f});
    return way * std::min({navBarReach(distance, radius, layout), limit.x, limit.y});
}

NavBar navBar(glm::dvec3 const& positionWorld, glm::dvec3 const& velocityWorld, glm::dvec3 const& targetWorld, double radius,
              std::optional<glm::dvec3> const& landingWorld, NavBarLayout const& layout) {
    NavBar bar;
    glm::dvec2 const away = eastNorth(targetWorld - positionWorld), velocity = eastNorth(velocityWorld);
    bar.distance = glm::length(away);
    bar.within = bar.distance <= radius;
    bar.dot_px = navBarOffset(away, radius, layout);
    double const speed = glm::length(velocity);
    if (speed > 0.5)
        bar.arrow_px = glm::vec2{glm::dvec2{velocity.x, -velocity.y} / speed} * layout.circle_px *
                       static_cast<float>(std::min(1.0, 0.25 + 0.75 * speed / kFullArrow));
    if (landingWorld) bar.landing_px = navBarOffset(eastNorth(*landingWorld - positionWorld), radius, layout);
    double const closing = bar.distance > 1.0 ? glm::dot(velocity, away) / bar.distance : speed;
    if (closing > 2.0) bar.secondsToGo = bar.distance / closing;
    return bar;
}

std::optional<glm::vec2> seenAt(CameraPose const& camera, glm::vec2 size_px, glm::dvec3 const& pointWorld) {
    glm::dvec3 const p = inCamera(camera, pointWorld);
    if (p.z > -0.1) return std::nullopt;
    return project(camera, size_px, p);
}

EdgeMarker edgeMarker(CameraPose const& camera, glm::vec2 size_px, glm::vec2 margin_px, glm::dvec3 const& pointWorld) {
    glm::vec2 const middle = 0.5f * size_px, half = middle - margin_px;
    std::optional<glm::vec2> const seen = seenAt(camera, size_px, pointWorld);
    if (seen && std::abs(seen->x - middle.x) <= half.x && std::abs(seen->y - middle.y) <= half.y) return {*seen, glm::vec2{0.0f}};
    glm::dvec3 const p = inCamera(camera, pointWorld);
    glm::vec2 way{glm::dvec2{p.x, -p.y}};
    if (p.z > 0.0) way = {p.x < 0.0 ? -1.0f : 1.0f, 0.3f};  // behind: the side to turn to
    if (glm::length(way) < 1e-4f) way = {0.0f, 1.0f};
    way = glm::normalize(way);
    glm::vec2 const limit = half / glm::max(glm::abs(way), glm::vec2{1e-6f});
    return {middle + way * std::min(limit.x, limit.y), way};
}

glm::vec2 windArrow(glm::dvec3 const& windWorld, double heading) {
    double const ahead = windWorld.x * std::sin(heading) - windWorld.z * std::cos(heading);
    double const right = windWorld.x * std::cos(heading) + windWorld.z * std::sin(heading);
    return glm::vec2{glm::normalize(glm::dvec2{right, -ahead})};
}
}  // namespace luftpost::ui
