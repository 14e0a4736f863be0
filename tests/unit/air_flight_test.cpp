// The air as a flight meets it: nothing jumps, calm is calm, the recording's wind blows, threads agree, and it is cheap.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "engine/core/math.h"
#include "engine/core/time.h"
#include "engine/weather/air.h"
#include "engine/weather/noise_volume.h"
#include "engine/weather/source.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
core::UtcSeconds noon() { return *core::parseUtc("2023-06-23T12:00Z"); }
core::GroundSample flat(double, double) { return {316.0, {0.0, 1.0, 0.0}, core::Surface::grass}; }
/// Ridges of 250 m every 5 km.
core::GroundSample ridges(double east, double north) {
    double const s = core::sin(2.0 * core::kPi * (east + 0.3 * north) / 5000.0);
    return {316.0 + 250.0 * s * s * s * s, {0.0, 1.0, 0.0}, core::Surface::grass};
}

/// The largest change of each part of the air between neighbours of a row of samples.
struct Steps {
    double wind = 0.0, up = 0.0, turbulence = 0.0, temperature = 0.0, density = 0.0, extinction = 0.0, icing = 0.0, fall = 0.0;
    void see(core::AirSample const& a, core::AirSample const& b) {
        auto const grow = [](double& most, double change) { most = std::max(most, std::abs(change)); };
        grow(wind, std::hypot(a.windWorld.x - b.windWorld.x, a.windWorld.z - b.windWorld.z));
        grow(up, a.windWorld.y - b.windWorld.y);
        grow(turbulence, a.turbulence - b.turbulence);
        grow(temperature, a.temperature - b.temperature);
        grow(density, a.density - b.density);
        grow(extinction, 3.0 / a.visibility - 3.0 / b.visibility);
        grow(icing, a.icing - b.icing);
        grow(fall, a.rain + a.snow + a.hail - b.rain - b.snow - b.hail);
    }
};
void expectBelow(Steps const& steps, Steps const& bound, char const* what) {
    EXPECT_LT(steps.wind, bound.wind) << what;
    EXPECT_LT(steps.up, bound.up) << what;
    EXPECT_LT(steps.turbulence, bound.turbulence) << what;
    EXPECT_LT(steps.temperature, bound.temperature) << what;
    EXPECT_LT(steps.density, bound.density) << what;
    EXPECT_LT(steps.extinction, bound.extinction) << what;
    EXPECT_LT(steps.icing, bound.icing) << what;
    EXPECT_LT(steps.fall, bound.fall) << what;
    EXPECT_GT(steps.wind, 0.0) << what;
}
}  // namespace

// docs/weather.md states these bounds: per metre of way, and per second at one place (over the minute at which the patterns take
// their next step, and the report's own minute).
TEST(AirFlight, NothingJumpsFromMetreToMetreThroughRidgesCloudsAndStorms) {
    static NoiseVolumes const noise = makeNoise(kNoiseSeed, 2);
    Steps const bound{1.0, 1.0, 0.1, 0.05, 0.001, 0.06, 1e-4, 0.5};
    for (char const* preset : {"preset:fair", "preset:storm"}) {
        Field const field = loadWeather(preset);
        Air const air{field, ridges, 1, &noise};
        AirInstant const now = air.instant(noon());
        for (double const altitude : {600.0, 700.0, 1300.0, 1500.0}) {
            Steps steps;
            core::AirSample last = now.at({0.0, altitude, 0.0});
            for (int i = 1; i < 3000; ++i) {
                core::AirSample const next = now.at({i * 0.97, altitude, i * 0.24});
                steps.see(last, next);
                last = next;
            }
            expectBelow(steps, bound, preset);
        }
    }
}

TEST(AirFlight, NothingJumpsFromTickToTickOverTheMinute) {
    Steps const bound{0.1, 0.1, 0.01, 0.001, 0.0001, 0.001, 1e-5, 0.05};
    for (char const* preset : {"preset:fair", "preset:storm"}) {
        Field const field = loadWeather(preset);
        Air const air{field, ridges, 1};
        for (glm::dvec3 const place : {glm::dvec3{-1400.0, 620.0, 0.0}, glm::dvec3{3000.0, 1400.0, 900.0}}) {
            Steps steps;
            core::AirSample last = air.at(place, noon() - 0.5);
            for (int tick = 1; tick < 240; ++tick) {
                core::AirSample const next = air.at(place, noon() - 0.5 + tick / 240.0);
                steps.see(last, next);
                last = next;
            }
            expectBelow(steps, bound, preset);
        }
    }
}

TEST(AirFlight, CalmIsStillEverywhereAlsoNearSlopesAndOverHotGround) {
    Field const field = loadWeather("preset:calm");
    Air const air{field, ridges, 1};
    for (int hour = 0; hour < 24; hour += 3)
        for (int i = 0; i < 150; ++i) {
            core::AirSample const s = air.at({i * 137.0 - 9000.0, 317.0 + (i % 30) * 60.0, i * 61.0}, noon() + hour * 3600.0);
            ASSERT_EQ(glm::length(s.windWorld), 0.0);
            ASSERT_EQ(s.turbulence, 0.0);
            ASSERT_EQ(s.rain + s.snow + s.hail + s.icing, 0.0);
        }
}

// The mean wind along a flight is the field's at that place, gusts and thermals or not: a minute of flight has 3 km, some gusts long.
TEST(AirFlight, TheWindAveragedOverAMinuteIsTheRecordingsOverFlatLand) {
    for (char const* preset : {"preset:fair", "preset:broken"}) {
        Field const field = loadWeather(preset);
        Air const air{field, flat, 1};
        glm::dvec2 all{0.0};
        int const minutes = 40;
        for (int minute = 0; minute < minutes; ++minute) {
            glm::dvec2 sum{0.0};
            double sigma = 0.0;
            for (int s = 0; s < 120; ++s) {
                double const t = noon() + minute * 60.0 + s * 0.5, east = minute * 3000.0 + s * 25.0 - 60000.0;
                core::AirSample const sample = air.at({east, 616.0, 500.0 * minute}, t);
                sum += glm::dvec2{sample.windWorld.x, -sample.windWorld.z} - field.windAt(east, -500.0 * minute, 616.0, 316.0, t);
                sigma = std::max(sigma, sample.turbulence);
            }
            EXPECT_LT(glm::length(sum / 120.0), 2.5 * sigma) << preset << minute;
            all += sum / (120.0 * minutes);
        }
        EXPECT_LT(glm::length(all), 0.15) << preset;
    }
}

TEST(AirFlight, RisesAsMuchAsItSinksOverAHundredKilometres) {
    for (char const* preset : {"preset:clear", "preset:storm"}) {
        Field const field = loadWeather(preset);
        Air const air{field, ridges, 1};
        AirInstant const now = air.instant(noon());
        double sum = 0.0;
        int const n = 100;
        for (int i = 0; i < n * n; ++i) sum += now.at({(i % n) * 1013.0, 700.0, (i / n) * 1019.0}).windWorld.y;
        EXPECT_LT(std::abs(sum / (n * n)), 0.06) << preset;
    }
}

TEST(AirFlight, HasTheSameBitsOnAnyNumberOfThreads) {
    Field const field = loadWeather("preset:storm");
    auto const place = [](int i) { return glm::dvec3{(i * 7919 % 4001) * 5.0, 350.0 + i % 1500, (i * 104729 % 4001) * 5.0}; };
    constexpr int kPoints = 2000;
    std::vector<core::AirSample> one(kPoints), many(kPoints);
    Air const alone{field, ridges, 1}, shared{field, ridges, 1};
    AirInstant const first = alone.instant(noon()), second = shared.instant(noon());
    for (int i = 0; i < kPoints; ++i) one[static_cast<std::size_t>(i)] = first.at(place(i));
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int i = kPoints - 1 - t; i >= 0; i -= 4) many[static_cast<std::size_t>(i)] = second.at(place(i));
        });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < kPoints; ++i) {
        ASSERT_EQ(one[i].windWorld, many[i].windWorld);
        ASSERT_EQ(one[i].rain, many[i].rain);
        ASSERT_EQ(one[i].turbulence, many[i].turbulence);
    }
}

// A microsecond on an idle core; the bound only sees that it has not become ten.
TEST(AirFlight, ASampleIsCheapEnoughForEveryStrip) {
    for (char const* preset : {"preset:fair", "preset:storm"}) {
        Field const field = loadWeather(preset);
        Air const air{field, ridges, 1};
        AirInstant const now = air.instant(noon());
        double best = 1.0, sum = 0.0;
        for (int run = 0; run < 20; ++run) {
            auto const start = std::chrono::steady_clock::now();
            for (int i = 0; i < 500; ++i) sum += now.at({(i % 24) * 0.45, 600.0, i * 0.2}).windWorld.y;
            best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / 500.0);
        }
        RecordProperty(preset + 7, std::to_string(best * 1e9) + " ns");
        EXPECT_TRUE(std::isfinite(sum));
        EXPECT_LT(best, 10e-6) << preset;
    }
}
