// The cover of every genus over 120 km, asked and measured; prints the table of docs/clouds.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/weather/cloud_depth.h"
#include "engine/weather/cloud_plan.h"
#include "engine/weather/genera.h"
#include "engine/weather/noise_volume.h"
#include "tests/bench/one_layer.h"

namespace {
using namespace luftpost;
using namespace luftpost::weather;

constexpr std::array kCovers{0.0f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 1.0f};
constexpr int kSide = 90;               // points a side
constexpr unsigned kSeeds = 3;

double measured(Genus genus, float cover, double thickness, unsigned seed, NoiseVolumes const& noise) {
    PlanRequest request;
    request.width = 120'000.0;
    request.size = {kSide, kSide};
    request.time = 3600.0 * seed;
    request.seed = seed;
    std::vector<float> const depths = cloudPlan(tests::fieldOfOneLayer(genus, cover, thickness), request, noise, 2);
    auto const covered = std::count_if(depths.begin(), depths.end(), [&](float depth) { return depth > coverDepth(genus); });
    return static_cast<double>(covered) / static_cast<double>(depths.size());
}

TEST(Cover, IsTheReportedOneForEveryGenusThicknessAndSeed) {
    NoiseVolumes const noise = makeNoise(kNoiseSeed, 2);
    double worst = 0.0;
    for (int index = 0; index < kGenera; ++index) {
        auto const genus = static_cast<Genus>(index);
        for (double share : {0.6, 1.4}) {
            double const thickness = std::round(genusRow(genus).thickness * share);
            std::string row = fmt::format("| {} | {} |", genusName(genus), thickness);
            for (float cover : kCovers) {
                double mean = 0.0, error = 0.0;
                for (unsigned seed = 1; seed <= kSeeds; ++seed) {
                    double const got = measured(genus, cover, thickness, seed, noise);
                    mean += got / kSeeds;
                    error = std::max(error, std::abs(got - static_cast<double>(cover)));
                }
                row += fmt::format(" {:.3f} ({:.3f}) |", mean, error);
                bool const exact = cover == 0.0f || cover == 1.0f;
                EXPECT_LE(error, exact ? 0.0 : 0.03) << genusName(genus) << " " << thickness << " m, cover " << cover;
                worst = std::max(worst, error);
            }
            fmt::print("{}\n", row);
        }
    }
    fmt::print("largest error {:.3f}\n", worst);
}
}  // namespace
