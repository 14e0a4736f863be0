#include "game/app/landing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::app {
namespace {
constexpr double kFlown =
    5.0;  // s in the air before a touch is a landing, and after it before one is off again
constexpr double kAtRest = 1.0;    // m/s
constexpr double kBeside = 150.0;  // m from the runway's edges that still count as the airfield
constexpr double kLoadSeconds = 1.0;
}  // namespace

std::optional<FromAim> distanceFromAim(terrain::Runway const& runway, glm::dvec3 const& placeWorld,
                                       double heading) {
    glm::dvec2 const at = runway.alongAcross(placeWorld.x, -placeWorld.z);
    if (std::abs(at.x) > 0.5 * runway.length + 2.0 * kBeside || std::abs(at.y) > 0.5 * runway.width + kBeside)
        return std::nullopt;
    double const way = core::cos(heading - runway.heading) < 0.0 ? -1.0 : 1.0;
    return FromAim{way * at.x + 0.5 * runway.length - kAimBeyondThreshold, way * at.y};
}

void LandingWatch::touch(flight::AircraftState const& now, terrain::Runway const& runway, double seconds) {
    flight::Readings const& readings = now.readings;
    glm::dvec3 const right{core::cos(readings.heading), 0.0, core::sin(readings.heading)};
    Landing landing;
    landing.t = seconds;
    landing.placeWorld = now.positionWorld;
    landing.touchdownSpeed = now.touchdownSpeed;
    landing.speed = readings.cas;
    landing.drift = glm::dot(now.velocityWorld, right);
    landing.bank = readings.roll, landing.pitch = readings.pitch;
    landing.aim = distanceFromAim(runway, now.positionWorld, readings.heading);
    running_ = landing;
}

std::optional<Landing> LandingWatch::step(flight::AircraftState const& now, terrain::Runway const& runway,
                                          double seconds) {
    bool const onGround = now.readings.onGround;
    double const before = airborne_;
    airborne_ = onGround ? 0.0 : airborne_ + core::kTickSeconds;
    if (onGround && !running_ && before > kFlown) touch(now, runway, seconds);
    if (!running_) return std::nullopt;
    if (onGround && before > 0.2) ++running_->bounces;
    if (seconds == running_->t) running_->bounces = 0;
    if (seconds - running_->t < kLoadSeconds)
        running_->loadFactor = std::max(running_->loadFactor, now.readings.loadFactor);
    bool const rests = onGround && now.readings.groundSpeed<kAtRest, off = airborne_> kFlown;
    if (!rests && !off) return std::nullopt;
    running_->touchAndGo = off;
    running_->endT = seconds;
    return std::exchange(running_, std::nullopt);
}
}  // namespace luftpost::app
