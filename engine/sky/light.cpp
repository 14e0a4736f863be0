#include "engine/sky/light.h"

#include <algorithm>
#include <cmath>

#include "shaders/lib/atmosphere.glsl"
#include "shaders/lib/cloud_light.glsl"

namespace luftpost::sky {
namespace {
constexpr double kFullMoon_lx = 0.267;
// Share of the light from below that the air sends down again, at sea level, and m, the height over which that falls to 1 / e: so that the sky over a
// closed sheet is as much brighter as the path tracer has it (1.5 times about noon, 1.2 times with the sun 16 degrees up).
constexpr glm::vec3 kAirSendsDown{0.065f, 0.11f, 0.21f};
constexpr double kAirScale = 8000.0;
constexpr double kMeanMoonRadius = 0.004520;  // rad, at the mean distance

/// Direct irradiance on a horizontal plane.
glm::vec3 onThePlane(glm::vec3 const& facing, glm::dvec3 const& direction) {
    return facing * static_cast<float>(std::max(direction.y, 0.0));
}

/// Diffuse irradiance under clouds: what Kasten and Czeplak leave of the global one less the direct beam's share. Clouds do
/// not tint, but their tops see a light that half the air has not coloured yet: an overcast day is a little bluer than
/// the sun (6500 K; CIE D65).
glm::vec3 underCover(glm::vec3 const& sky, glm::vec3 const& direct, double cover, double closedShare) {
    double const share = globalShareUnder(cover, closedShare);
    glm::vec3 const clear = sky + direct;
    glm::vec3 const grey = luminance(clear) * glm::sqrt(clear / std::max(luminance(clear), 1e-20f)) * glm::vec3{0.97f, 1.0f, 1.06f};
    glm::vec3 const global = glm::mix(clear, grey, static_cast<float>(std::clamp(cover, 0.0, 1.0))) * static_cast<float>(share);
    glm::vec3 const left = global - direct * static_cast<float>(directShareUnder(cover));
    return glm::max(left, sky * static_cast<float>(share * (1.0 - cover)));
}
}  // namespace

glm::vec3 landAlbedo(AirConditions const& conditions) { return glsl::kLandColour * static_cast<float>(conditions.groundAlbedo); }

float luminance(glm::vec3 const& rgb) { return glm::dot(rgb, glm::vec3{0.2126f, 0.7152f, 0.0722f}); }

glm::vec3 airglowRadiance() {
    return glm::vec3{0.8f, 1.0f, 1.25f} * static_cast<float>(2.0e-4 / kSunIlluminance_lx);
}

glm::vec3 moonIrradiance(SkyState const& state) {
    double const phase = state.moonPhaseAngle;
    double const magnitudes = 1.49 * phase + 0.043 * std::pow(phase, 4.0);
    double const size = state.moonAngularRadius / kMeanMoonRadius;
    double const illuminance = kFullMoon_lx * std::pow(10.0, -0.4 * magnitudes) * size * size;
    return glm::vec3{1.08f, 1.0f, 0.86f} * static_cast<float>(illuminance / kSunIlluminance_lx);
}

SkyLight skyLight(SkyState const& state, AtmosphereTables const& tables, double altitude,
                  AirConditions const& conditions) {
    SkyLight light;
    double const sunUp = elevation(state.sunDirectionWorld);
    double const moonUp = elevation(state.moonDirectionWorld);
    light.moonAboveAir = moonIrradiance(state);
    light.sun = tables.direct(altitude, sunUp, state.sunAngularRadius);
    light.moon = light.moonAboveAir * tables.direct(altitude, moonUp, state.moonAngularRadius);
    light.skyClear = tables.skyIrradiance(altitude, sunUp) +
                     light.moonAboveAir * tables.skyIrradiance(altitude, moonUp) +
                     airglowRadiance() * static_cast<float>(core::kPi);
    glm::vec3 const direct = onThePlane(light.sun, state.sunDirectionWorld) + onThePlane(light.moon, state.moonDirectionWorld);
    // The land as the clouds above it leave it, which from above them is not how the light up here would.
    double const landCover = std::max(conditions.cover, conditions.landCover);
    glm::vec3 const onLand =
        underCover(light.skyClear, direct, landCover, conditions.closedShare) + direct * static_cast<float>(directShareUnder(landCover));
    float const over = static_cast<float>(glm::smoothstep(0.9 * conditions.cloudTop, 1.1 * conditions.cloudTop, altitude) * conditions.cloudAlbedo);
    light.skyClear += (light.skyClear + direct) * over * kAirSendsDown * static_cast<float>(std::exp(-altitude / kAirScale));
    light.sky = underCover(light.skyClear, direct, conditions.cover, conditions.closedShare);
    glm::vec3 const total = light.sky + direct * static_cast<float>(directShareUnder(conditions.cover));
    light.groundRadiance = onLand * landAlbedo(conditions) / static_cast<float>(core::kPi);
    light.ground = onLand * landAlbedo(conditions) + total * over;
    light.exposure = exposureFor(meanLuminance(light, state, conditions.cover));
    return light;
}

glm::vec2 landContrast(SkyLight const& light, SkyState const& state, AirConditions const& conditions) {
    glm::vec3 const direct = onThePlane(light.sun, state.sunDirectionWorld) + onThePlane(light.moon, state.moonDirectionWorld);
    double const sky = static_cast<double>(luminance(light.skyClear)), diffuse = sky / std::max(sky + static_cast<double>(luminance(direct)), 1e-12);
    double const cover = std::clamp(std::max(conditions.cover, conditions.landCover), 0.0, 1.0), mean = globalShareUnder(cover, conditions.closedShare);
    double const shade = std::lerp(diffuse, conditions.closedShare, cover);
    return glm::vec2{glm::dvec2{shade, shade + 1.0 - diffuse} / mean};
}

float meanLuminance(SkyLight const& light, SkyState const& state, double cover) {
    glm::vec3 const direct = onThePlane(light.sun, state.sunDirectionWorld) + onThePlane(light.moon, state.moonDirectionWorld);
    float const sky = luminance(light.sky) / static_cast<float>(core::kPi);
    float const land = luminance(light.sky + direct * static_cast<float>(directShareUnder(cover))) * 0.18f /
                       static_cast<float>(core::kPi);
    return 0.5f * (sky + land);
}

float exposureFor(float mean) { return glsl::exposureFor(mean); }
}  // namespace luftpost::sky
