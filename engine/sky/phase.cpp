#include "engine/sky/phase.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "shaders/lib/atmosphere.glsl"
#include "shaders/lib/cloud_light.glsl"

namespace luftpost::sky {
namespace {
/// The cosine below which a lobe of asymmetry g has the share `unit` of its light (Henyey and Greenstein 1941).
double lobeCosine(double g, double unit) {
    double const s = 2.0 * unit - 1.0;
    if (std::abs(g) < 1e-4) return s;
    double const q = (1.0 - g * g) / (1.0 + g * s);
    return std::clamp((1.0 + g * g - q * q) / (2.0 * g), -1.0, 1.0);
}

/// The same of Rayleigh's function: the root of c^3 + 3 c + 4 = 8 unit, by Cardano.
double rayleighCosine(double unit) {
    double const half = 4.0 * unit - 2.0;
    double const root = std::cbrt(half + std::sqrt(half * half + 1.0));
    return std::clamp(root - 1.0 / root, -1.0, 1.0);
}
}  // namespace

Phase Phase::rayleigh() {
    Phase phase{{}};
    phase.rayleigh_ = true;
    return phase;
}

Phase Phase::cloud(float g) {
    return Phase{{Lobe{1.0f - glsl::kBackwardShare, g}, Lobe{glsl::kBackwardShare, glsl::kBackward}}};
}

Phase Phase::haze() {
    return Phase{{Lobe{glsl::kHazeShares.x, glsl::kHazeLobes.x}, Lobe{glsl::kHazeShares.y, glsl::kHazeLobes.y},
                  Lobe{glsl::kHazeShares.z, glsl::kHazeLobes.z}}};
}

float Phase::at(float cosine) const {
    if (rayleigh_) return glsl::rayleighPhase(cosine);
    float sum = 0.0f;
    for (Lobe const& lobe : lobes_)
        if (lobe.share > 0.0f) sum += lobe.share * glsl::henyeyGreenstein(cosine, lobe.g);
    return sum;
}

double Phase::draw(core::Random& random) const {
    if (rayleigh_) return rayleighCosine(random.uniform(0.0, 1.0));
    double choice = random.uniform(0.0, 1.0);
    std::size_t lobe = 0;
    while (lobe + 1 < lobes_.size() && lobes_[lobe + 1].share > 0.0f && choice >= static_cast<double>(lobes_[lobe].share))
        choice -= static_cast<double>(lobes_[lobe++].share);
    return lobeCosine(static_cast<double>(lobes_[lobe].g), random.uniform(0.0, 1.0));
}

glm::dvec3 turned(glm::dvec3 const& direction, double cosine, core::Random& random) {
    double const sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    double const angle = random.uniform(0.0, 2.0 * core::kPi);
    // A frame around the direction without a square root (Duff et al. 2017, JCGT 6(1)).
    double const sign = std::copysign(1.0, direction.z);
    double const a = -1.0 / (sign + direction.z);
    double const b = direction.x * direction.y * a;
    glm::dvec3 const first{1.0 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x};
    glm::dvec3 const second{b, sign + direction.y * direction.y * a, -direction.y};
    return glm::normalize(direction * cosine + (first * std::cos(angle) + second * std::sin(angle)) * sine);
}

glm::dvec3 lambertian(glm::dvec3 const& normal, core::Random& random) {
    return turned(normal, std::sqrt(random.uniform(0.0, 1.0)), random);
}

glm::dvec3 isotropic(core::Random& random) {
    return turned({0.0, 1.0, 0.0}, random.uniform(-1.0, 1.0), random);
}
}  // namespace luftpost::sky
