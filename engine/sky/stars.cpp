#include "engine/sky/stars.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/sky/light.h"

namespace luftpost::sky {
namespace {
constexpr Star kBrightStars[] = {
    {6.752f, -16.716f, -1.46f, 0.00f},  {6.399f, -52.696f, -0.72f, 0.15f},  {14.660f, -60.834f, -0.27f, 0.71f},
    {14.261f, 19.182f, -0.04f, 1.23f},  {18.616f, 38.784f, 0.03f, 0.00f},   {5.278f, 45.998f, 0.08f, 0.80f},
    {5.242f, -8.202f, 0.12f, -0.03f},   {7.655f, 5.225f, 0.38f, 0.42f},     {1.629f, -57.237f, 0.46f, -0.16f},
    {5.919f, 7.407f, 0.50f, 1.85f},     {14.064f, -60.373f, 0.61f, -0.23f}, {19.846f, 8.868f, 0.77f, 0.22f},
    {12.443f, -63.099f, 0.77f, -0.24f}, {4.599f, 16.509f, 0.85f, 1.54f},    {16.490f, -26.432f, 0.96f, 1.83f},
    {13.420f, -11.161f, 0.98f, -0.23f}, {7.755f, 28.026f, 1.14f, 1.00f},    {22.961f, -29.622f, 1.16f, 0.09f},
    {12.795f, -59.689f, 1.25f, -0.23f}, {20.690f, 45.280f, 1.25f, 0.09f},   {10.139f, 11.967f, 1.35f, -0.11f},
    {6.977f, -28.972f, 1.50f, -0.21f},  {7.577f, 31.888f, 1.58f, 0.03f},    {12.519f, -57.113f, 1.63f, 1.59f},
    {17.560f, -37.104f, 1.63f, -0.22f}, {5.419f, 6.350f, 1.64f, -0.22f},    {5.438f, 28.608f, 1.65f, -0.13f},
    {9.220f, -69.717f, 1.68f, 0.00f},   {5.604f, -1.202f, 1.70f, -0.19f},   {22.137f, -46.961f, 1.74f, -0.13f},
    {5.679f, -1.943f, 1.77f, -0.21f},   {12.900f, 55.960f, 1.77f, -0.02f},  {8.159f, -47.337f, 1.78f, -0.22f},
    {3.405f, 49.861f, 1.79f, 0.48f},    {11.062f, 61.751f, 1.79f, 1.07f},   {7.140f, -26.393f, 1.84f, 0.68f},
    {18.403f, -34.385f, 1.85f, -0.03f}, {13.792f, 49.313f, 1.86f, -0.19f},  {8.375f, -59.510f, 1.86f, 1.28f},
    {17.622f, -42.998f, 1.87f, 0.40f},  {5.992f, 44.947f, 1.90f, 0.03f},    {16.811f, -69.028f, 1.92f, 1.44f},
    {6.629f, 16.399f, 1.93f, 0.00f},    {20.427f, -56.735f, 1.94f, -0.20f}, {8.745f, -54.709f, 1.96f, 0.04f},
    {6.378f, -17.956f, 1.98f, -0.23f},  {9.460f, -8.659f, 1.98f, 1.44f},    {2.530f, 89.264f, 2.02f, 0.60f},
    {2.120f, 23.462f, 2.00f, 1.15f},    {0.726f, -17.987f, 2.02f, 1.02f},   {18.921f, -26.297f, 2.02f, -0.22f},
    {1.162f, 35.621f, 2.06f, 1.58f},    {0.140f, 29.090f, 2.06f, -0.11f},   {14.111f, -36.370f, 2.06f, 1.01f},
    {5.796f, -9.670f, 2.06f, -0.17f},   {14.845f, 74.156f, 2.08f, 1.47f},   {17.582f, 12.560f, 2.08f, 0.15f},
    {22.711f, -46.885f, 2.10f, 1.60f},  {3.136f, 40.956f, 2.12f, -0.05f},   {11.818f, 14.572f, 2.14f, 0.09f},
    {12.692f, -48.960f, 2.17f, -0.01f}, {20.371f, 40.257f, 2.20f, 0.68f},   {9.133f, -43.433f, 2.21f, 1.66f},
    {15.578f, 26.715f, 2.23f, -0.02f},  {5.533f, -0.299f, 2.23f, -0.22f},   {0.675f, 56.537f, 2.23f, 1.17f},
    {17.943f, 51.489f, 2.23f, 1.52f},   {8.060f, -40.003f, 2.25f, -0.26f},  {9.285f, -59.275f, 2.25f, 0.18f},
    {2.065f, 42.330f, 2.26f, 1.37f},    {0.153f, 59.150f, 2.27f, 0.34f},    {13.399f, 54.925f, 2.27f, 0.02f},
    {16.836f, -34.293f, 2.29f, 1.15f},  {14.699f, -47.388f, 2.30f, -0.20f}, {13.665f, -53.466f, 2.30f, -0.22f},
    {14.592f, -42.158f, 2.31f, -0.19f}, {16.006f, -22.622f, 2.32f, -0.12f}, {11.031f, 56.382f, 2.37f, -0.02f},
    {14.750f, 27.074f, 2.37f, 0.97f},   {21.736f, 9.875f, 2.39f, 1.53f},    {17.708f, -39.030f, 2.41f, -0.22f},
    {0.438f, -42.306f, 2.39f, 1.09f},   {17.173f, -15.725f, 2.43f, 0.06f},  {11.897f, 53.695f, 2.44f, 0.00f},
    {23.063f, 28.083f, 2.42f, 1.67f},   {7.401f, -29.303f, 2.45f, -0.08f},  {21.310f, 62.586f, 2.44f, 0.22f},
    {20.770f, 33.970f, 2.46f, 1.03f},   {23.079f, 15.205f, 2.49f, -0.04f},  {0.945f, 60.717f, 2.47f, -0.15f},
    {9.368f, -55.011f, 2.50f, -0.18f},  {3.038f, 4.090f, 2.53f, 1.64f},     {13.926f, -47.288f, 2.55f, -0.22f},
    {11.235f, 20.524f, 2.56f, 0.12f},   {16.619f, -10.567f, 2.56f, 0.02f},  {5.545f, -17.822f, 2.58f, 0.21f},
    {12.140f, -50.722f, 2.60f, -0.12f}, {12.263f, -17.542f, 2.59f, -0.11f}, {19.044f, -29.880f, 2.60f, 0.08f},
    {10.333f, 19.842f, 2.28f, 1.15f},   {16.091f, -19.805f, 2.62f, -0.07f}, {15.283f, -9.383f, 2.61f, -0.11f},
    {17.507f, 52.301f, 2.79f, 0.98f},   {15.738f, 6.426f, 2.65f, 1.17f},    {19.771f, 10.613f, 2.72f, 1.52f},
    {20.628f, 14.595f, 3.63f, 0.44f},   {19.512f, 27.960f, 3.08f, 1.13f},   {19.750f, 45.131f, 2.87f, -0.03f},
    {12.257f, 57.033f, 3.31f, 0.08f},   {1.430f, 60.235f, 2.68f, 0.13f},    {1.907f, 63.670f, 3.38f, -0.15f},
    {3.791f, 24.105f, 2.87f, -0.09f},   {5.588f, -5.910f, 2.77f, -0.24f},   {5.586f, 9.934f, 3.66f, -0.18f}};

/// Linear Rec. 709 of a black body with luminance 1, from its place on the Planckian locus (Kim et al. 2002).
glm::vec3 blackBody(double kelvin) {
    double const t = std::clamp(kelvin, 1700.0, 25000.0);
    double const x = t < 4000.0 ? -0.2661239e9 / (t * t * t) - 0.2343589e6 / (t * t) + 0.8776956e3 / t + 0.179910
                                : -3.0258469e9 / (t * t * t) + 2.1070379e6 / (t * t) + 0.2226347e3 / t + 0.240390;
    double const y = t < 2222.0   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                     : t < 4000.0 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                  : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    glm::dvec3 const xyz{x / y, 1.0, (1.0 - x - y) / y};
    glm::dvec3 const rgb{3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                         -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                         0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
    return glm::vec3{glm::max(rgb, glm::dvec3{0.0})};
}

/// True when a star's glow reaches the cell.
bool reaches(Star const& star, int column, int row) {
    constexpr float kGlow = 1.0f;  // degrees
    float const south = -90.0f + 180.0f * static_cast<float>(row) / kStarRows;
    if (star.dec_deg < south - kGlow || star.dec_deg > south + 180.0f / kStarRows + kGlow) return false;
    float const circle = std::max(std::cos(static_cast<float>(core::radians(static_cast<double>(star.dec_deg)))), 0.02f);
    float const width = 360.0f / kStarColumns;
    float const middle = width * (static_cast<float>(column) + 0.5f);
    float const apart = std::abs(std::remainder(15.0f * star.ra_h - middle, 360.0f));
    return apart <= 0.5f * width + kGlow / circle;
}
}  // namespace

std::span<Star const> brightStars() { return kBrightStars; }

glm::vec3 starIrradiance(float magnitude, float colourIndex) {
    double const index = static_cast<double>(colourIndex);
    double const kelvin = 4600.0 * (1.0 / (0.92 * index + 1.7) + 1.0 / (0.92 * index + 0.62));
    double const lux = 2.54e-6 * std::pow(10.0, -0.4 * static_cast<double>(magnitude));
    return blackBody(kelvin) * static_cast<float>(lux / kSunIlluminance_lx);
}

glm::vec3 starDirection(Star const& star) {
    double const ra = core::radians(15.0 * static_cast<double>(star.ra_h));
    double const dec = core::radians(static_cast<double>(star.dec_deg));
    return glm::vec3{glm::dvec3{std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec)}};
}

StarGrid starGrid() {
    StarGrid grid;
    int first = 0;
    for (int row = 0; row < kStarRows; ++row)
        for (int column = 0; column < kStarColumns; ++column) {
            int count = 0;
            for (Star const& star : kBrightStars) {
                if (!reaches(star, column, row)) continue;
                grid.stars.emplace_back(starDirection(star), 0.0f);
                grid.stars.emplace_back(starIrradiance(star.magnitude, star.colourIndex), 0.0f);
                ++count;
            }
            grid.cells[static_cast<std::size_t>(row * kStarColumns + column)] = glm::ivec2{first, count};
            first += count;
        }
    return grid;
}
}  // namespace luftpost::sky
