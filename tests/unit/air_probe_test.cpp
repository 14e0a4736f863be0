// The probe behind the overlay: it asks few points a frame, averages, and its map moves with the aircraft over a still lattice.
#include <gtest/gtest.h>

#include <cmath>

#include "game/ui/air_overlay.h"

namespace {
using namespace luftpost;

core::GroundFunction const kGround = [](double, double) { return core::GroundSample{.height = 200.0}; };

/// Rises within 400 m of a point, sinks elsewhere; the wind grows with height.
struct Thermal {
    glm::dvec2 middle{500.0, 2200.0};
    int mutable asked = 0;
    core::AirFunction air() const {
        return [this](glm::dvec3 const& p, core::UtcSeconds) {
            ++asked;
            core::AirSample sample;
            sample.windWorld = {0.01 * p.y, glm::length(glm::dvec2{p.x, -p.z} - middle) < 400.0 ? 3.0 : -0.5, 0.0};
            return sample;
        };
    }
};

TEST(AirProbe, AsksFewPointsAFrame) {
    Thermal const thermal;
    core::AirFunction const air = thermal.air();
    ui::AirProbe probe;
    probe.update(air, kGround, {{0.0, 900.0, 0.0}, 0.0}, 0.0);
    for (int i = 0; i < 10; ++i) {
        thermal.asked = 0;
        probe.update(air, kGround, {{0.0, 900.0, 0.0}, 0.0}, 0.1 * i);
        EXPECT_LE(thermal.asked, ui::AirProbe::kAskedPerFrame + 1);
    }
}

TEST(AirProbe, FindsTheThermalAheadAndTheWindByHeight) {
    Thermal const thermal;
    core::AirFunction const air = thermal.air();
    ui::AirProbe probe;
    for (int i = 0; i < 20; ++i) probe.update(air, kGround, {{0.0, 900.0, 0.0}, 0.0}, 0.0);
    std::vector<ui::LiftPoint> const lift = probe.lift();
    EXPECT_EQ(lift.size(), static_cast<std::size_t>(ui::AirProbe::kCells * ui::AirProbe::kCells));
    int rising = 0;
    for (ui::LiftPoint const& point : lift) {
        bool const in = glm::length(point.eastNorth - thermal.middle) < 400.0;
        EXPECT_NEAR(point.up, in ? 3.0 : -0.5, 1e-9);
        rising += in;
    }
    EXPECT_GE(rising, 6);
    ASSERT_EQ(probe.winds().size(), std::size(ui::AirProbe::kHeights));
    for (ui::WindLevel const& level : probe.winds()) {
        EXPECT_NEAR(level.altitude, 200.0 + level.height, 1e-9);
        EXPECT_NEAR(level.wind.x, 0.01 * level.altitude, 1e-9);
    }
}

TEST(AirProbe, ForgetsWhatLiesBehindAndWhatWasAskedAtAnotherHeight) {
    Thermal const thermal;
    core::AirFunction const air = thermal.air();
    ui::AirProbe probe;
    for (int i = 0; i < 20; ++i) probe.update(air, kGround, {{0.0, 900.0, 0.0}, 0.0}, 0.0);
    probe.update(air, kGround, {{0.0, 900.0, -60000.0}, 0.0}, 0.0);
    EXPECT_LE(probe.lift().size(), static_cast<std::size_t>(ui::AirProbe::kAskedPerFrame));
    core::AirFunction const still = [](glm::dvec3 const&, core::UtcSeconds) { return core::AirSample{}; };
    for (int i = 0; i < 20; ++i) probe.update(still, kGround, {{0.0, 2000.0, -60000.0}, 0.0}, 0.0);
    for (ui::LiftPoint const& point : probe.lift()) EXPECT_EQ(point.up, 0.0);
}
}  // namespace
