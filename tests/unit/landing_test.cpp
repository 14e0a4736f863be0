// A landing is told once, with what was true at the first touch.
#include "game/app/landing.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/core/frames.h"
#include "game/app/report.h"

namespace {
using namespace luftpost;
using namespace luftpost::app;

struct Field {
    terrain::Runway runway{.heading = 0.0, .length = 900.0, .width = 30.0, .altitude = 300.0};
    LandingWatch watch;
    flight::AircraftState state;
    long long tick = 0;
    std::vector<Landing> told;

    /// So many seconds on or over the ground, at a ground speed.
    void pass(double seconds, bool onGround, double speed, double load = 1.0) {
        state.readings.onGround = onGround;
        state.readings.groundSpeed = speed;
        state.readings.loadFactor = load;
        for (int i = 0; i < static_cast<int>(seconds * core::kTicksPerSecond + 0.5); ++i)
            if (auto const landing =
                    watch.step(state, runway, static_cast<double>(tick++) * core::kTickSeconds))
                told.push_back(*landing);
    }
    /// Over the aim, nose north, drifting right.
    void approach() {
        state.positionWorld = core::worldFromEastNorth(4.0, -310.0, 301.0);
        state.velocityWorld = {1.5, -0.9, -30.0};
        state.readings.cas = 31.0;
        state.readings.roll = 0.05;
        state.touchdownSpeed = 0.9;
        pass(8.0, false, 30.0);
    }
};

TEST(Landing, IsToldWhenTheAircraftRests) {
    Field field;
    field.approach();
    field.pass(0.5, true, 29.0, 1.6);
    field.pass(12.0, true, 15.0);
    EXPECT_TRUE(field.told.empty());
    field.pass(5.0, true, 0.2);
    ASSERT_EQ(field.told.size(), 1u);
    Landing const& landing = field.told[0];
    EXPECT_NEAR(landing.t, 8.0, 0.01);
    EXPECT_NEAR(landing.endT, 20.5, 0.01);
    EXPECT_EQ(landing.touchdownSpeed, 0.9);
    EXPECT_EQ(landing.loadFactor, 1.6);
    EXPECT_NEAR(landing.drift, 1.5, 1e-9);
    EXPECT_EQ(landing.bounces, 0);
    EXPECT_FALSE(landing.touchAndGo);
    ASSERT_TRUE(landing.aim);
    EXPECT_NEAR(landing.aim->beyond, 40.0, 1e-6) << "310 m before the middle, the aim is 350 before it";
    EXPECT_NEAR(landing.aim->offLine, 4.0, 1e-6);
}

TEST(Landing, CountsBouncesAndKnowsWhenOneIsOffAgain) {
    Field field;
    field.approach();
    field.pass(0.3, true, 29.0);
    field.pass(1.0, false, 29.0);
    field.pass(0.5, true, 28.0);
    field.pass(6.0, false, 35.0);
    ASSERT_EQ(field.told.size(), 1u);
    EXPECT_EQ(field.told[0].bounces, 1);
    EXPECT_TRUE(field.told[0].touchAndGo);
}

TEST(Landing, IsNotAHopNorOneThatEndedInACrash) {
    Field field;
    field.pass(2.0, true, 20.0);
    field.pass(1.0, false, 25.0);
    field.pass(5.0, true, 0.0);
    EXPECT_TRUE(field.told.empty()) << "a hop on the way to the start";
    field.approach();
    field.pass(0.5, true, 20.0);
    field.watch.forget();
    field.pass(5.0, true, 0.0);
    EXPECT_TRUE(field.told.empty());
}

TEST(Landing, MeasuresFromTheAimOfTheWayOneLands) {
    terrain::Runway const runway{.heading = 0.0, .length = 900.0, .width = 30.0, .altitude = 300.0};
    auto const north = distanceFromAim(runway, core::worldFromEastNorth(5.0, 350.0, 300.0), 0.0);
    auto const south = distanceFromAim(runway, core::worldFromEastNorth(5.0, 350.0, 300.0), core::kPi);
    ASSERT_TRUE(north && south);
    EXPECT_NEAR(north->beyond, 700.0, 1e-6);
    EXPECT_NEAR(south->beyond, 0.0, 1e-6);
    EXPECT_NEAR(south->offLine, -5.0, 1e-6);
    EXPECT_FALSE(distanceFromAim(runway, core::worldFromEastNorth(400.0, 0.0, 300.0), 0.0));
    EXPECT_FALSE(distanceFromAim(runway, core::worldFromEastNorth(0.0, 2000.0, 300.0), 0.0));
}

TEST(Report, KeepsEachLandingWithItsDistancesOrNone) {
    FlightReport report;
    report.landings = {Landing{.t = 12.5,
                               .touchdownSpeed = 0.9,
                               .loadFactor = 1.4,
                               .bank = core::radians(2.0),
                               .aim = FromAim{40.0, -3.0}},
                       Landing{.t = 99.0, .touchAndGo = true, .aim = {}}};
    auto const json = nlohmann::json::parse(reportText(report));
    ASSERT_EQ(json["landings"].size(), 2u);
    EXPECT_EQ(json["landings"][0]["touchdown_mps"], 0.9);
    EXPECT_NEAR(json["landings"][0]["bank_deg"].get<double>(), 2.0, 1e-9);
    EXPECT_EQ(json["landings"][0]["aim"]["beyond_m"], 40.0);
    EXPECT_EQ(json["landings"][0]["aim"]["off_line_m"], -3.0);
    EXPECT_TRUE(json["landings"][1]["aim"].is_null());
    EXPECT_TRUE(json["landings"][1]["touch_and_go"].get<bool>());
}
}  // namespace
