// Any input, any setting, any wind: the aircraft stays a number. And the same inputs give the same bits.
#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>

#include "tests/sim/test_flight.h"

namespace luftpost::flight {
namespace {
double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
}
bool allFinite(AircraftState const& state) {
    bool finite = true;
    forEachNumber(state, [&](double value) { finite = finite && std::isfinite(value); });
    Readings const& r = state.readings;
    for (double value : {r.tas, r.cas, r.alpha, r.beta, r.heading, r.pitch, r.roll, r.loadFactor, r.height,
                         r.thrust, r.groundSpeed, r.climb, r.mass, r.stalled, r.sideLoad})
        finite = finite && std::isfinite(value);
    return finite;
}
std::uint64_t hashOf(AircraftState const& state) {
    std::uint64_t hash = 1469598103934665603u;
    forEachNumber(
        state, [&](double value) { hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u; });
    return hash;
}
AssistSettings anySettings(std::mt19937& random) {
    AssistSettings settings;
    std::apply(
        [&](auto const&... field) {
            ((settings.*field.member = uniform(random, field.min, field.max)), ...);
        },
        assistFields);
    return settings;
}
Controls anyStick(std::mt19937& random) {
    auto const any = [&] { return uniform(random, -1.3, 1.3); };
    Controls stick{any(), any(), any(), any(), any(), any()};
    if (random() % 4 == 0)
        stick = Controls{
            .throttle = any(), .elevator = random() % 2 ? 1.0 : -1.0, .rudder = random() % 2 ? 1.0 : -1.0};
    if (random() % 16 == 0) stick.elevator = std::numeric_limits<double>::quiet_NaN();
    return stick;
}
/// Wind up to 60 m/s with gusts up to 15 m/s, hills, ice: a day on which nobody flies.
void makeWild(TestFlight& flight, std::mt19937& random) {
    double const size = uniform(random, 0.0, 60.0), from = uniform(random, 0.0, 6.28),
                 gust = uniform(random, 0.0, 15.0);
    double const ice = random() % 3 == 0 ? 0.001 : 0.0;
    flight.air = [=](glm::dvec3 const& p, core::UtcSeconds t) {
        core::AirSample sample = isaAir(std::min(p.y, 10900.0));
        sample.windWorld = {size * std::cos(from) + gust * std::sin(0.11 * p.z + t),
                            gust * std::sin(0.07 * p.x - 0.8 * t),
                            size * std::sin(from) + gust * std::sin(0.09 * p.x + 0.13 * p.y)};
        sample.icing = ice;
        return sample;
    };
    flight.ground = [](double east, double north) {
        double const height = 60.0 * std::sin(0.01 * east) * std::cos(0.013 * north);
        glm::dvec3 const normal =
            glm::normalize(glm::dvec3{-0.6 * std::cos(0.01 * east) * std::cos(0.013 * north), 1.0,
                                      -0.78 * std::sin(0.01 * east) * std::sin(0.013 * north)});
        return core::GroundSample{height, normal, core::Surface::grass};
    };
}
/// A minute of anything, ended by the first number that is none.
void flyWild(unsigned seed, std::string const& airframe) {
    std::mt19937 random{seed};
    double const payload = uniform(random, 0.0, 400.0), fuel = random() % 5 == 0 ? 0.0 : uniform(random, 0.0, 160.0);
    TestFlight flight{payload, fuel, airframe};
    makeWild(flight, random);
    flight.inAir(uniform(random, 100.0, 3000.0), uniform(random, 5.0, 90.0));
    bool finite = true;
    double fastest = 0.0, quickest = 0.0;
    flight.fly(60.0, [&](double) {
        if (flight.state().tick % 120 == 0) {
            flight.stick = anyStick(random);
            if (random() % 8 == 0) flight.settings = anySettings(random);
            if (random() % 8 == 0) flight.assist = static_cast<AssistLevel>(random() % 4);
            if (random() % 16 == 0) flight.aircraft.setPayload(uniform(random, 0.0, 400.0));
        }
        if (flight.state().crashed() && random() % 480 == 0)
            flight.aircraft.respawn(300.0, flight.air, flight.ground, flight.time);
        finite = finite && allFinite(flight.state());
        fastest = std::max(fastest, flight.now().tas);
        quickest = std::max(quickest, glm::length(flight.state().ratesBody));
        return finite;
    });
    EXPECT_TRUE(finite) << airframe << ", seed " << seed;
    EXPECT_LT(fastest, 300.0) << airframe << ", seed " << seed;
    EXPECT_LT(quickest, 30.0) << airframe << ", seed " << seed;
}
/// A minute of stick and gusts; gives the hash of each second.
std::vector<std::uint64_t> recorded(AssistLevel level) {
    std::mt19937 random{5};
    TestFlight flight{level};
    makeWild(flight, random);
    flight.inAir(900.0, 50.0);
    std::vector<std::uint64_t> hashes;
    flight.fly(30.0, [&](double) {
        if (flight.state().tick % 60 == 0) flight.stick = anyStick(random);
        if (flight.state().tick % 240 == 0) hashes.push_back(hashOf(flight.state()));
        return true;
    });
    return hashes;
}
}  // namespace

TEST(Robust, NoInputSettingOrWindGivesANumberThatIsNone) {
    // Minutes of each airframe; LUFTPOST_WILD_MINUTES=300 is five hours of each.
    char const* const more = std::getenv("LUFTPOST_WILD_MINUTES");
    unsigned const minutes = more ? static_cast<unsigned>(std::atoi(more)) : 15;
    for (char const* airframe : {"mail_plane", "freight_plane"})
        for (unsigned seed = 1; seed <= minutes; ++seed) flyWild(seed, airframe);
}

TEST(Robust, TheSameInputsGiveTheSameBits) {
    for (AssistLevel level : {AssistLevel::sim, AssistLevel::light, AssistLevel::normal, AssistLevel::easy})
        EXPECT_EQ(recorded(level), recorded(level));
}

TEST(Robust, AKeptStateGoesOnBitForBit) {
    TestFlight flight{AssistLevel::normal};
    std::mt19937 random{3};
    makeWild(flight, random);
    flight.inAir(900.0, 50.0);
    flight.stick.aileron = 0.4;
    flight.fly(3.37);
    AircraftState const kept = flight.state();
    double const time = flight.time;
    flight.fly(5.0);
    std::uint64_t const once = hashOf(flight.state());
    flight.inAir(2000.0, 40.0);
    flight.stick = Controls{.throttle = flight.stick.throttle, .aileron = 0.4};
    flight.stick.throttle = kept.commands.throttle;
    flight.aircraft.restore(kept);
    flight.time = time;
    flight.fly(5.0);
    EXPECT_EQ(hashOf(flight.state()), once);
}

TEST(Robust, EnergyNeverRisesWithoutPowerInStillAir) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        std::mt19937 random{seed};
        TestFlight flight{240.0, 0.0};
        flight.inAir(4000.0, 55.0);
        auto const energy = [&] {
            AircraftState const& s = flight.state();
            double const turning =
                1285.0 * s.ratesBody.x * s.ratesBody.x + 2667.0 * s.ratesBody.y * s.ratesBody.y +
                1825.0 * s.ratesBody.z * s.ratesBody.z + 1.7 * s.propellerRate * s.propellerRate;
            return flight.now().mass * (core::kGravity * s.positionWorld.y +
                                        0.5 * glm::dot(s.velocityWorld, s.velocityWorld)) +
                   0.5 * turning;
        };
        double last = energy(), worst = -1e9;
        flight.fly(60.0, [&](double) {
            if (flight.state().tick % 120 == 0)
                flight.stick = anyStick(random),
                flight.stick.elevator = std::isnan(flight.stick.elevator) ? 0.0 : flight.stick.elevator;
            if (flight.state().tick % 24 == 0 && flight.state().tick > 0) {
                worst = std::max(worst, energy() - last);
                last = energy();
            }
            return flight.now().height > 100.0;
        });
        fmt::print("no power, still air, any stick: energy per 0.1 s at most {:+.0f} J\n", worst);
        EXPECT_LT(worst, 0.0) << seed;
    }
}

TEST(Robust, AStepCostsLittleOfACore) {
    TestFlight flight{AssistLevel::normal};
    flight.inAir(600.0, 52.0);
    auto const start = std::chrono::steady_clock::now();
    flight.fly(20.0);
    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("a step with a cheap air: {:.1f} us, {:.2f} % of a core at 240 Hz\n",
               seconds / 20.0 / 240.0 * 1e6, seconds / 20.0 * 100.0);
    EXPECT_LT(seconds / 20.0, 0.02 * 5.0) << "five times the budget, for loaded machines and sanitizers";
}
}  // namespace luftpost::flight
