// Rainbow, cloud bow, glory, halo and sun dogs stand where they stand in nature: angles measured in the phase functions themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/core/frames.h"
#include "engine/sky/particle_phase.h"
#include "engine/sky/spectrum.h"
#include "shaders/lib/sky_optics.glsl"

namespace {
using namespace luftpost;
using sky::PhaseTable;

PhaseTable const& rain() {
    static PhaseTable const table = sky::rainPhase();
    return table;
}
PhaseTable const& ice() {
    static PhaseTable const table = sky::icePhase();
    return table;
}
PhaseTable const& droplets() {
    static PhaseTable const table = sky::dropletPhase(9e-6);
    return table;
}

double at(PhaseTable const& table, double degrees, int channel = 1) {
    return static_cast<double>(table[static_cast<std::size_t>(std::lround(degrees * 10.0))][channel]);
}

/// Degrees of scattering where a channel is greatest between two angles.
double peak(PhaseTable const& table, double low, double high, int channel) {
    double best = low;
    for (double a = low; a <= high; a += 0.1)
        if (at(table, a, channel) > at(table, best, channel)) best = a;
    return best;
}

double integral(PhaseTable const& table, int channel) {
    double sum = 0.0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        double const angle = 0.1 * static_cast<double>(i), low = std::max(angle - 0.05, 0.0), high = std::min(angle + 0.05, 180.0);
        sum += static_cast<double>(table[i][channel]) * 2.0 * core::kPi * (std::cos(core::radians(low)) - std::cos(core::radians(high)));
    }
    return sum;
}

/// The table as the pass samples it, rows of rain, droplets, ice.
struct Rows {
    std::vector<glm::vec4> texels;
    Rows() {
        for (PhaseTable const* table : {&rain(), &droplets(), &ice()}) texels.insert(texels.end(), table->begin(), table->end());
    }
    glsl::sampler2D sampler() const { return {texels.data(), sky::kPhaseAngles, 3}; }
};
}  // namespace

TEST(Spectrum, WaterAndIceHaveTheirIndicesAndWhiteIsWhite) {
    EXPECT_NEAR(sky::waterIndex(589.0), 1.3330, 2e-4);
    EXPECT_NEAR(sky::waterIndex(404.7), 1.3427, 5e-4);
    EXPECT_NEAR(sky::iceIndex(550.0), 1.3110, 3e-4);
    EXPECT_NEAR(sky::iceIndex(400.0), 1.3194, 3e-4);
    glm::dvec3 sum{0.0};
    for (int i = 0; i < sky::kWavelengths; ++i) sum += sky::spectralColour(i);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1.0, 1e-9);
}

TEST(Phase, IntegratesToOne) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(integral(rain(), c), 1.0, 0.01);
        EXPECT_NEAR(integral(ice(), c), 1.0, 0.01);
    }
}

TEST(Rainbow, StandsAt42DegreesRedOutsideAndTheSecondAt51RedInside) {
    // From the point opposite the sun: 180 degrees less the scattering angle.
    double const red = 180.0 - peak(rain(), 135.0, 145.0, 0), green = 180.0 - peak(rain(), 135.0, 145.0, 1), blue = 180.0 - peak(rain(), 135.0, 145.0, 2);
    EXPECT_NEAR(red, 42.2, 0.5);
    EXPECT_NEAR(blue, 40.7, 0.7);
    EXPECT_GT(red, green);
    EXPECT_GT(green, blue);
    double const secondRed = 180.0 - peak(rain(), 124.0, 132.0, 0), secondBlue = 180.0 - peak(rain(), 124.0, 132.0, 2);
    EXPECT_NEAR(secondRed, 50.6, 0.6);
    EXPECT_NEAR(secondBlue, 53.3, 0.9);
    for (int c = 0; c < 3; ++c) {
        EXPECT_LT(at(rain(), 133.0, c), 0.35 * at(rain(), 145.0, c)) << "Alexander's band is darker than what lies inside the bow";
        EXPECT_LT(at(rain(), 133.0, c), 0.6 * at(rain(), 126.0, c)) << "and than what lies outside the second";
        EXPECT_GT(at(rain(), peak(rain(), 135.0, 145.0, c), c), 2.0 * at(rain(), peak(rain(), 122.0, 132.0, c), c)) << "the second is weaker";
    }
}

TEST(Rainbow, IsAddedWhereItStandsAndNowhereElse) {
    Rows const rows;
    glm::vec2 const size{sky::kPhaseAngles, 3};
    auto const excess = [&](double degrees) { return glsl::bowExcess(rows.sampler(), size, static_cast<float>(std::cos(core::radians(180.0 - degrees)))); };
    EXPECT_EQ(excess(75.0), glm::vec3{0.0f});
    EXPECT_LT(excess(47.0).y, 0.002f) << "the dark band";
    EXPECT_GT(excess(42.0).x, 10.0f * std::max(excess(46.0).x, 1e-3f));
    EXPECT_GT(excess(42.3).x, 1.3f * excess(42.3).z) << "red outside";
    EXPECT_GT(excess(40.3).z, excess(43.0).z);
}

TEST(Halo, StandsAt22DegreesRedInsideAndDarkWithin) {
    double const inner = peak(ice(), 20.0, 26.0, 0), blue = peak(ice(), 20.0, 26.0, 2);
    // The least turn of a prism of 60 degrees: 2 asin(n / 2) - 60.
    EXPECT_NEAR(inner, core::degrees(2.0 * std::asin(0.5 * 1.3085)) - 60.0, 0.6);
    EXPECT_GT(blue, inner);
    EXPECT_GT(at(ice(), inner, 0), 2.0 * at(ice(), 20.0, 0));
    EXPECT_GT(at(ice(), inner, 1), 1.3 * at(ice(), 30.0, 1));
    Rows const rows;
    glm::vec2 const size{sky::kPhaseAngles, 3};
    auto const excess = [&](double degrees) { return glsl::haloExcess(rows.sampler(), size, static_cast<float>(std::cos(core::radians(degrees)))).y; };
    EXPECT_LT(excess(20.0), 0.0f);
    EXPECT_GT(excess(22.3), 0.1f);
    EXPECT_EQ(excess(50.0), 0.0f);
}

TEST(SunDogs, StandBesideTheSunAsHighAsItAndFartherWhenItIsHigh) {
    EXPECT_NEAR(core::degrees(static_cast<double>(glsl::sunDogAzimuth(0.0f, 1.31f))), 21.84, 0.1);
    // At 40 degrees of elevation 28 degrees along the almucantar make 36.9 in azimuth (Tape 1994: distance 28.0).
    float const high = glsl::sunDogAzimuth(std::sin(40.0f * glsl::kDegree), 1.31f);
    double const apart = 2.0 * std::asin(std::cos(core::radians(40.0)) * std::sin(0.5 * static_cast<double>(high)));
    EXPECT_NEAR(core::degrees(apart), 28.0, 0.5);
    EXPECT_LT(glsl::sunDogAzimuth(std::sin(62.0f * glsl::kDegree), 1.31f), 0.0f);
    auto const along = [](double azimuth_deg, double elevation_deg) {
        double const a = core::radians(azimuth_deg), e = core::radians(elevation_deg);
        return glm::vec3{std::sin(a) * std::cos(e), std::sin(e), -std::cos(a) * std::cos(e)};
    };
    glm::vec3 const sun = along(100.0, 15.0);
    double const dog = core::degrees(static_cast<double>(glsl::sunDogAzimuth(std::sin(15.0f * glsl::kDegree), 1.3085f)));
    EXPECT_NEAR(dog, 23.2, 0.2);
    for (double const side : {-1.0, 1.0}) {
        float const inside = glsl::sunDogs(along(100.0 + side * 20.0, 15.0), sun).x, there = glsl::sunDogs(along(100.0 + side * (dog + 0.6), 15.0), sun).x;
        EXPECT_GT(there, 0.3f);
        EXPECT_LT(inside, 0.01f);
        EXPECT_LT(glsl::sunDogs(along(100.0 + side * (dog + 0.6), 19.0), sun).x, 0.02f);
        glm::vec3 const edge = glsl::sunDogs(along(100.0 + side * dog, 15.0), sun);
        EXPECT_GT(edge.x, edge.z) << "red toward the sun";
    }
}

TEST(Glory, RingsTheShadowAndTheCloudBowStandsWiderThanTheDropsAreSmall) {
    // Rings about the antisolar point: the first red one of droplets of 9 um at about 2 to 4 degrees (radius ~ wavelength / size).
    double const bow = 180.0 - peak(droplets(), 130.0, 150.0, 1);
    EXPECT_GT(bow, 36.0);
    EXPECT_LT(bow, 42.0) << "inside the rainbow's 42 degrees";
    EXPECT_GT(at(droplets(), 180.0, 1), 1.5 * at(droplets(), 165.0, 1)) << "brighter around one's shadow";
    // Red rings are wider than blue ones: from the middle outward the green light falls off before the red.
    auto const ring = [](PhaseTable const& table, int channel) { return 180.0 - peak(table, 175.0, 179.2, channel); };
    EXPECT_NEAR(ring(droplets(), 1), core::degrees(2.9 / (2.0 * core::kPi * 9e-6 / 0.545e-6)), 0.5) << "J0 and J2 about the axis (van de Hulst 1957)";
    EXPECT_GT(ring(droplets(), 0), ring(droplets(), 2)) << "red outside";
    PhaseTable const small = sky::dropletPhase(5e-6);
    EXPECT_GT(ring(small, 1), 1.4 * ring(droplets(), 1)) << "smaller droplets, wider rings";
}
