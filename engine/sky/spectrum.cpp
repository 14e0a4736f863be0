#include "engine/sky/spectrum.h"

#include <array>
#include <cmath>

namespace luftpost::sky {
namespace {
/// A bell whose two halves have their own widths.
double bell(double x, double middle, double below, double above) {
    double const t = (x - middle) / (x < middle ? below : above);
    return std::exp(-0.5 * t * t);
}

glm::dvec3 matching(double nm) {
    return {1.056 * bell(nm, 599.8, 37.9, 31.0) + 0.362 * bell(nm, 442.0, 16.0, 26.7) - 0.065 * bell(nm, 501.1, 20.4, 26.2),
            0.821 * bell(nm, 568.8, 46.9, 40.5) + 0.286 * bell(nm, 530.9, 16.3, 31.1),
            1.217 * bell(nm, 437.0, 11.8, 36.0) + 0.681 * bell(nm, 459.0, 26.0, 13.8)};
}

glm::dvec3 rec709(glm::dvec3 const& xyz) {
    return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
            0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

std::array<glm::dvec3, kWavelengths> colours() {
    std::array<glm::dvec3, kWavelengths> all;
    glm::dvec3 sum{0.0};
    for (int i = 0; i < kWavelengths; ++i) sum += all[static_cast<std::size_t>(i)] = rec709(matching(wavelength_nm(i)));
    for (glm::dvec3& colour : all) colour /= sum;
    return all;
}
}  // namespace

glm::dvec3 spectralColour(int i) {
    static std::array<glm::dvec3, kWavelengths> const all = colours();
    return all[static_cast<std::size_t>(i)];
}

double waterIndex(double nm) {
    constexpr double kCelsius = 20.0;
    return 1.31405 - 2.02e-6 * kCelsius * kCelsius + (15.868 - 0.00423 * kCelsius) / nm - 4382.0 / (nm * nm) + 1.1455e6 / (nm * nm * nm);
}

double iceIndex(double nm) {
    double const x = 1e5 / (nm * nm);  // 0.625 at 400 nm, 0.3306 at 550, 0.2041 at 700
    return 1.3069 + 0.03241 * (x - 0.2041) - 0.00922 * (x - 0.2041) * (x - 0.3306);
}
}  // namespace luftpost::sky
