// Dust, spray and vapour are there where they belong and nowhere else; the trial of the settings flies what
// is set.
#include "game/app/hangar.h"
#include "game/app/trails.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/platform/paths.h"
#include "game/app/instruments.h"
#include "game/app/response_trial.h"

namespace {
using namespace luftpost;
using namespace luftpost::app;

struct Field {
    flight::Airframe airframe = chosen(loadHangar(), AirframeChoice::mailPlane);
    flight::AircraftState state;
    core::AirSample air;
    core::Surface surface = core::Surface::grass;
    double spread = 8.0;
    Trails trails;

    void roll(double speed) {
        state.readings.onGround = speed > 0.0;
        state.readings.groundSpeed = speed;
        state.velocityWorld = {speed, 0.0, 0.0};
        for (flight::WheelState& wheel : state.wheels) wheel.contact = true;
    }
    std::vector<render::Puff> after(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * 60.0); ++i)
            trails.advance({airframe,
                            state,
                            {},
                            air,
                            [this](double, double) {
                                return core::GroundSample{0.0, {0.0, 1.0, 0.0}, surface};
                            },
                            spread},
                           1.0 / 60.0);
        std::vector<render::Puff> puffs;
        trails.addTo(puffs);
        return puffs;
    }
};

TEST(Trails, RaiseDustOnGrassSprayInRainAndNothingOnADryRunway) {
    Field grass, runway, wet;
    grass.roll(20.0);
    EXPECT_GT(grass.after(2.0).size(), 30u);
    runway.roll(20.0), runway.surface = core::Surface::runway;
    EXPECT_TRUE(runway.after(2.0).empty());
    wet.roll(20.0), wet.surface = core::Surface::runway, wet.air.rain = 3.0;
    auto const spray = wet.after(2.0);
    ASSERT_FALSE(spray.empty());
    EXPECT_GT(spray.front().colour.z, spray.front().colour.x) << "grey, not brown";
    grass.roll(2.0);
    EXPECT_TRUE(grass.after(6.0).empty()) << "slow: it has settled";
}

TEST(Trails, SmokeWhereTheTyresTouchTheRunwayFast) {
    Field field;
    field.surface = core::Surface::runway;
    field.roll(28.0);
    EXPECT_TRUE(field.after(0.5).empty());
    field.state.touchdownTick = 100;
    EXPECT_FALSE(field.after(0.2).empty());
    EXPECT_TRUE(field.after(3.0).empty()) << "once";
}

TEST(Trails, LeaveVapourOffTheTipsInAHardPullThroughMoistAir) {
    Field moist, dry, level;
    for (Field* field : {&moist, &dry, &level})
        field->state.readings.tas = 55.0, field->state.readings.loadFactor = 2.6, field->spread = 0.3;
    dry.spread = 6.0, level.state.readings.loadFactor = 1.0;
    level.spread = 2.0;
    auto const streak = moist.after(0.5);
    ASSERT_GT(streak.size(), 20u);
    EXPECT_GT(std::abs(streak.front().positionWorld.z), 4.0) << "at the tips";
    EXPECT_TRUE(dry.after(0.5).empty());
    EXPECT_TRUE(level.after(0.5).empty());
}

TEST(Trails, StandStillWhilePaused) {
    Field field;
    field.roll(20.0);
    auto const before = field.after(1.0);
    field.trails.advance({field.airframe,
                          field.state,
                          {},
                          field.air,
                          [](double, double) { return core::GroundSample{}; },
                          8.0},
                         0.0);
    std::vector<render::Puff> now;
    field.trails.addTo(now);
    ASSERT_EQ(now.size(), before.size());
    EXPECT_EQ(now.front().positionWorld, before.front().positionWorld);
}

/// The trial flown to its end.
ui::ResponseCurves flown(flight::AssistSettings const& assist) {
    ResponseTrial trial{chosen(loadHangar(), AirframeChoice::mailPlane)};
    for (int i = 0; i < 40; ++i) trial.follow({}, assist, 320);
    return trial.curves();
}
double most(std::vector<ui::ResponsePoint> const& points, double ui::ResponsePoint::*value) {
    double found = 0.0;
    for (ui::ResponsePoint const& p : points) found = std::max(found, std::abs(p.*value));
    return found;
}

TEST(ResponseTrial, ShowsWhatEachParameterDoes) {
    ui::ResponseCurves const usual = flown({});
    ASSERT_FALSE(usual.now.empty());
    EXPECT_EQ(usual.now.size(), usual.usual.size());
    EXPECT_NEAR(most(usual.now, &ui::ResponsePoint::bank), most(usual.usual, &ui::ResponsePoint::bank), 1e-12)
        << "by default they are one";
    EXPECT_GT(core::degrees(most(usual.now, &ui::ResponsePoint::bank)), 30.0);
    ui::ResponseCurves const slow = flown({.rollSpeed_dps = 20.0});
    EXPECT_LT(most(slow.now, &ui::ResponsePoint::bank), 0.6 * most(slow.usual, &ui::ResponsePoint::bank));
    auto const within = [](std::vector<ui::ResponsePoint> points, double from, double to,
                           double ui::ResponsePoint::*value) {
        std::erase_if(points, [&](ui::ResponsePoint const& p) { return p.t < from || p.t > to; });
        return most(points, value);
    };
    ui::ResponseCurves const quick = flown({.pitchSpeed_dps = 45.0}), lazy = flown({.yawSpeed_dps = 5.0});
    EXPECT_GT(within(quick.now, 6.0, 7.2, &ui::ResponsePoint::pitchRate),
              1.2 * within(quick.usual, 6.0, 7.2, &ui::ResponsePoint::pitchRate));
    EXPECT_LT(within(lazy.now, 11.0, 12.6, &ui::ResponsePoint::yawRate),
              0.7 * within(lazy.usual, 11.0, 12.6, &ui::ResponsePoint::yawRate));
    ui::ResponseCurves const held = flown({.stabilizingRoll = 0.0});
    EXPECT_GT(within(held.now, 4.0, 5.5, &ui::ResponsePoint::bank),
              1.5 * within(held.usual, 4.0, 5.5, &ui::ResponsePoint::bank));
}
}  // namespace
