#include "engine/core/math.h"

#include <bit>
#include <cstdint>
#include <limits>

#include "engine/core/frames.h"

namespace luftpost::core {
namespace {
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// To the nearest whole number, halves away from zero. |x| < 2^62.
std::int64_t nearest(double x) { return static_cast<std::int64_t>(x + (x < 0.0 ? -0.5 : 0.5)); }

/// 2^exponent for -1022 <= exponent <= 1023.
double powerOfTwo(std::int64_t exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// Taylor series: on |x| <= pi/4 the first term left out is below 1e-17 of the sum.
double sinSeries(double x) {
    double const s = x * x;
    double sum = 1.0;
    for (int n = 17; n > 1; n -= 2) sum = 1.0 - s * (1.0 / (n * (n - 1))) * sum;
    return x * sum;
}
double cosSeries(double x) {
    double const s = x * x;
    double sum = 1.0;
    for (int n = 18; n > 0; n -= 2) sum = 1.0 - s * (1.0 / (n * (n - 1))) * sum;
    return sum;
}

struct Octant {
    double rest;           // -pi/4..pi/4
    std::int64_t quarter;  // 0..3, quarter turns taken away
};
/// x less the nearest multiple of pi/2, which is subtracted in three parts so that no bits are lost: the
/// first two parts have 33 bits, so that their products with the count are exact (Cody and Waite).
Octant reduced(double x) {
    constexpr double kFirst = 0x1.921fb544p+0, kSecond = 0x1.0b4611a6p-34, kThird = 0x1.3198a2e037073p-69;
    if (x > 1.0e15 || x < -1.0e15) x = std::fmod(x, 2.0 * kPi);  // fmod is exact
    std::int64_t const count = nearest(x * (2.0 / kPi));
    double const n = static_cast<double>(count);
    return {((x - n * kFirst) - n * kSecond) - n * kThird, ((count % 4) + 4) % 4};
}
bool isFinite(double x) { return x - x == 0.0; }
}  // namespace

double sin(double x) {
    if (!isFinite(x)) return kNan;
    auto const [rest, quarter] = reduced(x);
    double const value = quarter % 2 == 0 ? sinSeries(rest) : cosSeries(rest);
    return quarter < 2 ? value : -value;
}

double cos(double x) {
    if (!isFinite(x)) return kNan;
    auto const [rest, quarter] = reduced(x);
    double const value = quarter % 2 == 0 ? cosSeries(rest) : sinSeries(rest);
    return quarter == 0 || quarter == 3 ? value : -value;
}

double tan(double x) {
    if (!isFinite(x)) return kNan;
    auto const [rest, quarter] = reduced(x);
    return quarter % 2 == 0 ? sinSeries(rest) / cosSeries(rest) : -cosSeries(rest) / sinSeries(rest);
}

double atan(double x) {
    if (x != x) return kNan;
    if (x < 0.0) return -atan(-x);
    if (x > 1.0) return kPi / 2.0 - atan(1.0 / x);
    // atan x = atan c + atan((x - c) / (1 + x c)) with the nearest quarter c: the series then sees |t| <=
    // 1/8.
    constexpr double kAtanOfQuarters[] = {0.0, 0.24497866312686414, 0.46364760900080609, 0.64350110879328437,
                                          0.78539816339744831};
    auto const quarters = nearest(4.0 * x);
    double const c = 0.25 * static_cast<double>(quarters);
    double const t = (x - c) / (1.0 + x * c), s = t * t;
    double sum = 0.0;
    for (int n = 19; n >= 1; n -= 2) sum = 1.0 / n - s * sum;
    return kAtanOfQuarters[quarters] + t * sum;
}

double atan2(double y, double x) {
    if (x != x || y != y) return kNan;
    if (x == 0.0) return y > 0.0 ? kPi / 2.0 : y < 0.0 ? -kPi / 2.0 : 0.0;
    if (!isFinite(x) && !isFinite(y)) return (y > 0.0 ? 1.0 : -1.0) * (x > 0.0 ? 0.25 : 0.75) * kPi;
    double const angle = atan(y / x);
    if (x > 0.0) return angle;
    return y < 0.0 ? angle - kPi : angle + kPi;
}

double asin(double x) {
    if (!(x >= -1.0 && x <= 1.0)) return kNan;
    return atan2(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double acos(double x) {
    if (!(x >= -1.0 && x <= 1.0)) return kNan;
    return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

double exp(double x) {
    if (x != x) return kNan;
    if (x > 709.79) return kInfinity;
    if (x < -746.0) return 0.0;
    // x = n ln 2 + r: ln 2 in two parts, the first short enough that n times it is exact.
    constexpr double kLn2High = 0x1.62e42fefp-1, kLn2Low = 0x1.473de6af278edp-34;
    std::int64_t const n = nearest(x / (kLn2High + kLn2Low));
    double const r = (x - static_cast<double>(n) * kLn2High) - static_cast<double>(n) * kLn2Low;
    double sum = 1.0;
    for (int i = 14; i >= 1; --i) sum = 1.0 + r * (1.0 / i) * sum;
    // In two factors, so that neither leaves the range of normal numbers.
    return sum * powerOfTwo(n / 2) * powerOfTwo(n - n / 2);
}

double log(double x) {
    if (!(x >= 0.0)) return kNan;
    if (x == 0.0) return -kInfinity;
    if (!isFinite(x)) return kInfinity;
    std::int64_t exponent = 0;
    if (x < 0x1p-1022) x *= 0x1p54, exponent = -54;
    auto bits = std::bit_cast<std::uint64_t>(x);
    exponent += static_cast<std::int64_t>(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);  // 1..2
    if (m > 1.4142135623730951) m *= 0.5, ++exponent;
    // log m = 2 artanh((m - 1) / (m + 1)); the series sees |s| < 0.172.
    double const s = (m - 1.0) / (m + 1.0), s2 = s * s;
    double sum = 0.0;
    for (int n = 21; n >= 1; n -= 2) sum = 1.0 / n + s2 * sum;
    constexpr double kLn2High = 0x1.62e42fefp-1, kLn2Low = 0x1.473de6af278edp-34;
    double const e = static_cast<double>(exponent);
    return e * kLn2High + (2.0 * s * sum + e * kLn2Low);
}

double pow(double x, double y) {
    if (y == 0.0) return 1.0;
    if (x == 0.0) return y > 0.0 ? 0.0 : kInfinity;
    return exp(y * log(x));
}
}  // namespace luftpost::core
