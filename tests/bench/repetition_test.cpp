// No genus repeats itself: the autocorrelation of its plan at every lag from 10 to 100 km, in all directions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "engine/weather/cloud_plan.h"
#include "engine/weather/genera.h"
#include "engine/weather/noise_volume.h"
#include "tests/bench/one_layer.h"

namespace {
using namespace luftpost;
using namespace luftpost::weather;
using Complex = std::complex<double>;

constexpr int kSide = 256;             // points a side of the plan
constexpr int kPadded = 2 * kSide;     // so that no lag wraps
constexpr double kWidth = 400'000.0;   // m: lags of 100 km still have a thousand clouds to be judged by
constexpr double kStep = kWidth / kSide;

/// Cooley and Tukey's transform, in place; `values.size()` is a power of two; `sign` -1 forward, 1 back (not divided).
void transform(std::vector<Complex>& values, double sign) {
    std::size_t const n = values.size();
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1;
        for (; j & bit; bit >>= 1) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t length = 2; length <= n; length <<= 1) {
        Complex const turn = std::polar(1.0, sign * 2.0 * 3.14159265358979323846 / static_cast<double>(length));
        for (std::size_t start = 0; start < n; start += length) {
            Complex w{1.0};
            for (std::size_t k = 0; k < length / 2; ++k, w *= turn) {
                Complex const a = values[start + k], b = values[start + k + length / 2] * w;
                values[start + k] = a + b;
                values[start + k + length / 2] = a - b;
            }
        }
    }
}

void transformPlane(std::vector<Complex>& plane, double sign) {
    std::vector<Complex> line(kPadded);
    for (int pass = 0; pass < 2; ++pass)
        for (int i = 0; i < kPadded; ++i) {
            auto const at = [&](int k) -> Complex& { return plane[static_cast<std::size_t>(pass == 0 ? i * kPadded + k : k * kPadded + i)]; };
            for (int k = 0; k < kPadded; ++k) line[static_cast<std::size_t>(k)] = at(k);
            transform(line, sign);
            for (int k = 0; k < kPadded; ++k) at(k) = line[static_cast<std::size_t>(k)];
        }
}

struct Peak {
    double correlation = 0.0, lag = 0.0;  // m
};

/// Largest autocorrelation at lags of `from` to `to` m, each by the points that have a partner there.
Peak peakBetween(std::vector<float> const& plan, double from, double to) {
    double mean = 0.0, variance = 0.0;
    for (float value : plan) mean += static_cast<double>(value) / static_cast<double>(plan.size());
    std::vector<Complex> plane(static_cast<std::size_t>(kPadded) * kPadded);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double const off = static_cast<double>(plan[static_cast<std::size_t>(y * kSide + x)]) - mean;
            plane[static_cast<std::size_t>(y * kPadded + x)] = off;
            variance += off * off / (kSide * kSide);
        }
    transformPlane(plane, -1.0);
    for (Complex& value : plane) value = std::norm(value);
    transformPlane(plane, 1.0);
    Peak peak;
    for (int y = -kSide + 1; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double const lag = std::hypot(x, y) * kStep;
            if (lag < from || lag > to) continue;
            double const pairs = static_cast<double>(kSide - x) * (kSide - std::abs(y)) * kPadded * kPadded;
            double const c = plane[static_cast<std::size_t>(((y + kPadded) % kPadded) * kPadded + x)].real() / (pairs * variance);
            if (c > peak.correlation) peak = {c, lag};
        }
    return peak;
}

TEST(Repetition, IsNotSeenInAnyGenusFromTenToAHundredKilometres) {
    NoiseVolumes const noise = makeNoise(kNoiseSeed, 2);
    for (int index = 0; index < kGenera; ++index) {
        auto const genus = static_cast<Genus>(index);
        PlanRequest request;
        request.width = kWidth;
        request.size = {kSide, kSide};
        Peak const peak = peakBetween(cloudPlan(tests::fieldOfOneLayer(genus, 0.5f, genusRow(genus).thickness), request, noise, 2), 10'000.0, 100'000.0);
        fmt::print("| {} | {:.3f} | {:.0f} km |\n", genusName(genus), peak.correlation, 1e-3 * peak.lag);
        EXPECT_LT(peak.correlation, 0.2) << genusName(genus);
        EXPECT_GT(peak.correlation, 0.0) << "a plan without variance tells nothing";
    }
}

TEST(Repetition, IsFoundWhereThereIsSome) {
    std::vector<float> plan(static_cast<std::size_t>(kSide) * kSide);
    for (std::size_t i = 0; i < plan.size(); ++i) {
        std::size_t const x = i % kSide % 20, y = i / kSide;  // again every 20 points, 31 km
        plan[i] = static_cast<float>((x * 7919 + y * 104729 + x * x * y * 31) % 97);
    }
    Peak const peak = peakBetween(plan, 10'000.0, 100'000.0);
    EXPECT_GT(peak.correlation, 0.9);
    EXPECT_NEAR(std::remainder(peak.lag, 20.0 * kStep), 0.0, 1.0);
}
}  // namespace
