// The raw land: the landscape before the home airfield is laid into it. One branch-free function of a point, written so
// that the compiler turns a loop over points into vector code; every lane is computed as if alone, so vector and scalar
// give the same bits (no contraction, + - x / sqrt only).
//
// It is built the way land is: broad swells of the plain (whose hollows hold the lakes), ranges that rise where the crust
// is pushed up, wide valleys cut through them, and gullies that run down whatever slope the rest has made. For the last
// step the slope must be known, so everything is carried with its derivatives (forward differentiation in two variables).
#pragma once
#include <cstdint>

namespace luftpost::terrain::raw {
#define LUFTPOST_LANE __attribute__((always_inline)) inline

/// A value with its derivatives toward east and north.
struct Dual {
    float v, e, n;
};
LUFTPOST_LANE Dual operator+(Dual a, Dual b) { return {a.v + b.v, a.e + b.e, a.n + b.n}; }
LUFTPOST_LANE Dual operator-(Dual a, Dual b) { return {a.v - b.v, a.e - b.e, a.n - b.n}; }
LUFTPOST_LANE Dual operator*(Dual a, Dual b) { return {a.v * b.v, a.e * b.v + a.v * b.e, a.n * b.v + a.v * b.n}; }
LUFTPOST_LANE Dual operator*(float k, Dual a) { return {k * a.v, k * a.e, k * a.n}; }
LUFTPOST_LANE Dual operator+(Dual a, float k) { return {a.v + k, a.e, a.n}; }
LUFTPOST_LANE Dual operator-(float k, Dual a) { return {k - a.v, -a.e, -a.n}; }

__attribute__((always_inline, optimize("no-math-errno"))) inline float root(float x) { return __builtin_sqrtf(x); }
LUFTPOST_LANE float clamp01(float x) {
    float const low = x < 0.0f ? 0.0f : x;
    return low > 1.0f ? 1.0f : low;
}

/// |a| with its crease rounded over a width of `softness`.
LUFTPOST_LANE Dual softAbs(Dual a, float softness) {
    float const r = root(a.v * a.v + softness * softness);
    float const slope = a.v / r;
    return {r - softness, slope * a.e, slope * a.n};
}
/// 0 below `from`, 1 above `to`, with a smooth slope and curvature between.
LUFTPOST_LANE Dual rise(Dual a, float from, float to) {
    float const t = clamp01((a.v - from) / (to - from));
    float const slope = 30.0f * t * t * (1.0f - t) * (1.0f - t) / (to - from);
    return {t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f), slope * a.e, slope * a.n};
}

LUFTPOST_LANE int floorOf(double x) {
    int const i = static_cast<int>(x);
    return i - (x < static_cast<double>(i) ? 1 : 0);
}
/// An integer hash of a cell: multiply and xor-shift rounds.
LUFTPOST_LANE std::uint32_t hashOf(int x, int y, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u + static_cast<std::uint32_t>(y) * 0x85ebca77u + seed;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 13)) * 0x297a2d39u;
    return h ^ (h >> 16);
}
LUFTPOST_LANE float low(std::uint32_t h) { return static_cast<float>(static_cast<int>(h & 0xffffu)) * (1.0f / 32768.0f) - 1.0f; }
LUFTPOST_LANE float high(std::uint32_t h) { return static_cast<float>(static_cast<int>(h >> 16)) * (1.0f / 32768.0f) - 1.0f; }

/// Gradient noise with a quintic fade, about -1..1, cells `wavelength` metres wide; derivatives per metre.
LUFTPOST_LANE Dual noise(double east, double north, float wavelength, std::uint32_t seed) {
    double const x = east * (1.0 / static_cast<double>(wavelength)), y = north * (1.0 / static_cast<double>(wavelength));
    int const i = floorOf(x), j = floorOf(y);
    float const fx = static_cast<float>(x - i), fy = static_cast<float>(y - j);
    float const gx = fx - 1.0f, gy = fy - 1.0f;
    std::uint32_t const h00 = hashOf(i, j, seed), h10 = hashOf(i + 1, j, seed);
    std::uint32_t const h01 = hashOf(i, j + 1, seed), h11 = hashOf(i + 1, j + 1, seed);
    float const a = low(h00) * fx + high(h00) * fy, b = low(h10) * gx + high(h10) * fy;
    float const c = low(h01) * fx + high(h01) * gy, d = low(h11) * gx + high(h11) * gy;
    float const u = fx * fx * fx * (fx * (fx * 6.0f - 15.0f) + 10.0f), du = 30.0f * fx * fx * gx * gx;
    float const v = fy * fy * fy * (fy * (fy * 6.0f - 15.0f) + 10.0f), dv = 30.0f * fy * fy * gy * gy;
    float const k = a - b - c + d;
    float const value = a + u * (b - a) + v * (c - a) + u * v * k;
    float const de = low(h00) + u * (low(h10) - low(h00)) + v * (low(h01) - low(h00)) +
                     u * v * (low(h00) - low(h10) - low(h01) + low(h11)) + du * (b - a + v * k);
    float const dn = high(h00) + u * (high(h10) - high(h00)) + v * (high(h01) - high(h00)) +
                     u * v * (high(h00) - high(h10) - high(h01) + high(h11)) + dv * (c - a + u * k);
    constexpr float kScale = 1.7f;  // gradients are uniform in a square: this brings the noise to -1..1
    float const perMetre = kScale / wavelength;
    return {kScale * value, de * perMetre, dn * perMetre};
}

/// cos and sin of 2 pi t by polynomials, t in turns of size below 1000: good to 1e-4.
LUFTPOST_LANE void cosSinTurns(float t, float& c, float& s) {
    float const shifted = t + 1024.0f + 0.5f;
    float const whole = static_cast<float>(static_cast<int>(shifted)) - 1024.0f;
    float const x = t - whole;  // -0.5..0.5 of a turn
    float const q = x * x;
    // sin(2 pi x) = x (1 - 4 x^2) p(x^2), exact at 0 and +-1/2; cos(2 pi x) = 1 - 2 sin^2(pi x).
    s = x * (1.0f - 4.0f * q) * (6.2831853f - q * (16.2092f - 13.2f * q));
    float const halfTurn = x * (3.1415927f - q * (5.1677128f - q * (2.5501640f - q * 0.5992645f)));
    c = 1.0f - 2.0f * halfTurn * halfTurn;
}

/// Gullies: grooves `spacing` metres apart that run down `slope`, each cell's with its own place across the slope, blended
/// between cells by weight and brought back to full depth by the length of the blended wave. -1 in the groove, 1 on the
/// spur; derivatives per metre, as if the direction did not change.
LUFTPOST_LANE Dual gullies(double east, double north, float spacing, float sideE, float sideN, std::uint32_t seed) {
    constexpr double kCell = 1.25;  // cells this wide, in spacings
    double const cell = static_cast<double>(spacing) * kCell;
    double const x = east / cell, y = north / cell;
    int const i = floorOf(x), j = floorOf(y);
    float const fx = static_cast<float>(x - i), fy = static_cast<float>(y - j);
    float cosSum = 0.0f, sinSum = 0.0f;
#pragma GCC unroll 9
    for (int k = 0; k < 9; ++k) {
        int const di = k % 3 - 1, dj = k / 3 - 1;
        std::uint32_t const h = hashOf(i + di, j + dj, seed);
        float const dx = fx - (static_cast<float>(di) + 0.5f + 0.4f * low(h));
        float const dy = fy - (static_cast<float>(dj) + 0.5f + 0.4f * high(h));
        float const near = 1.0f - (dx * dx + dy * dy) * (1.0f / 1.21f);
        float const positive = near > 0.0f ? near : 0.0f;
        float const weight = positive * positive * positive;
        float c, s;
        cosSinTurns(static_cast<float>(kCell) * (dx * sideE + dy * sideN), c, s);
        cosSum += weight * c;
        sinSum += weight * s;
    }
    float const length = root(cosSum * cosSum + sinSum * sinSum + 0.03f);
    float const slope = -6.2831853f / spacing * sinSum / length;
    return {cosSum / length, slope * sideE, slope * sideN};
}

/// The raw land's height in metres over its own zero, at which its lakes stand.
LUFTPOST_LANE float height(double east, double north, std::uint32_t seed) {
    // Bend the map so that nothing runs straight; the bent map's own derivatives turn slopes back at the end.
    Dual const w1 = 3900.0f * noise(east, north, 23000.0f, seed + 1u) + 950.0f * noise(east, north, 5900.0f, seed + 3u);
    Dual const w2 = 3900.0f * noise(east, north, 23000.0f, seed + 2u) + 950.0f * noise(east, north, 5900.0f, seed + 4u);
    double const qe = east + static_cast<double>(w1.v), qn = north + static_cast<double>(w2.v);

    // How far the crust is pushed up here: 0 in the plains, 1 in the ranges.
    Dual const push = 0.75f * noise(east, north, 130000.0f, seed + 5u) + 0.8f * noise(qe, qn, 47000.0f, seed + 6u);
    Dual const uplift = rise(push, -0.1f, 0.5f);

    // The plain: broad swells. Below zero there is a lake.
    Dual const swell = 120.0f * noise(qe, qn, 33000.0f, seed + 7u) + 70.0f * noise(qe, qn, 9700.0f, seed + 8u);
    Dual const plain = swell + 40.0f;

    // Wide valleys along the lines where a noise is zero, through plains (shallow) and ranges (to the floor).
    Dual const course = softAbs(noise(qe, qn, 19000.0f, seed + 9u), 0.02f);
    Dual const valley = rise(course, 0.0f, 0.42f);
    Dual const relief = uplift * (0.86f * valley + 0.14f);
    Dual const foothills = rise(push, -0.5f, 0.2f) * (0.75f * valley + 0.25f);

    // Ranges: ridged octaves, each one strong where the one before stood high.
    Dual const r1 = 1.0f - 2.1f * softAbs(noise(qe, qn, 13500.0f, seed + 10u), 0.03f);
    Dual const r2 = 1.0f - 2.1f * softAbs(noise(qe, qn, 6300.0f, seed + 11u), 0.04f);
    Dual const r3 = 1.0f - 2.1f * softAbs(noise(qe, qn, 3000.0f, seed + 12u), 0.06f);
    Dual const r4 = 1.0f - 2.1f * softAbs(noise(qe, qn, 1430.0f, seed + 13u), 0.08f);
    Dual const ridges = 0.50f * (r1 * r1) + 0.34f * (r1 * (r2 * r2)) + 0.17f * (r1 * (r2 * r3)) + 0.075f * (r2 * (r3 * r4));

    // Hills of the lowland, and the small forms everywhere; gentler by the square of their size, so that a coarse mesh fits.
    Dual const rough = 0.8f * noise(qe, qn, 14000.0f, seed + 14u) + 0.5f;
    Dual const hills = 105.0f * noise(qe, qn, 4700.0f, seed + 15u) + 46.0f * softAbs(noise(qe, qn, 2100.0f, seed + 16u), 0.08f) +
                       13.0f * noise(east, north, 980.0f, seed + 17u);

    Dual const downs = 210.0f * (r2 * r2) + 120.0f * (r3 * (0.5f * r2 + 0.5f)) + 34.0f * (r4 * r3);
    Dual const q = plain + rough * hills + foothills * downs + relief * (2050.0f * ridges + 280.0f);
    // d/dx of f(x + w(x)): the transposed Jacobian of the bent map.
    float const slopeE = q.e * (1.0f + w1.e) + q.n * w2.e, slopeN = q.e * w1.n + q.n * (1.0f + w2.n);

    // Gullies down the slope, three sizes, each following the slope the larger ones left. On gentle slopes they widen
    // (the 0.1) and vanish, so that no groove turns sharply where the slope turns over at a crest.
    float total = q.v, gE = slopeE, gN = slopeN;
    auto const erode = [&](float spacing, float depth, std::uint32_t salt) __attribute__((always_inline)) {
        float const steep = root(gE * gE + gN * gN + 1e-6f);
        float const share = clamp01(steep * 2.8f - 0.06f);
        float const amplitude = depth * spacing * share * share * (3.0f - 2.0f * share);
        Dual const g = gullies(east, north, spacing, -gN / (steep + 0.1f), gE / (steep + 0.1f), seed + salt);
        total += amplitude * (g.v - 0.35f);
        gE += amplitude * g.e;
        gN += amplitude * g.n;
    };
    erode(1250.0f, 0.060f, 20u);
    erode(560.0f, 0.044f, 21u);
    erode(250.0f, 0.0f, 22u);

    float const small = 4.2f * noise(east, north, 430.0f, seed + 23u).v + 1.3f * noise(east, north, 190.0f, seed + 24u).v +
                        0.34f * noise(east, north, 83.0f, seed + 25u).v;
    return total + small * (0.35f + rough.v);
}
#undef LUFTPOST_LANE
}  // namespace luftpost::terrain::raw
