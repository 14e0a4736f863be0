// The path tracer where the answer is known without another one; the published cases are in tests/bench.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engine/sky/step_cloud.h"

namespace {
using namespace luftpost;
using sky::StepCloud;
using sky::StepCloudFluxes;

double mean(std::vector<double> const& values) { return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()); }

TEST(StepCloud, ThatOnlyAbsorbsFollowsBeersLaw) {
    StepCloud cloud{{0.5, 0.5, 0.5, 0.5}};
    cloud.albedo = 0.0;
    cloud.sunZenith = core::kPi / 3.0;
    auto const forward = sky::photonFluxes(cloud, 400000, 1, 2);
    auto const back = sky::pathFluxes(cloud, 20000, 1, 2);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(forward.reflectance[i], 0.0);
        EXPECT_NEAR(forward.transmittance[i], std::exp(-1.0), 0.01);
        EXPECT_NEAR(forward.absorptance[i], 1.0 - std::exp(-1.0), 0.01);
        EXPECT_NEAR(back.transmittance[i], std::exp(-1.0), 0.02);
    }
}

TEST(StepCloud, LosesNoLight) {
    StepCloud cloud{{1.0, 8.0, 30.0}};
    cloud.albedo = 0.97;
    cloud.sunZenith = 0.7;
    auto const fluxes = sky::photonFluxes(cloud, 60000, 2, 2);
    EXPECT_NEAR(mean(fluxes.reflectance) + mean(fluxes.transmittance) + mean(fluxes.absorptance), 1.0, 0.002);
    EXPECT_GT(mean(fluxes.absorptance), 0.05);
}

TEST(StepCloud, OfNothingLetsAllThrough) {
    StepCloud const cloud{{0.0, 0.0}};
    auto const fluxes = sky::photonFluxes(cloud, 10000, 2, 2);
    EXPECT_EQ(mean(fluxes.transmittance), 1.0);
    EXPECT_EQ(mean(fluxes.reflectance), 0.0);
}

TEST(StepCloud, IsTheSameWithAnyNumberOfWorkers) {
    StepCloud const cloud{{2.0, 18.0}};
    auto const one = sky::photonFluxes(cloud, 100000, 7, 1), five = sky::photonFluxes(cloud, 100000, 7, 5), other = sky::photonFluxes(cloud, 100000, 8, 1);
    EXPECT_EQ(one.reflectance, five.reflectance);
    EXPECT_EQ(one.transmittance, five.transmittance);
    EXPECT_NE(one.reflectance, other.reflectance);
}

// Light that comes from everywhere alike leaves everywhere alike. Connections to directions drawn evenly make it so only where flights,
// turns and phase function agree.
TEST(StepCloud, IsInvisibleInAFurnace) {
    StepCloud cloud{{2.0, 9.0}};
    cloud.g = 0.4;
    EXPECT_NEAR(sky::furnaceRadiance(cloud, 400000, 3), 1.0, 0.005);
    cloud.g = -0.3;
    EXPECT_NEAR(sky::furnaceRadiance(cloud, 400000, 4), 1.0, 0.005);
}

TEST(StepCloud, IsAsBrightForwardAsBackward) {
    StepCloud cloud{{3.0, 10.0}};
    cloud.g = 0.5;
    cloud.sunZenith = 0.5;
    auto const forward = sky::photonFluxes(cloud, 1000000, 5, 2);
    auto const back = sky::pathFluxes(cloud, 100000, 6, 2);
    EXPECT_NEAR(mean(back.reflectance) / mean(forward.reflectance), 1.0, 0.015);
    EXPECT_NEAR(mean(back.transmittance) / mean(forward.transmittance), 1.0, 0.015);
}
}  // namespace
