#include <gtest/gtest.h>

#include <cmath>

#include "engine/weather/curve.h"

using namespace luftpost::weather;

TEST(WeatherCurve, PassesThroughItsKnotsAndNeverBeyondTheirNeighbours) {
    Curve const curve{{0.0, 10.0, 15.0, 40.0, 41.0}, {1.0, 1.0, 5.0, 4.0, -3.0}};
    for (std::size_t k = 0; k < 5; ++k) EXPECT_DOUBLE_EQ(curve.at(curve.times()[k]), curve.values()[k]);
    for (double t = 0.0; t <= 10.0; t += 0.1) EXPECT_DOUBLE_EQ(curve.at(t), 1.0);
    for (double t = 10.0; t <= 15.0; t += 0.1) EXPECT_TRUE(curve.at(t) >= 1.0 && curve.at(t) <= 5.0) << t;
    for (double t = 40.0; t <= 41.0; t += 0.01) EXPECT_TRUE(curve.at(t) >= -3.0 && curve.at(t) <= 4.0) << t;
}

TEST(WeatherCurve, HoldsItsEndsAndASingleKnotEverywhere) {
    Curve const curve{{5.0, 6.0}, {2.0, 3.0}};
    EXPECT_EQ(curve.at(-1e9), 2.0);
    EXPECT_EQ(curve.at(1e9), 3.0);
    Curve const one{{5.0}, {7.0}};
    EXPECT_EQ(one.at(0.0), 7.0);
    EXPECT_EQ(one.at(5.0), 7.0);
    EXPECT_EQ(one.at(9.0), 7.0);
    EXPECT_DOUBLE_EQ(one.integralTo(8.0), 21.0);
}

TEST(WeatherCurve, TheIntegralsDerivativeIsTheValueInsideAndOutside) {
    Curve const curve{{0.0, 600.0, 1200.0, 4800.0}, {3.0, -1.0, 8.0, 2.0}};
    for (double t = -500.0; t < 6000.0; t += 37.0) {
        double const slope = (curve.integralTo(t + 0.01) - curve.integralTo(t - 0.01)) / 0.02;
        EXPECT_NEAR(slope, curve.at(t), 1e-4) << t;
    }
}

TEST(WeatherCurve, ASumCurveKeepsEveryIntervalsSumAndIsNeverNegative) {
    std::vector<double> const edges{0.0, 600.0, 1200.0, 1800.0, 2400.0, 6000.0};
    std::vector<double> const rates{0.0, 1.2, 109.2, 27.0, 0.0};
    SumCurve const curve{edges, rates};
    for (std::size_t k = 0; k < rates.size(); ++k) {
        double sum = 0.0;
        double const width = edges[k + 1] - edges[k];
        int const steps = 6000;
        for (int i = 0; i < steps; ++i) {
            double const rate = curve.rateAt(edges[k] + (i + 0.5) * width / steps);
            EXPECT_GE(rate, 0.0);
            sum += rate * width / steps;
        }
        EXPECT_NEAR(sum, rates[k] * width, 0.0001 * rates[k] * width + 1e-6) << k;
    }
}

TEST(WeatherCurve, ASumCurveDoesNotJumpAtAnEdge) {
    SumCurve const curve{{0.0, 600.0, 1200.0, 1800.0}, {1.2, 109.2, 27.0}};
    for (double t = 0.0; t < 1800.0; t += 1.0) EXPECT_LT(std::abs(curve.rateAt(t + 1.0) - curve.rateAt(t)), 1.5) << t;
}

TEST(WeatherCurve, AMaximumIsReachedByTheIntervalsEndAndHeldNeverPassed) {
    MaximumCurve const curve{{0.0, 600.0, 1200.0, 1800.0}, {3.1, 19.7, 22.0, 5.5}};
    EXPECT_DOUBLE_EQ(curve.at(1200.0), 22.0);
    EXPECT_DOUBLE_EQ(curve.at(900.0), 22.0);
    EXPECT_DOUBLE_EQ(curve.at(1500.0), 5.5);
    EXPECT_DOUBLE_EQ(curve.at(9999.0), 5.5);
    for (double t = -10.0; t < 1900.0; t += 1.0) {
        EXPECT_LE(curve.at(t), 22.0);
        EXPECT_LT(std::abs(curve.at(t + 1.0) - curve.at(t)), 0.25) << t;
    }
}
