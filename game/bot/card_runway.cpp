// The cards on the runway: take-off, landing, landing across the wind.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "game/bot/cards.h"

namespace luftpost::bot {
namespace {
constexpr double kTick = core::kTickSeconds;
constexpr double kFoot = core::kMetresPerFoot;
constexpr double kObstacle = 50.0 * kFoot;  // m
constexpr double kRotate = 1.0;             // stalls with the flaps as they are
constexpr double kFlareSeconds = 2.3;       // of the sink that there is, above the ground

glm::dvec2 direction(double heading) { return {core::sin(heading), core::cos(heading)}; }
double dot(glm::dvec2 a, glm::dvec2 b) { return a.x * b.x + a.y * b.y; }
glm::dvec2 right(glm::dvec2 along) { return {along.y, -along.x}; }
glm::dvec2 eastNorth(glm::dvec3 const& world) { return {world.x, -world.z}; }
}  // namespace

double Card::along() const {
    return dot(eastNorth(pilot_.state().positionWorld) - ground_.thresholdEastNorth, direction(ground_.heading));
}
double Card::across() const {
    return dot(eastNorth(pilot_.state().positionWorld) - ground_.thresholdEastNorth,
               right(direction(ground_.heading)));
}
double Card::drift() const {
    return dot(eastNorth(pilot_.state().velocityWorld), right(direction(ground_.heading)));
}

Manoeuvre Card::takeOff() {
    double const from = along();
    double roll = 0.0, off = 0.0;
    pilot_.stick.throttle = 1.0;
    pilot_.stick.flaps = takeoffFlaps_;
    for (double t = 0.0; t < 60.0 && now().height < kObstacle; t += kTick, co_await nextTick()) {
        pilot_.steerAlong(ground_.heading, across());
        if (now().cas > kRotate * takeoffStall_) pilot_.holdPitch(0.17);
        off = std::max(off, std::abs(across()));
        if (roll == 0.0 && now().height > 0.3) roll = along() - from;
    }
    if (now().height < kObstacle) co_return;
    put("takeoff_roll_ft", roll / kFoot);
    put("takeoff_over_50_ft", (along() - from) / kFoot);
    put("takeoff_off_m", off);
    for (; now().height < 150.0; co_await nextTick()) {  // up to where one may circle
        pilot_.holdPitch(0.12);
        pilot_.holdHeading(ground_.heading);
        if (now().height > 60.0) pilot_.stick.flaps = 0.0;
    }
}

/// Power off, full flap, wing low into the wind; a flare, and the brakes.
Manoeuvre Card::landing() {
    double overObstacle = 0.0, wind = 0.0;
    bool flares = false;
    pilot_.stick.throttle = 0.0;
    pilot_.stick.flaps = 1.0;
    while (pilot_.state().touchdownTick < 0) {
        pilot_.slipAlong(ground_.heading, across(), drift(), windAcross());
        flares = flares || now().height < -kFlareSeconds * now().climb;
        if (!flares) {
            pilot_.holdSpeed(stalls(1.235));
        } else {
            pilot_.holdPath((-0.2 - 0.3 * now().height) / now().tas);
        }
        if (overObstacle == 0.0 && now().height < kObstacle) {
            overObstacle = along();
            wind = windAcross();
        }
        co_await nextTick();
    }
    double const touched = along(), speed = pilot_.state().touchdownSpeed;
    double off = 0.0;
    pilot_.stick.brakes = 0.5;
    while (now().groundSpeed > 1.0) {
        pilot_.steerAlong(ground_.heading, across());
        pilot_.stick.aileron = std::clamp(wind / fromKnots(15.0) - 1.5 * now().roll, -1.0, 1.0);
        pilot_.stick.elevator = 0.3;
        off = std::max(off, std::abs(across()));
        co_await nextTick();
    }
    put("landing_roll_ft", (along() - touched) / kFoot);
    put("landing_over_50_ft", (along() - overObstacle) / kFoot);
    put("touchdown_mps", speed);
    put("landing_off_m", off);
    put("wind_across_kt", knots(wind));
    put("landing_from_threshold_m", touched);
}
}  // namespace luftpost::bot
