#include "game/bot/courier.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "game/delivery/parcel.h"

namespace luftpost::bot {
namespace {
constexpr double kDropHeight = 160.0;     // m above the zone
constexpr double kClearance = 120.0;      // m above everything on the way
constexpr double kLookAhead = 4000.0;     // m
constexpr double kSteepestClimb = 0.055;  // path slope the loaded aircraft keeps up
constexpr double kCruise = 1.753;         // stalls, indicated
constexpr double kSlowest = 1.258;        // stalls, below which the nose goes down
constexpr double kTurnBack = 1100.0;      // m from the zone before another run
constexpr double kSteepestBank = 0.62;    // rad
constexpr double kGoodRelease = 25.0;     // m from the centre
constexpr double kFairRelease = 90.0;     // m, taken where the run will get no better

double dot(glm::dvec2 a, glm::dvec2 b) { return a.x * b.x + a.y * b.y; }
double length(glm::dvec2 v) { return std::sqrt(dot(v, v)); }
glm::dvec2 unit(glm::dvec2 v) { return length(v) > 1.0e-6 ? v / length(v) : glm::dvec2{0.0, 1.0}; }
glm::dvec2 eastNorth(glm::dvec3 const& world) { return {world.x, -world.z}; }
/// Turned clockwise, as a heading grows.
glm::dvec2 turned(glm::dvec2 v, double angle) {
    double const c = core::cos(angle), s = core::sin(angle);
    return {v.x * c + v.y * s, v.y * c - v.x * s};
}
/// From course `a` to course `b`, -pi..pi, clockwise positive.
double turnBetween(glm::dvec2 a, glm::dvec2 b) { return core::atan2(b.x * a.y - b.y * a.x, dot(a, b)); }
double speedOverGround(ui::HudState const& hud) {
    return std::max(length(eastNorth(hud.velocityWorld)), 5.0);
}

/// Where a parcel released now would land, from the fall and the wind that the HUD shows.
glm::dvec2 predictedLanding(ui::HudState const& hud) {
    delivery::Parcel const parcel{hud.positionWorld, hud.velocityWorld, 0.0, 0.0};
    core::AirSample air;
    air.windWorld = {hud.windWorld.x, 0.0, hud.windWorld.z};
    return eastNorth(delivery::predictedLanding(parcel, {}, air, hud.target->positionWorld.y).positionWorld);
}
}  // namespace

Courier::Courier(core::GroundFunction ground, double stallSpeed)
    : ground_{std::move(ground)}, cruise_{kCruise * stallSpeed}, slowest_{kSlowest * stallSpeed} {}

ui::InputSample Courier::decide(ui::HudState const& hud) {
    Aim const wanted = aim(hud);
    ui::InputSample sample;
    sample.direct = fly(hud, wanted);
    sample.hold(ui::FlightKey::drop, wanted.release);
    return sample;
}

Courier::Aim Courier::aim(ui::HudState const& hud) {
    glm::dvec2 const here = eastNorth(hud.positionWorld), target = eastNorth(hud.target->positionWorld);
    glm::dvec2 const track = unit(eastNorth(hud.velocityWorld));
    glm::dvec2 const miss = target - predictedLanding(hud);
    bool const passing = dot(miss, track) < 0.0;
    Aim aim{.courseEastNorth = unit(miss),
            .altitude = hud.target->positionWorld.y + kDropHeight,
            .release = false};
    double const height = hud.positionWorld.y - hud.target->positionWorld.y;
    bool const good = length(miss) < kGoodRelease || (passing && length(miss) < kFairRelease);
    aim.release = hud.parcelReady && good && height > 60.0 && height < 500.0;
    if (passing && !outbound_ && length(miss) < kTurnBack * 0.5 && !aim.release) {
        outbound_ = true;
        outboundCourse_ = track;
    }
    if (outbound_ && length(target - here) > kTurnBack) outbound_ = false;
    if (outbound_) aim.courseEastNorth = outboundCourse_;
    aim.courseEastNorth = clearCourse(hud, aim.courseEastNorth);
    double const slope = steepestAhead(hud, track);
    double const needed = hud.positionWorld.y + slope * 1000.0;  // enough to pass with the clearance
    if (slope > -0.02) aim.altitude = std::max(aim.altitude, needed);
    return aim;
}

/// The steepest path slope that keeps the clearance over the ground ahead along `course`.
double Courier::steepestAhead(ui::HudState const& hud, glm::dvec2 course) const {
    glm::dvec2 const here = eastNorth(hud.positionWorld);
    double steepest = -1.0;
    for (double distance = 60.0; distance <= kLookAhead; distance *= 1.25) {
        double highest = -1.0e4;
        for (double const side : {-0.2, 0.0, 0.2}) {
            glm::dvec2 const point = here + turned(course, side) * distance;
            highest = std::max(highest, ground_(point.x, point.y).height);
        }
        double const margin = kClearance * std::min(1.0, 0.4 + distance / 1000.0);
        steepest = std::max(steepest, (highest + margin - hud.positionWorld.y) / distance);
    }
    return steepest;
}

/// The wanted course, or the nearest to it over ground that one can climb over; one side is kept until it is
/// clear.
glm::dvec2 Courier::clearCourse(ui::HudState const& hud, glm::dvec2 wanted) {
    if (steepestAhead(hud, wanted) < kSteepestClimb) {
        evading_ = 0;
        return wanted;
    }
    for (double angle = 0.25; angle < core::kPi; angle += 0.25)
        for (int const side : {evading_ == 0 ? 1 : evading_, evading_ == 0 ? -1 : evading_}) {
            glm::dvec2 const course = turned(wanted, side * angle);
            if (steepestAhead(hud, course) >= kSteepestClimb) continue;
            evading_ = side;
            return course;
        }
    return turned(unit(eastNorth(hud.velocityWorld)), evading_ < 0 ? -1.0 : 1.0);  // climbs in a circle
}

ui::DirectStick Courier::fly(ui::HudState const& hud, Aim const& aim) const {
    double const turn = turnBetween(unit(eastNorth(hud.velocityWorld)), aim.courseEastNorth);
    double const bank = std::clamp(1.1 * turn, -kSteepestBank, kSteepestBank);
    double const speed = std::max(speedOverGround(hud), 20.0);
    double const climb = std::clamp(0.16 * (aim.altitude - hud.positionWorld.y), -4.0, 4.0);
    // Speed comes first: too slow, and the nose goes down whatever the altitude.
    double const affordable = std::clamp((hud.indicatedSpeed - slowest_) * 0.8, -3.0, 6.0);
    double const slope = (std::min(climb, affordable) - hud.velocityWorld.y) / speed;
    ui::DirectStick stick;
    stick.throttle = std::clamp(0.62 + 0.06 * (cruise_ - hud.indicatedSpeed) + 0.09 * climb, 0.0, 1.0);
    stick.elevator = std::clamp(2.4 * slope, -0.5, 0.5);
    stick.aileron = std::clamp(1.6 * (bank - hud.roll), -1.0, 1.0);
    return stick;
}
}  // namespace luftpost::bot
