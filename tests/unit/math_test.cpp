#include "engine/core/math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/frames.h"

namespace luftpost::core {
namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Largest |ours - standard| / max(|standard|, floor) over a sweep of `count` points from `low` to `high`.
template <class Ours, class Standard>
double worst(Ours ours, Standard standard, double low, double high, double floor, int count = 20001) {
    double largest = 0.0;
    for (int i = 0; i < count; ++i) {
        double const x = low + (high - low) * i / (count - 1);
        double const expected = standard(x);
        largest = std::max(largest, std::abs(ours(x) - expected) / std::max(std::abs(expected), floor));
    }
    return largest;
}
}  // namespace

TEST(Math, SineCosineTangentAreGoodTo14Digits) {
    for (double range : {1.0, 10.0, 1.0e3, 1.0e6}) {
        EXPECT_LT(worst(
                      sin, [](double x) { return std::sin(x); }, -range, range, 1e-2),
                  1e-14)
            << range;
        EXPECT_LT(worst(
                      cos, [](double x) { return std::cos(x); }, -range, range, 1e-2),
                  1e-14)
            << range;
    }
    EXPECT_LT(worst(
                  tan, [](double x) { return std::tan(x); }, -1.57, 1.57, 1e-9),
              1e-14);
    EXPECT_NEAR(sin(kPi), 1.2246467991473532e-16, 1e-30);
    EXPECT_DOUBLE_EQ(sin(1e-300), 1e-300);
}

TEST(Math, SineStaysBoundedForHugeArguments) {
    for (double x : {1e9, -1e15, 1e100, 1e308}) {
        EXPECT_LE(std::abs(sin(x)), 1.0 + 1e-15) << x;
        EXPECT_NEAR(sin(x) * sin(x) + cos(x) * cos(x), 1.0, 1e-14) << x;
    }
    EXPECT_TRUE(std::isnan(sin(kInfinity)));
    EXPECT_TRUE(std::isnan(cos(std::nan(""))));
}

TEST(Math, InverseFunctionsAreGoodTo14Digits) {
    EXPECT_LT(worst(
                  atan, [](double x) { return std::atan(x); }, -20.0, 20.0, 1e-12),
              1e-14);
    EXPECT_LT(worst(
                  asin, [](double x) { return std::asin(x); }, -1.0, 1.0, 1e-12),
              1e-14);
    EXPECT_LT(worst(
                  acos, [](double x) { return std::acos(x); }, -1.0, 1.0, 1e-9),
              1e-14);
    for (int degrees = -179; degrees <= 180; ++degrees) {
        double const angle = radians(degrees);
        EXPECT_NEAR(atan2(3.0 * std::sin(angle), 3.0 * std::cos(angle)), angle, 1e-14);
    }
    EXPECT_EQ(atan2(0.0, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(atan2(0.0, -1.0), kPi);
    EXPECT_DOUBLE_EQ(atan2(-kInfinity, 5.0), -kPi / 2.0);
    EXPECT_TRUE(std::isnan(asin(1.0000001)));
}

TEST(Math, ExponentialAndLogarithmAreGoodTo14Digits) {
    EXPECT_LT(worst(
                  exp, [](double x) { return std::exp(x); }, -700.0, 700.0, 0.0),
              1e-14);
    EXPECT_LT(worst(
                  exp, [](double x) { return std::exp(x); }, -1.0, 1.0, 0.0),
              1e-15);
    EXPECT_LT(worst(
                  log, [](double x) { return std::log(x); }, 1e-3, 1e3, 1e-9),
              1e-14);
    EXPECT_LT(worst(
                  log, [](double x) { return std::log(x); }, 0.999, 1.001, 1e-12),
              1e-14);
    EXPECT_DOUBLE_EQ(log(std::numeric_limits<double>::denorm_min()), -744.44007192138122);
    EXPECT_EQ(exp(-1000.0), 0.0);
    EXPECT_EQ(exp(1000.0), kInfinity);
    EXPECT_EQ(exp(0.0), 1.0);
    EXPECT_EQ(log(0.0), -kInfinity);
    EXPECT_TRUE(std::isnan(log(-1.0)));
}

TEST(Math, PowersAreGoodTo14Digits) {
    for (double y : {-3.0, -0.5, 1.0 / 3.0, 2.0 / 7.0, 1.4, 5.25588})
        EXPECT_LT(worst([y](double x) { return pow(x, y); }, [y](double x) { return std::pow(x, y); }, 0.01,
                        40.0, 0.0),
                  1e-14)
            << y;
    EXPECT_EQ(pow(0.0, 2.0), 0.0);
    EXPECT_EQ(pow(-4.0, 0.0), 1.0);
    EXPECT_TRUE(std::isnan(pow(-1.0, 0.5)));
}
}  // namespace luftpost::core
