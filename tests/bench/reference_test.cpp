// The path tracer against published results and against itself the other way round. Prints what docs/clouds.md says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/sky/step_cloud.h"

namespace {
using namespace luftpost;

// I3RC phase 1, case 1: the consensus of many codes for the step cloud (Cahalan et al. 2005, BAMS 86, 1275): sixteen columns of
// optical depth 2 and sixteen of 18, over 0.5 km, 0.25 km thick, g 0.85. Sun overhead, and 60 degrees from the zenith.
constexpr std::array kOverheadReflectance{
    0.27859, 0.26712, 0.25531, 0.24542, 0.23761, 0.23207, 0.22805, 0.22592,
    0.22597, 0.22796, 0.23176, 0.23787, 0.24578, 0.25563, 0.26676, 0.27939,
    0.32332, 0.36758, 0.39589, 0.41544, 0.43034, 0.44028, 0.44675, 0.45022,
    0.44978, 0.44676, 0.44118, 0.43032, 0.41623, 0.39624, 0.36826, 0.32325};
constexpr std::array kOverheadTransmittance{
    0.84654, 0.94825, 1.00490, 1.03590, 1.05390, 1.06380, 1.06970, 1.07060,
    1.07030, 1.06970, 1.06400, 1.05430, 1.03630, 1.00450, 0.94871, 0.84774,
    0.44446, 0.35244, 0.32505, 0.31401, 0.30884, 0.30715, 0.30596, 0.30572,
    0.30614, 0.30642, 0.30683, 0.30907, 0.31385, 0.32537, 0.35255, 0.44375};
constexpr std::array kSlantReflectance{
    0.47539, 0.41897, 0.38630, 0.36448, 0.35161, 0.34484, 0.34277, 0.34333,
    0.34868, 0.35688, 0.36841, 0.38360, 0.40246, 0.42578, 0.45252, 0.48142,
    0.60301, 0.73310, 0.80781, 0.84762, 0.86543, 0.86810, 0.86108, 0.84800,
    0.82989, 0.80827, 0.78668, 0.76355, 0.73663, 0.70607, 0.66515, 0.59637};

constexpr std::int64_t kPhotons = 20'000'000;
constexpr int kWorkers = 2;

sky::StepCloud stepCloud(double sunZenith) {
    sky::StepCloud cloud;
    cloud.depths.assign(32, 18.0);
    std::fill_n(cloud.depths.begin(), 16, 2.0);
    cloud.sunZenith = sunZenith;
    return cloud;
}

template <class A, class B>
double relativeRms(A const& ours, B const& theirs) {
    double squares = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        squares += (ours[i] - theirs[i]) * (ours[i] - theirs[i]);
        sum += theirs[i];
    }
    auto const count = static_cast<double>(theirs.size());
    return std::sqrt(squares / count) / (sum / count);
}

double mean(std::vector<double> const& values) { return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()); }

TEST(Reference, IsTheI3RCConsensusWithTheSunOverhead) {
    auto const fluxes = sky::photonFluxes(stepCloud(0.0), kPhotons, 1, kWorkers);
    double const r = relativeRms(fluxes.reflectance, kOverheadReflectance), t = relativeRms(fluxes.transmittance, kOverheadTransmittance);
    fmt::print("| I3RC case 1, sun overhead: reflectance, transmittance | {:.2f} %, {:.2f} % |\n", 100.0 * r, 100.0 * t);
    EXPECT_LT(r, 0.005);
    EXPECT_LT(t, 0.005);
}

TEST(Reference, IsTheI3RCConsensusWithTheSunAslant) {
    auto const fluxes = sky::photonFluxes(stepCloud(core::kPi / 3.0), kPhotons, 1, kWorkers);
    double const r = relativeRms(fluxes.reflectance, kSlantReflectance);
    fmt::print("| I3RC case 1, sun at 60 degrees: reflectance | {:.2f} % |\n", 100.0 * r);
    EXPECT_LT(r, 0.005);
}

TEST(Reference, IsTheSameBackward) {
    sky::StepCloud cloud = stepCloud(core::kPi / 3.0);
    cloud.g = 0.6;  // at 0.85 the same certainty takes ten times the paths
    auto const forward = sky::photonFluxes(cloud, 4'000'000, 2, kWorkers);
    auto const back = sky::pathFluxes(cloud, 40'000, 3, kWorkers);
    double const r = mean(back.reflectance) / mean(forward.reflectance) - 1.0, t = mean(back.transmittance) / mean(forward.transmittance) - 1.0;
    fmt::print("| the same, backward against forward, mean of the columns: reflectance, transmittance | {:.2f} %, {:.2f} % |\n", 100.0 * r, 100.0 * t);
    EXPECT_LT(std::abs(r), 0.005);
    EXPECT_LT(std::abs(t), 0.005);
}

TEST(Reference, IsInvisibleInAFurnace) {
    sky::StepCloud cloud = stepCloud(0.0);
    cloud.g = 0.6;
    double const radiance = sky::furnaceRadiance(cloud, 1'500'000, 4);
    fmt::print("| white furnace | {:.4f} |\n", radiance);
    EXPECT_NEAR(radiance, 1.0, 0.005);
}
}  // namespace
