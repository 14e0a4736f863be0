// The path tracer against published results and against itself the other way round. Prints what docs/clouds.md says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/sky/step_cloud.h"
#include "shaders/lib/cloud_light.glsl"

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

// ------------------------------------------------------------------------------------- the game's light in a slab

constexpr double kAsymmetry = 0.85;  // of the forward lobe

/// Radiance of a slab `all` deep along the eye's ray, whose sine against the slab is `rise`: the game's light with the glow that its grid stands
/// for, solved as two streams, summed over the ray. `sun`: sine of its elevation; `cosine`: between the ray and the way to it.
double slabRadiance(double all, double sun, double rise, double cosine, bool fromAbove) {
    auto const s = 1.0f - glsl::meanCosine(static_cast<float>(kAsymmetry));
    double const ahead = static_cast<double>(glsl::glowAhead(static_cast<float>(kAsymmetry)));
    auto const phase = glsl::rayPhase(static_cast<float>(cosine), static_cast<float>(kAsymmetry));
    constexpr int kSteps = 300;
    double const step = all / rise / kSteps, down = fromAbove ? rise : -rise;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        double const along = (i + 0.5) * step, above = fromAbove ? along * rise : all - along * rise;
        double const asked = std::clamp(above + ahead * down, 0.0, all);
        float const glow = glsl::slabGlow(s * static_cast<float>(asked), s * static_cast<float>(all), static_cast<float>(sun));
        sum += std::exp(-along) * step * static_cast<double>(glsl::litByBeam(phase, static_cast<float>(above / sun), glow));
    }
    return sum;
}

/// What leaves a face, over what falls on the slab.
double slabFlux(double all, double sun, bool top) {
    constexpr int kRises = 16, kAzimuths = 16;
    double sum = 0.0;
    for (int i = 0; i < kRises; ++i)
        for (int j = 0; j < kAzimuths; ++j) {
            double const rise = (i + 0.5) / kRises, azimuth = core::kPi * (j + 0.5) / kAzimuths;
            double const cosine = (top ? -rise : rise) * sun + std::sqrt((1.0 - rise * rise) * (1.0 - sun * sun)) * std::cos(azimuth);
            sum += 2.0 * core::kPi * rise / (kRises * kAzimuths) * slabRadiance(all, sun, rise, cosine, top);
        }
    return sum / sun;
}

// Slabs of the game's clouds against photons in the same slab: how much leaves above and, turned at least once, below. Of slabs the
// pictures that the light was fitted to have one, about noon; this tells how far off others are. The figures of docs/clouds.md.
TEST(Reference, SlabsOfTheGameSendOutAboutWhatPhotonsDo) {
    double worst = 0.0, worstLow = 0.0, worstStreams = 0.0;
    for (double const all : {10.0, 30.0, 60.0})
        for (double const sun : {0.9, 0.5, 0.16}) {
            sky::StepCloud cloud;
            cloud.depths = {all};
            cloud.g = static_cast<double>(glsl::meanCosine(static_cast<float>(kAsymmetry)));
            cloud.sunZenith = std::acos(sun);
            auto const photons = sky::photonFluxes(cloud, 400'000, 5, kWorkers);
            float const s = 1.0f - glsl::meanCosine(static_cast<float>(kAsymmetry));
            double const up = slabFlux(all, sun, true) / photons.reflectance[0] - 1.0;
            double const down = slabFlux(all, sun, false) / (photons.transmittance[0] - std::exp(-all / sun)) - 1.0;
            double const streams = 2.0 * core::kPi * static_cast<double>(glsl::slabGlow(0.0f, s * static_cast<float>(all), static_cast<float>(sun))) / sun -
                                   photons.reflectance[0];
            fmt::print("| {:.0f} | {:.0f} | {:.3f} | {:+.0f} % | {:+.0f} % | {:+.3f} |\n", all, core::degrees(std::asin(sun)), photons.reflectance[0],
                       100.0 * up, 100.0 * down, streams);
            (sun < 0.3 ? worstLow : worst) = std::max({sun < 0.3 ? worstLow : worst, std::abs(up), std::abs(down)});
            worstStreams = std::max(worstStreams, std::abs(streams));
        }
    EXPECT_LT(worstStreams, 0.04);
    EXPECT_LT(worst, 0.27);
    EXPECT_LT(worstLow, 0.45);
}
}  // namespace
