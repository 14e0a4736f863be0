#include "engine/flight/rigid_body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace luftpost::flight {
namespace {
// The torque-free body of the reference: near its middle axis, where it tumbles.
constexpr double kA = 10.0, kB = 20.0, kC = 26.0;
glm::dvec3 const kRates{1.0, 15.0, 1.0};

glm::dmat3 inertia() {
    glm::dmat3 matrix{0.0};
    matrix[0][0] = kA, matrix[1][1] = kB, matrix[2][2] = kC;
    return matrix;
}
Motion spun(double seconds, int perSecond) {
    Motion motion;
    motion.ratesBody = kRates;
    int const steps = static_cast<int>(std::lround(seconds * perSecond));
    for (int i = 0; i < steps; ++i)
        motion = moved(motion, Loads{}, glm::dvec3{0.0}, 1.0, inertia(), 1.0 / perSecond);
    return motion;
}
double energy(Motion const& m) { return 0.5 * glm::dot(m.ratesBody, inertia() * m.ratesBody); }

struct Jacobi {
    double sn, cn, dn;
};
/// Jacobi's elliptic functions by the descending Landen transformation (arithmetic-geometric mean).
Jacobi jacobi(double u, double m) {
    double a[20]{1.0}, c[20]{std::sqrt(m)}, b = std::sqrt(1.0 - m);
    int n = 0;
    for (; std::abs(c[n]) > 1e-17 && n < 18; ++n) {
        a[n + 1] = 0.5 * (a[n] + b);
        c[n + 1] = 0.5 * (a[n] - b);
        b = std::sqrt(a[n] * b);
    }
    double phi = std::ldexp(a[n] * u, n);
    for (; n > 0; --n) phi = 0.5 * (phi + std::asin(c[n] * std::sin(phi) / a[n]));
    double const sn = std::sin(phi);
    return {sn, std::cos(phi), std::sqrt(1.0 - m * sn * sn)};
}
/// Euler's equations solved (Landau and Lifshitz, Mechanics, paragraph 37), for H^2 > 2 T I_middle.
glm::dvec3 exactRates(double t) {
    double const twoT = kA * kRates.x * kRates.x + kB * kRates.y * kRates.y + kC * kRates.z * kRates.z;
    double const h2 =
        kA * kA * kRates.x * kRates.x + kB * kB * kRates.y * kRates.y + kC * kC * kRates.z * kRates.z;
    double const first = std::sqrt((twoT * kC - h2) / (kA * (kC - kA)));
    double const second = std::sqrt((twoT * kC - h2) / (kB * (kC - kB)));
    double const third = std::sqrt((h2 - twoT * kA) / (kC * (kC - kA)));
    double const rate = std::sqrt((kC - kB) * (h2 - twoT * kA) / (kA * kB * kC));
    double const m = (kB - kA) * (twoT * kC - h2) / ((kC - kB) * (h2 - twoT * kA));
    double const u0 = std::ellint_1(std::sqrt(m), std::asin(kRates.y / second));
    Jacobi const j = jacobi(u0 + rate * t, m);
    return {first * j.cn, second * j.sn, third * j.dn};
}
}  // namespace

TEST(RigidBody, TorqueFreeTumblingKeepsEnergyAndMomentumForTenMinutes) {
    Motion start;
    start.ratesBody = kRates;
    double const momentum = glm::length(inertia() * kRates);
    double worstEnergy = 0.0, worstMomentum = 0.0;
    Motion motion = start;
    for (int i = 0; i < 600 * 120; ++i) {
        motion = moved(motion, Loads{}, glm::dvec3{0.0}, 1.0, inertia(), 1.0 / 120.0);
        worstEnergy = std::max(worstEnergy, std::abs(energy(motion) / energy(start) - 1.0));
        worstMomentum =
            std::max(worstMomentum, std::abs(glm::length(inertia() * motion.ratesBody) / momentum - 1.0));
    }
    std::printf("torque-free body, 120 Hz, 600 s: energy within %.1e, momentum within %.1e\n", worstEnergy,
                worstMomentum);
    EXPECT_LT(worstEnergy, 1e-6);
    EXPECT_LT(worstMomentum, 1e-9);
    // And the direction of the momentum in the world.
    glm::dvec3 const direction = glm::normalize(motion.worldFromBody * (inertia() * motion.ratesBody));
    EXPECT_GT(glm::dot(direction, glm::normalize(inertia() * kRates)), 1.0 - 1e-9);
}

TEST(RigidBody, TorqueFreeTumblingFollowsTheExactSolution) {
    EXPECT_NEAR(glm::length(exactRates(0.0) - kRates), 0.0, 1e-9);
    double const coarse = glm::length(spun(2.0, 240).ratesBody - exactRates(2.0));
    double const fine = glm::length(spun(2.0, 960).ratesBody - exactRates(2.0));
    std::printf("torque-free body after 2 s: off by %.4f rad/s at 240 Hz, %.4f at 960 Hz (of 15)\n", coarse,
                fine);
    EXPECT_LT(coarse, 0.15);
    EXPECT_NEAR(coarse / fine, 16.0, 3.0) << "second order";
}

TEST(RigidBody, AFallIsAParabola) {
    Motion motion;
    motion.velocityWorld = {10.0, 5.0, 0.0};
    for (int i = 0; i < 240; ++i)
        motion = moved(motion, Loads{}, {0.0, -9.80665, 0.0}, 3.0, glm::dmat3{1.0}, 1.0 / 240.0);
    EXPECT_NEAR(motion.positionWorld.x, 10.0, 1e-9);
    EXPECT_NEAR(motion.positionWorld.y, 5.0 - 0.5 * 9.80665, 0.03);
    EXPECT_NEAR(motion.velocityWorld.y, 5.0 - 9.80665, 1e-9);
}

TEST(RigidBody, ASteadyTorqueAboutAnAxisSpinsUpAtTorqueOverInertia) {
    Motion motion;
    Loads loads;
    loads.torque = {20.0, 0.0, 0.0};
    for (int i = 0; i < 240; ++i) motion = moved(motion, loads, glm::dvec3{0.0}, 1.0, inertia(), 1.0 / 240.0);
    EXPECT_NEAR(motion.ratesBody.x, 2.0, 1e-9);
}
}  // namespace luftpost::flight
