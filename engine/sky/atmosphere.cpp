#include "engine/sky/atmosphere.h"

#include <algorithm>
#include <cmath>

#include "engine/sky/light.h"
#include "shaders/lib/atmosphere.glsl"

namespace luftpost::sky {
namespace {
constexpr int kTransmittanceWidth = 64, kTransmittanceHeight = 32;
constexpr int kMultipleWidth = 32, kMultipleHeight = 12;
constexpr int kMultipleDirections = 6;   // squared
constexpr int kIrradianceRings = 8, kIrradianceSectors = 8;
constexpr int kSteps = 24;

// 1/m at sea level, and at 25 km: the spectral scattering (Teillet 1990) and absorption (Chappuis' band) of sunlight, weighed
// with the eye's curves and brought to Rec. 709, over sunlight itself. Its negative lobes make both steeper than the
// wavelengths of its primaries would; blue loses nothing to ozone.
constexpr glm::vec3 kRayleigh{6.35e-6f, 12.35e-6f, 29.3e-6f};
constexpr glm::vec3 kOzone{2.6e-6f, 1.65e-6f, 0.0f};
constexpr double kHighHaze = 2.25e-6;                        // 1/m: what airAt adds at sea level whatever the weather
constexpr double kThickestHaze = 3.0 / 12000.0;              // 1/m
constexpr float kHazeAlbedo = 0.92f, kFogAlbedo = 0.998f;   // soot absorbs, water does not
constexpr float kGreenWavelength = 545.0f;                   // nm

glm::vec2 sizeOf(int width, int height) { return {static_cast<float>(width), static_cast<float>(height)}; }
glm::vec2 const kTransmittanceSize = sizeOf(kTransmittanceWidth, kTransmittanceHeight);
glm::vec2 const kMultipleSize = sizeOf(kMultipleWidth, kMultipleHeight);

glm::vec3 hazeColour(float green) {
    auto const at = [&](float wavelength) { return green * std::pow(wavelength / kGreenWavelength, -1.2f); };
    return {at(615.0f), at(545.0f), at(465.0f)};
}

template <class Texel>
std::vector<glm::vec4> table(int width, int height, Texel texel) {
    std::vector<glm::vec4> texels;
    texels.reserve(static_cast<std::size_t>(width * height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec2 const centre{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            texels.push_back(texel(centre / sizeOf(width, height)));
        }
    return texels;
}
}  // namespace

glsl::Atmosphere atmosphere(AirConditions const& conditions) {
    double const wanted = 3.0 / std::max(conditions.visibility, 20.0) - static_cast<double>(kRayleigh.y) - kHighHaze;
    double const haze = std::clamp(wanted, 0.0, kThickestHaze);
    double const fog = std::max(wanted - haze, 0.0);
    double const direct = directShareUnder(conditions.cover);
    auto const f = [](double value) { return static_cast<float>(value); };
    glsl::Atmosphere air;
    air.rayleigh = glm::vec4{kRayleigh, 8000.0f};
    air.haze = glm::vec4{hazeColour(f(haze)), 1800.0f};
    air.ozone = glm::vec4{kOzone, kFogAlbedo};
    air.fog = glm::vec4{f(fog), f(std::max(conditions.fogDepth, 20.0)), f(conditions.groundAltitude), kHazeAlbedo};
    air.cover = glm::vec4{f(conditions.cloudBase), f(direct), f(conditions.cloudTop), f(conditions.cloudAlbedo)};
    air.under = glm::vec4{0.0f, 0.0f, 0.0f, 0.0f};
    air.ground = glm::vec4{0.0f, 0.0f, 0.0f, f(conditions.groundAlbedo)};
    return air;
}

double globalShareUnder(double cover, double closedShare) {
    return 1.0 - (1.0 - closedShare) * std::pow(std::clamp(cover, 0.0, 1.0), 3.4);
}
double directShareUnder(double cover) { return std::pow(1.0 - std::clamp(cover, 0.0, 1.0), 1.5); }

AtmosphereTables::AtmosphereTables(glsl::Atmosphere const& air) : air_{air} {
    transmittance_ = table(kTransmittanceWidth, kTransmittanceHeight, [&](glm::vec2 uv) {
        glm::vec2 const argument = glsl::transmittanceArgument(kTransmittanceSize, uv);
        return glm::vec4{glsl::transmittanceToTopExact(air_, argument.x, argument.y), 1.0f};
    });
    multiple_ = table(kMultipleWidth, kMultipleHeight, [&](glm::vec2 uv) {
        glm::vec2 const argument = glsl::multipleArgument(kMultipleSize, uv);
        return glsl::multipleExact(air_, transmittanceTable(), kTransmittanceSize, argument.x, argument.y,
                                   kMultipleDirections);
    });
}

glsl::sampler2D AtmosphereTables::transmittanceTable() const {
    return {transmittance_.data(), kTransmittanceWidth, kTransmittanceHeight};
}

glsl::sampler2D AtmosphereTables::multipleTable() const {
    return {multiple_.data(), kMultipleWidth, kMultipleHeight};
}

glm::vec3 AtmosphereTables::direct(double altitude, double elevation, double angularRadius) const {
    return glsl::lightThroughAir(transmittanceTable(), kTransmittanceSize, static_cast<float>(std::max(altitude, 0.0)),
                                 static_cast<float>(std::sin(elevation)), static_cast<float>(angularRadius));
}

glm::vec3 AtmosphereTables::radiance(double altitude, glm::dvec3 const& direction, glm::dvec3 const& light) const {
    return glsl::airLight(air_, transmittanceTable(), kTransmittanceSize, multipleTable(), kMultipleSize,
                          static_cast<float>(std::max(altitude, 0.0)), static_cast<float>(direction.y),
                          static_cast<float>(light.y), static_cast<float>(glm::dot(direction, light)), kSteps)
        .radiance;
}

glm::vec3 AtmosphereTables::skyIrradiance(double altitude, double elevation) const {
    glm::dvec3 const light = directionWorld(0.0, elevation);
    glm::vec3 sum{0.0f};
    for (int ring = 0; ring < kIrradianceRings; ++ring) {
        // Rings of equal share of a plane's irradiance: sin^2 of the zenith angle is uniform.
        double const up = std::asin(std::sqrt((ring + 0.5) / kIrradianceRings));
        for (int sector = 0; sector < kIrradianceSectors; ++sector) {
            double const around = core::kPi * (sector + 0.5) / kIrradianceSectors;
            sum += radiance(altitude, directionWorld(around, up), light);
        }
    }
    return sum * static_cast<float>(core::kPi / (kIrradianceRings * kIrradianceSectors));
}

glm::vec3 AtmosphereTables::transmittance(double altitude, double elevation, double distance) const {
    return glm::exp(-glsl::opticalDepth(air_, static_cast<float>(std::max(altitude, 0.0)),
                                        static_cast<float>(std::sin(elevation)), static_cast<float>(distance), kSteps));
}
}  // namespace luftpost::sky
