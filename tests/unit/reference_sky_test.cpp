// The medium that the game's sky is held against: what spares it work may be wrong, but must not make its mean wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/time.h"
#include "engine/render/reference_sky.h"
#include "engine/sky/light.h"
#include "engine/weather/field.h"
#include "engine/weather/source.h"

namespace {
using namespace luftpost;

/// Noon under fair-weather cumulus.
struct Noon {
    weather::NoiseVolumes noise = weather::makeNoise(weather::kNoiseSeed, 2);
    weather::Field field = weather::loadWeather("preset:fair");
    render::Snapshot snapshot;

    Noon() {
        snapshot.time = *core::parseUtc("2023-06-23T12:00Z");
        snapshot.place = {47.5, 7.6, 300.0};
        snapshot.camera.positionWorld = {0.0, 310.0, 0.0};
        snapshot.field = &field;
        snapshot.weather = field.at(0.0, 0.0, snapshot.time);
        snapshot.sky = sky::skyState(snapshot.place, snapshot.time);
    }
};

/// Mean of what is drawn, and its standard error.
struct Mean {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    double value() const { return sum / count; }
    double error() const { return std::sqrt(std::max(squares / count - value() * value(), 0.0) / count); }
};

TEST(ReferenceClouds, KeepTheirBounds) {
    Noon const noon;
    render::ReferenceClouds clouds{noon.snapshot, noon.noise, 2};
    clouds.makeSunGuess(noon.snapshot.sky.sunDirectionWorld, 2);
    ASSERT_FALSE(clouds.empty());
    core::Random random{1};
    int above = 0, below = 0, sure = 0, cloudy = 0;
    double real = 0.0, known = 0.0;
    for (int i = 0; i < 200000; ++i) {
        glm::dvec3 const place{random.uniform(-15e3, 15e3), random.uniform(clouds.lowest(), clouds.highest()), random.uniform(-15e3, 15e3)};
        auto const bound = clouds.bound(place, {0.0, 1.0, 0.0});
        auto const here = clouds.at(place);
        above += here.droplets + here.ice > bound.most ? 1 : 0;
        below += here.droplets < bound.sure ? 1 : 0;
        sure += bound.sure > 0.0f ? 1 : 0;
        cloudy += here.droplets > 0.0f ? 1 : 0;
        real += static_cast<double>(here.droplets);
        known += static_cast<double>(bound.sure);
        float const guess = clouds.sunGuess(place);
        ASSERT_TRUE(guess > 0.0f && guess <= 1.0f);
    }
    EXPECT_GT(cloudy, 2000);
    EXPECT_GT(known, 0.1 * real);
    // Where they are broken the mean stays right; seldom, or it would be noise.
    EXPECT_LT(above, cloudy / 1000);
    EXPECT_LT(below, sure / 100);
}

TEST(ReferenceSky, SeesWithItsAirApartWhatItSeesWithAllInOne) {
    Noon const noon;
    render::ReferenceSky const medium{noon.snapshot, noon.noise, 2};
    core::Random random{2};
    for (double const up : {-0.08, 0.03, 0.5}) {
        Mean apart, together, through, hidden;
        for (int way = 0; way < 12; ++way) {
            double const east = 2.0 * core::kPi * (way + 0.2) / 12.0, across = std::sqrt(1.0 - up * up);
            sky::PathRay const ray{glm::dvec3{0.0}, {across * std::cos(east), up, across * std::sin(east)}};
            sky::AirDraw const air = medium.airDraw(ray);
            for (int i = 0; i < 200; ++i) {
                sky::Seen const seen = sky::seen(medium, ray, air, random);
                apart.add(static_cast<double>(sky::luminance(seen.light)));
                through.add(static_cast<double>(seen.through));
                together.add(static_cast<double>(sky::luminance(sky::pathRadiance(medium, ray, random))));
                hidden.add(static_cast<double>(sky::shadow(medium, ray, medium.surface(ray), sky::kMostLeast, random)));
            }
        }
        EXPECT_LT(std::abs(apart.value() - together.value()), 3.5 * std::hypot(apart.error(), together.error())) << up;
        EXPECT_LT(apart.error(), 0.1 * apart.value()) << up;
        EXPECT_LT(std::abs(through.value() - hidden.value()), 3.5 * std::hypot(through.error(), hidden.error()) + 1e-6) << up;
    }
}

TEST(ReferenceSky, LetsThroughItsAirWhatItsExtinctionLeaves) {
    Noon noon;
    noon.snapshot.drawClouds = false;
    render::ReferenceSky const medium{noon.snapshot, noon.noise, 2};
    core::Random random{3};
    for (double const up : {0.02, 0.3, 1.0}) {
        sky::PathRay const ray{glm::dvec3{0.0}, {std::sqrt(1.0 - up * up), up, 0.0}};
        double const far = 60e3;
        double depth = 0.0;
        constexpr int kSteps = 20000;
        for (int i = 0; i < kSteps; ++i) depth += static_cast<double>(medium.airAt(ray.at((i + 0.5) * far / kSteps)).extinction.z) * far / kSteps;
        Mean mean;
        for (int i = 0; i < 20000; ++i) mean.add(static_cast<double>(medium.throughAir(ray, far, random).z));
        EXPECT_NEAR(mean.value(), std::exp(-depth), 3.5 * mean.error() + 1e-4) << up;
    }
}

TEST(AirDraw, DrawsAsOftenAsItSays) {
    sky::AirDraw const air{{{10.0, 1.0}, {30.0, 1.0}, {100.0, 2.0}}};
    core::Random random{4};
    Mean length, first;
    for (int i = 0; i < 100000; ++i) {
        auto const place = air.draw(random);
        ASSERT_TRUE(place.distance >= 0.0 && place.distance < 100.0);
        length.add(1.0 / place.density);  // the mean of it is the length of all
        first.add(place.distance < 10.0 ? 1.0 : 0.0);
    }
    EXPECT_NEAR(length.value(), 100.0, 0.5);
    EXPECT_NEAR(first.value(), 0.25, 0.006);
}
}  // namespace
