// Phase functions: normalised, drawn as often as they say, and those of the shaders.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/sky/phase.h"
#include "shaders/lib/atmosphere.glsl"
#include "shaders/lib/cloud_light.glsl"

namespace {
using namespace luftpost;
using sky::Phase;

struct Named {
    char const* name;
    Phase phase;
};
std::array<Named, 6> phases() {
    return {{{"isotropic", Phase::henyeyGreenstein(0.0f)}, {"HG 0.85", Phase::henyeyGreenstein(0.85f)}, {"HG -0.4", Phase::henyeyGreenstein(-0.4f)},
             {"droplets", Phase::cloud(0.91f)}, {"molecules", Phase::rayleigh()}, {"haze", Phase::haze()}}};
}

/// The integral over the sphere of phase * weight(cosine); finest forward, where lobes are narrow.
template <class Weight>
double integral(Phase const& phase, Weight const& weight) {
    int const n = 20000;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        double const angle = core::kPi * (i + 0.5) / n;
        sum += 2.0 * core::kPi * std::sin(angle) * core::kPi / n * static_cast<double>(phase.at(static_cast<float>(std::cos(angle)))) * weight(std::cos(angle));
    }
    return sum;
}

TEST(Phase, IntegratesToOne) {
    for (auto const& [name, phase] : phases()) EXPECT_NEAR(integral(phase, [](double) { return 1.0; }), 1.0, 1e-3) << name;
}

TEST(Phase, IsDrawnAsOftenAsItSays) {
    core::Random random{3};
    int const draws = 400000;
    for (auto const& [name, phase] : phases()) {
        double sum = 0.0;
        int forward = 0, back = 0;
        for (int i = 0; i < draws; ++i) {
            double const cosine = phase.draw(random);
            ASSERT_LE(std::abs(cosine), 1.0);
            sum += cosine;
            forward += cosine > 0.95;
            back += cosine < -0.3;
        }
        double const within = 4.0 / std::sqrt(draws);  // four sigma of what varies by one at most
        EXPECT_NEAR(sum / draws, integral(phase, [](double c) { return c; }), within) << name;
        EXPECT_NEAR(forward / double{draws}, integral(phase, [](double c) { return c > 0.95 ? 1.0 : 0.0; }), within) << name;
        EXPECT_NEAR(back / double{draws}, integral(phase, [](double c) { return c < -0.3 ? 1.0 : 0.0; }), within) << name;
    }
}

TEST(Phase, IsTheOneOfTheShaders) {
    for (int i = -100; i <= 100; ++i) {
        float const cosine = static_cast<float>(i) / 100.0f;
        EXPECT_NEAR(Phase::cloud(0.8f).at(cosine), glsl::cloudPhase(cosine, 0.8f), 1e-5f);
        EXPECT_NEAR(Phase::haze().at(cosine) / glsl::hazePhase(cosine), 1.0f, 1e-4f);
        EXPECT_EQ(Phase::rayleigh().at(cosine), glsl::rayleighPhase(cosine));
    }
}

TEST(Phase, TurnsByTheCosineAllAround) {
    core::Random random{5};
    for (glm::dvec3 const& from : {glm::dvec3{0.0, 1.0, 0.0}, glm::dvec3{0.0, 0.0, -1.0}, glm::normalize(glm::dvec3{0.3, -0.4, -0.9})}) {
        glm::dvec3 mean{0.0};
        for (int i = 0; i < 10000; ++i) {
            glm::dvec3 const to = sky::turned(from, 0.6, random);
            ASSERT_NEAR(glm::length(to), 1.0, 1e-9);
            ASSERT_NEAR(glm::dot(from, to), 0.6, 1e-9);
            mean += to / 10000.0;
        }
        EXPECT_NEAR(glm::distance(mean, 0.6 * from), 0.0, 0.03);
    }
}
}  // namespace
