// Stall and spin: one wing goes first, autorotation is entered with the pedal and left with the other one.
#include <gtest/gtest.h>

#include <cmath>

#include "game/bot/test_pilot.h"
#include "tests/sim/test_flight.h"

namespace luftpost::flight {
namespace {
/// Mean separation of the wing's strips on one side, 0..1.
double stalled(TestFlight const& flight, double side) {
    auto const& strips = flight.aircraft.airframe().strips;
    double sum = 0.0, area = 0.0;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        if (strips[i].place != StripPlace::wing || strips[i].position.z * side <= 0.0) continue;
        sum += strips[i].area * flight.state().strips[i].separation;
        area += strips[i].area;
    }
    return sum / area;
}
/// Turn about the vertical, rad/s, + to the left as the world's y axis has it.
double spinRate(TestFlight const& flight) { return (flight.state().worldFromBody * flight.state().ratesBody).y; }

/// Power off, the nose slowly up with level wings until they begin to stall, then full pedal to `side` with the stick back.
void enterSpin(TestFlight& flight, double side) {
    flight.inAir(2500.0, fromKnots(60.0));
    bot::TestPilot pilot;
    flight.fly(30.0, [&](double t) {
        pilot.look(flight.state());
        pilot.holdWings();
        pilot.holdSpeed(fromKnots(60.0 - t));
        flight.stick = pilot.stick;
        flight.stick.throttle = 0.0;
        return flight.now().stalled < 0.05;
    });
    flight.stick = Controls{.elevator = 1.0, .aileron = 0.0, .rudder = side};
}
}  // namespace

TEST(Spin, APedalAtTheStallDropsItsOwnWingFirst) {
    for (double side : {1.0, -1.0}) {
        TestFlight flight;
        enterSpin(flight, side);
        flight.fly(2.0);
        EXPECT_GT(stalled(flight, side), stalled(flight, -side) + 0.1) << side;
        EXPECT_GT(side * flight.now().rollRate, 0.2) << side;
    }
}

TEST(Spin, IsHeldByPedalAndStickAndLeftByTheOppositeOfBoth) {
    TestFlight flight;
    enterSpin(flight, -1.0);
    flight.fly(6.0);
    double turned = 0.0, inner = 0.0, outer = 0.0;
    double const from = flight.state().positionWorld.y;
    constexpr double kSeconds = 6.0;
    flight.fly(kSeconds, [&](double) {
        turned += spinRate(flight) * core::kTickSeconds;
        inner += stalled(flight, -1.0) * core::kTickSeconds / kSeconds;
        outer += stalled(flight, 1.0) * core::kTickSeconds / kSeconds;
        return true;
    });
    double const turns = turned / (2.0 * core::kPi), lost = from - flight.state().positionWorld.y;
    fmt::print("| spin, deg/s | {:.0f} |\n| spin, height lost a turn, m | {:.0f} |\n| spin, share stalled, inner and outer wing | {:.2f}, {:.2f} |\n",
               core::degrees(turned / kSeconds), lost / turns, inner, outer);
    EXPECT_GT(core::degrees(turned / kSeconds), 60.0) << "to the left, round and round";
    EXPECT_GT(inner, 0.8) << "stalled, no spiral dive";
    EXPECT_LT(outer, inner - 0.2);
    double const start = flight.state().positionWorld.y;
    double seconds = 0.0;
    flight.fly(8.0, [&](double t) {
        flight.stick = Controls{.elevator = -0.6, .rudder = 1.0};
        seconds = t;
        return std::abs(spinRate(flight)) > 0.3 || flight.now().stalled > 0.2;
    });
    fmt::print("| spin, recovery, s | {:.1f} |\n", seconds);
    EXPECT_LT(seconds, 5.0);
    flight.fly(8.0, [&](double) {  // out of the dive
        flight.stick = Controls{.elevator = std::clamp(0.5 * (1.8 - flight.now().loadFactor), -0.3, 0.35),
                                .aileron = std::clamp(-1.5 * flight.now().roll, -1.0, 1.0)};
        return flight.now().climb < -1.0;
    });
    fmt::print("| spin, recovery, height lost to level, m | {:.0f} |\n", start - flight.state().positionWorld.y);
    EXPECT_LT(start - flight.state().positionWorld.y, 400.0);
    EXPECT_LT(flight.now().stalled, 0.2);
}
}  // namespace luftpost::flight
