// The sky of the tables against light followed path by path: what the tables leave out (light that went astray is taken as
// even, the integrals have few steps) must stay small.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "engine/sky/atmosphere.h"
#include "engine/sky/light.h"
#include "shaders/lib/atmosphere.glsl"

namespace {
using namespace luftpost;

constexpr double kCell = 100.0;  // m
constexpr int kCells = 1000;     // up to the top of the air

/// A flat air of one colour, backward from an eye on the ground, the sun connected at every turn. Flat is right to a
/// percent for rays and suns above 15 degrees.
class Paths {
public:
    Paths(glsl::Atmosphere const& air, int colour, double sunUp, std::uint64_t seed)
        : air_{air}, colour_{colour}, sun_{sky::directionWorld(0.0, sunUp)}, albedo_{static_cast<double>(air.ground.w)}, random_{seed} {
        for (int i = kCells; i-- > 0;) {
            double const e = static_cast<double>(at((i + 0.5) * kCell).extinction[colour]);
            above_[static_cast<std::size_t>(i)] = above_[static_cast<std::size_t>(i) + 1] + e * kCell;
        }
    }

    double radiance(glm::dvec3 const& toward, int paths) {
        double sum = 0.0;
        for (int i = 0; i < paths; ++i) sum += onePath(toward);
        return sum / paths;
    }

private:
    glsl::AirAt at(double h) const { return glsl::airAt(air_, static_cast<float>(h)); }
    double uniform() { return std::uniform_real_distribution<double>{}(random_); }
    double toSun(double depthAbove) const { return std::exp(-depthAbove / sun_.y); }

    double depthAbove(double h) const {
        double const x = std::min(h / kCell, kCells - 1e-6);
        auto const i = static_cast<std::size_t>(x);
        return glm::mix(above_[i], above_[i + 1], x - static_cast<double>(i));
    }
    double heightOfDepth(double depth) const {
        std::size_t low = 0, high = kCells;
        while (high - low > 1) (above_[(low + high) / 2] > depth ? low : high) = (low + high) / 2;
        return kCell * (static_cast<double>(low) + (above_[low] - depth) / std::max(above_[low] - above_[high], 1e-12));
    }
    glm::dvec3 turned(glm::dvec3 const& d, double cosine) {
        glm::dvec3 const side = glm::normalize(glm::cross(d, std::abs(d.x) < 0.7 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 0, 1}));
        double const around = 2.0 * core::kPi * uniform(), sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
        return glm::normalize(cosine * d + sine * (std::cos(around) * side + std::sin(around) * glm::cross(d, side)));
    }

    double onePath(glm::dvec3 d) {
        double sum = 0.0, weight = 1.0, h = 2.0;
        for (int turn = 0; turn < 40; ++turn) {
            double const reach = d.y > 0.0 ? depthAbove(h) / d.y : (above_[0] - depthAbove(h)) / -d.y;
            double const share = turn == 0 ? 1.0 - std::exp(-reach) : 1.0;  // the first turn always comes
            weight *= share;
            double const depth = -std::log(1.0 - uniform() * share);
            if (depth >= reach && d.y > 0.0) break;
            if (depth >= reach) {
                weight *= albedo_;
                sum += weight * toSun(above_[0]) * sun_.y / core::kPi;
                d = turned({0.0, 1.0, 0.0}, std::sqrt(uniform()));
                h = 0.0;
                continue;
            }
            h = heightOfDepth(depthAbove(h) - depth * d.y);
            glsl::AirAt const here = at(h);
            double const rayleigh = static_cast<double>(here.rayleigh[colour_]), haze = static_cast<double>(here.haze[colour_]);
            weight *= (rayleigh + haze) / static_cast<double>(here.extinction[colour_]);
            double const hazy = haze / (rayleigh + haze);
            sum += weight * toSun(depthAbove(h)) * phase(glm::dot(d, sun_), hazy);
            // Straight from an even choice of directions: the weight is the phase over the even one.
            double const cosine = 2.0 * uniform() - 1.0;
            weight *= 4.0 * core::kPi * phase(cosine, hazy);
            d = turned(d, cosine);
        }
        return sum;
    }
    static double phase(double cosine, double hazy) {
        auto const nu = static_cast<float>(cosine);
        return glm::mix(static_cast<double>(glsl::rayleighPhase(nu)), static_cast<double>(glsl::hazePhase(nu)), hazy);
    }

    glsl::Atmosphere air_;
    int colour_;
    glm::dvec3 sun_;
    double albedo_;
    std::mt19937_64 random_;
    std::vector<double> above_ = std::vector<double>(kCells + 1, 0.0);
};

// Measured: 0 to 10 % too bright.
TEST(AtmospherePaths, TheTablesSkyIsThatOfLightFollowedPathByPath) {
    sky::AtmosphereTables const tables{sky::atmosphere({})};
    for (double sun_deg : {30.0, 60.0})
        for (double elevation_deg : {90.0, 45.0, 15.0}) {
            double const sun = core::radians(sun_deg);
            glm::dvec3 const toward = sky::directionWorld(core::kPi / 2.0, core::radians(elevation_deg));
            glm::vec3 paths;
            for (int colour = 0; colour < 3; ++colour) paths[colour] = static_cast<float>(Paths{tables.air(), colour, sun, 7}.radiance(toward, 20000));
            float const ours = sky::luminance(tables.radiance(2.0, toward, sky::directionWorld(0.0, sun)));
            EXPECT_NEAR(ours / sky::luminance(paths), 1.0f, 0.12f) << sun_deg << " " << elevation_deg;
        }
}
}  // namespace
