// Functions whose bits are the same on every machine: the standard library picks other variants by processor.
// Built from + - x / and sqrt alone. Everything that changes the flight uses these. Pure, any thread.
#pragma once
#include <cmath>

namespace luftpost::core {
/// Radians. Relative error below 1e-14 (absolute near the zeros) for |x| < 1e6; beyond, bounded but ever less
/// exact. NaN for what is not finite.
double sin(double x);
double cos(double x);
double tan(double x);
/// NaN outside -1..1.
double asin(double x);
double acos(double x);
double atan(double x);
/// -pi..pi; 0 for (0, 0).
double atan2(double y, double x);
/// 0 below the smallest number, infinity above the largest.
double exp(double x);
/// Natural. -infinity at 0, NaN below.
double log(double x);
/// exp(y log x) for x > 0 (relative error about 2e-16 |y log x|); 0 at x = 0 with y > 0; 1 at y = 0; NaN for
/// x < 0.
double pow(double x, double y);
}  // namespace luftpost::core
