// The autopilot holds a leg in rough air, flies to another altitude and to a point, and lets go when the stick is moved.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/math.h"
#include "engine/flight/autopilot.h"
#include "tests/sim/test_flight.h"

namespace luftpost::flight {
namespace {
struct Leg {
    double heading_deg = 0.0, altitude_m = 0.0, speed_mps = 0.0;  // rms off what was held, after the first half minute
};
/// Three minutes in gusts of `rms` m/s up and down, and across.
Leg held(double rms, std::string const& airframe) {
    TestFlight flight{240.0, 100.0, airframe};
    flight.assist = AssistLevel::normal;
    flight.air = [rms](glm::dvec3 const& p, core::UtcSeconds t) {
        core::AirSample sample = isaAir(p.y);
        double up = 0.0, across = 0.0;
        for (int i = 1; i <= 8; ++i) {
            up += std::sin(0.011 * i * p.z + 0.4 * i * i + 0.07 * t);
            across += std::sin(0.009 * i * p.z + 1.3 * i * i + 0.05 * t);
        }
        sample.windWorld = {0.5 * rms * across, 0.5 * rms * up, 0.0};  // the rms of eight sines is 2
        return sample;
    };
    flight.inAir(800.0, 52.0);
    AutopilotMemory memory = engagedAutopilot(flight.aircraft.airframe(), flight.state());
    AutopilotSettings const settings;
    Leg leg;
    int count = 0;
    flight.fly(180.0, [&](double t) {
        flight.stick = autopilotHands(flight.state(), flight.aircraft.airframe(), settings, glm::dvec2{0.0}, memory);
        if (t < 30.0) return true;
        double const off = std::remainder(flight.now().heading - memory.heading, 2.0 * core::kPi);
        leg.heading_deg += off * off;
        leg.altitude_m += std::pow(flight.state().positionWorld.y - memory.altitude, 2.0);
        leg.speed_mps += std::pow(flight.now().cas - memory.speed, 2.0);
        ++count;
        return true;
    });
    return {core::degrees(std::sqrt(leg.heading_deg / count)), std::sqrt(leg.altitude_m / count), std::sqrt(leg.speed_mps / count)};
}
}  // namespace

TEST(Autopilot, HoldsHeadingAltitudeAndSpeedInModerateTurbulence) {
    for (char const* airframe : {"mail_plane", "freight_plane"}) {
        Leg const leg = held(1.5, airframe);
        fmt::print("| autopilot, {}, gusts of 1.5 m/s rms: heading, altitude, speed, rms | {:.1f} deg, {:.1f} m, {:.1f} m/s |\n",
                   airframe, leg.heading_deg, leg.altitude_m, leg.speed_mps);
        EXPECT_LT(leg.heading_deg, 4.0) << airframe;
        EXPECT_LT(leg.altitude_m, 8.0) << airframe;
        EXPECT_LT(leg.speed_mps, 4.0) << airframe;
    }
}

TEST(Autopilot, ClimbsToItsAltitudeNoFasterThanItIsTold) {
    TestFlight flight{AssistLevel::normal};
    flight.inAir(800.0, 46.0);
    AutopilotMemory memory = engagedAutopilot(flight.aircraft.airframe(), flight.state());
    AutopilotSettings const settings{.altitude_ft = 3280.84, .climb_fpm = 394.0};
    double fastest = 0.0;
    flight.fly(200.0, [&](double) {
        flight.stick = autopilotHands(flight.state(), flight.aircraft.airframe(), settings, glm::dvec2{0.0}, memory);
        fastest = std::max(fastest, flight.now().climb);
        return true;
    });
    EXPECT_NEAR(flight.state().positionWorld.y, 1000.0, 3.0);
    EXPECT_NEAR(fastest, 2.0, 0.5);
    EXPECT_NEAR(flight.now().cas, memory.speed, 1.0);
}

TEST(Autopilot, FliesToThePointInAWindAcross) {
    TestFlight flight{AssistLevel::normal};
    flight.wind = {12.0, 0.0, 0.0};
    flight.inAir(800.0, 52.0);
    AutopilotMemory memory = engagedAutopilot(flight.aircraft.airframe(), flight.state());
    AutopilotSettings const settings{.course = AutopilotCourse::target};
    glm::dvec2 const target{-3000.0, 6000.0};
    double nearest = 1e9;
    flight.fly(240.0, [&](double) {
        flight.stick = autopilotHands(flight.state(), flight.aircraft.airframe(), settings, target, memory);
        glm::dvec3 const p = flight.state().positionWorld;
        nearest = std::min(nearest, std::hypot(p.x - target.x, -p.z - target.y));
        return nearest > 20.0;
    });
    EXPECT_LT(nearest, 25.0);
}

TEST(Autopilot, LetsGoWhenTheStickIsMovedAndNotForAHandLaidOnIt) {
    EXPECT_TRUE(takesOver({.elevator = -0.3}));
    EXPECT_TRUE(takesOver({.aileron = 0.2}));
    EXPECT_TRUE(takesOver({.rudder = -0.5}));
    EXPECT_FALSE(takesOver({.throttle = 1.0, .elevator = 0.1, .aileron = -0.1}));
}
}  // namespace luftpost::flight
