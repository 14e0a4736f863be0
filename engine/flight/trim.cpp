#include "engine/flight/trim.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::flight {
namespace {
constexpr int kUnknowns = 4;
using Vector = std::array<double, kUnknowns>;  // alpha, elevator, aileron, rudder
constexpr Vector kLow{-0.2, -1.0, -1.0, -1.0}, kHigh{0.3, 1.0, 1.0, 1.0};

struct Problem {
    Airframe const& airframe;
    MassProperties const& masses;
    core::AirSample const& air;
    double heading, tas, height;
};
struct Balance {
    Vector rest{};         // lift less weight over weight; torques over weight times chord
    double forward = 0.0;  // N along the path
};

/// The loads of steady flight with these unknowns; `state` is brought to it.
Balance balance(Problem const& p, AircraftState& state, Vector const& x) {
    state.worldFromBody = attitude(p.heading, x[0], 0.0);
    state.surfaces.elevator = x[1], state.surfaces.aileron = x[2], state.surfaces.rudder = x[3];
    AirLoads air;
    for (int i = 0; i < 6; ++i) {  // downwash, separation and lift settle on each other
        air = airLoads(p.airframe, state, p.masses, p.air, p.height);
        state.downwash = air.downwash;
        for (std::size_t s = 0; s < p.airframe.strips.size(); ++s)
            state.strips[s].separation = air.strips[s].separationStatic;
    }
    double const weight = p.masses.mass * core::kGravity, lever = weight * p.airframe.wingChord;
    glm::dvec3 const force = state.worldFromBody * air.loads.force;
    glm::dvec3 const path = state.worldFromBody * glm::dvec3{core::cos(x[0]), -core::sin(x[0]), 0.0};
    Balance b;
    b.rest = {force.y / weight - 1.0, air.loads.torque.z / lever, air.loads.torque.x / lever,
              air.loads.torque.y / lever};
    b.forward = glm::dot(force, path);
    return b;
}

/// Solves a x = b by elimination with pivots; a nearly singular direction is left alone.
Vector solved(std::array<Vector, kUnknowns> a, Vector b) {
    for (int column = 0; column < kUnknowns; ++column) {
        int pivot = column;
        for (int row = column + 1; row < kUnknowns; ++row)
            if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
        std::swap(a[column], a[pivot]), std::swap(b[column], b[pivot]);
        if (std::abs(a[column][column]) < 1.0e-9) a[column][column] = 1.0e9;
        for (int row = 0; row < kUnknowns; ++row) {
            if (row == column) continue;
            double const factor = a[row][column] / a[column][column];
            for (int k = 0; k < kUnknowns; ++k) a[row][k] -= factor * a[column][k];
            b[row] -= factor * b[column];
        }
    }
    for (int i = 0; i < kUnknowns; ++i) b[i] /= a[i][i];
    return b;
}

/// Newton's method with bounds at a given power; gives what is left along the path.
double solveAtPower(Problem const& p, AircraftState& state, Vector& x, double share) {
    state.surfaces.throttle = share;
    state.propellerRate = steadyRate(p.airframe, share, p.tas, p.air.density, state.fuel > 0.0);
    Balance now = balance(p, state, x);
    for (int iteration = 0; iteration < 12; ++iteration) {
        std::array<Vector, kUnknowns> jacobian;
        constexpr double kStep = 1.0e-5;
        for (int column = 0; column < kUnknowns; ++column) {
            Vector moved = x;
            moved[column] += kStep;
            Balance const there = balance(p, state, moved);
            for (int row = 0; row < kUnknowns; ++row)
                jacobian[row][column] = (there.rest[row] - now.rest[row]) / kStep;
        }
        Vector const change = solved(jacobian, now.rest);
        double largest = 0.0;
        for (int i = 0; i < kUnknowns; ++i) {
            double const next = std::clamp(x[i] - std::clamp(change[i], -0.1, 0.1), kLow[i], kHigh[i]);
            largest = std::max(largest, std::abs(next - x[i]));
            x[i] = next;
        }
        now = balance(p, state, x);
        if (largest < 1.0e-10) break;
    }
    return now.forward;
}
}  // namespace

glm::dquat attitude(double heading, double pitch, double roll) {
    auto const about = [](double angle, glm::dvec3 const& axis) {
        double const s = core::sin(0.5 * angle);
        return glm::dquat{core::cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z};
    };
    return about(0.5 * core::kPi - heading, {0.0, 1.0, 0.0}) * about(pitch, {0.0, 0.0, 1.0}) *
           about(roll, {1.0, 0.0, 0.0});
}

void trimForLevelFlight(Airframe const& airframe, AircraftState& state, core::AirSample const& air,
                        double heading, double tas, double height) {
    state.ratesBody = glm::dvec3{0.0};
    state.velocityWorld = air.windWorld + tas * glm::dvec3{core::sin(heading), 0.0, -core::cos(heading)};
    for (StripState& strip : state.strips) strip.windWorld = air.windWorld, strip.separation = 0.0;
    MassProperties const masses = massProperties(airframe, state);
    Problem const problem{airframe, masses, air, heading, tas, height};
    Vector x{0.05, 0.0, 0.0, 0.0};
    double low = 0.0, high = 1.0;
    if (solveAtPower(problem, state, x, high) > 0.0) {
        for (int i = 0; i < 26; ++i) {
            double const middle = 0.5 * (low + high);
            (solveAtPower(problem, state, x, middle) > 0.0 ? high : low) = middle;
        }
        solveAtPower(problem, state, x, 0.5 * (low + high));
    }
    state.trim = state.surfaces;
    state.commands = state.surfaces;
}
}  // namespace luftpost::flight
