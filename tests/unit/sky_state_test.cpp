// Sun, moon and stars against published figures.
#include "engine/sky/sky_state.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace luftpost;
using sky::skyState;

constexpr double utc(int days, double hours) { return 86400.0 * days + 3600.0 * hours; }

// NREL/TP-560-34302 (Reda & Andreas), the worked example: 2003-10-17T19:30:30Z.
constexpr double kNrelTime = utc(12342, 19.0 + 30.5 / 60.0);
constexpr core::Place kNrelPlace{39.742476, -105.1786, 1830.14};

TEST(SkyState, PutsTheSunWhereNrelsWorkedExampleHasIt) {
    auto const state = skyState(kNrelPlace, kNrelTime);
    EXPECT_NEAR(90.0 - core::degrees(sky::elevation(state.sunDirectionWorld)), 50.11161, 0.001);
    EXPECT_NEAR(core::degrees(sky::azimuth(state.sunDirectionWorld)), 194.34020, 0.001);
    EXPECT_NEAR(state.sunDistance_au, 0.9965422974, 5e-5);
}

TEST(SkyState, PutsTheMoonWhereErfaAloneHasItAtThatHour) {
    auto const state = skyState(kNrelPlace, kNrelTime);
    double const lift = sky::refraction(core::radians(5.14237), 81500.0, 276.2);
    EXPECT_NEAR(core::degrees(sky::elevation(state.moonDirectionWorld) - lift), 90.0 - 84.85763, 0.01);
    EXPECT_NEAR(core::degrees(sky::azimuth(state.moonDirectionWorld)), 300.05945, 0.01);
}

TEST(SkyState, HasTheMoonsUpperLimbOnTheHorizonAtRiseAndSet) {
    // US Naval Observatory, 81 W 29 N, January 2019; minutes rounded, in which the moon climbs 0.2 degrees.
    constexpr core::Place place{29.0, -81.0, 0.0};
    for (double time : {utc(17897, 8.0 + 12.0 / 60.0), utc(17897, 19.0 + 34.0 / 60.0), utc(17898, 9.0 + 9.0 / 60.0),
                        utc(17910, 17.0 + 32.0 / 60.0), utc(17917, 12.0 + 39.0 / 60.0),
                        utc(17927, 19.0 + 41.0 / 60.0)}) {
        auto const state = skyState(place, time);
        double const limb = sky::elevation(state.moonDirectionWorld) + state.moonAngularRadius;
        EXPECT_NEAR(core::degrees(limb), 0.0, 0.25) << time;
    }
}

TEST(SkyState, HasTheMoonFullInTheEclipseOfJanuary2019AndNewInThatOfAugust2017) {
    auto const full = skyState({29.0, -81.0, 0.0}, utc(17917, 5.2));
    EXPECT_GT(full.moonIlluminated, 0.998);
    auto const dark = skyState({36.97, -87.67, 0.0}, utc(17399, 18.0 + 25.3 / 60.0));  // totality, Hopkinsville
    EXPECT_LT(dark.moonIlluminated, 0.002);
    double const apart = std::acos(glm::dot(dark.sunDirectionWorld, dark.moonDirectionWorld));
    EXPECT_LT(apart, std::abs(dark.moonAngularRadius - dark.sunAngularRadius) + 1e-4);
}

TEST(SkyState, HasPolarisInTheNorthAtTheHeightOfTheLatitude) {
    constexpr double ra = 2.530 / 12.0 * core::kPi, dec = 89.264 / 180.0 * core::kPi;  // Hipparcos 11767
    glm::dvec3 const celestial{std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec)};
    for (double hour : {0.0, 5.0, 11.0, 17.0}) {
        auto const state = skyState({47.54, 7.58, 316.0}, utc(19531, hour));
        glm::dvec3 const polaris = glm::transpose(state.celestialFromWorld) * celestial;
        EXPECT_NEAR(core::degrees(sky::elevation(polaris)), 47.54, 0.8);
        EXPECT_LT(std::abs(std::sin(sky::azimuth(polaris))), 0.025);
        EXPECT_LT(polaris.z, 0.0);
    }
}

TEST(SkyState, TurnsTheStarsOnceInASiderealDay) {
    constexpr core::Place place{47.54, 7.58, 316.0};
    auto const now = skyState(place, utc(19531, 1.0));
    auto const later = skyState(place, utc(19531, 1.0) + 86164.0905);
    glm::dvec3 const star = later.celestialFromWorld * (glm::transpose(now.celestialFromWorld) * glm::dvec3{1, 0, 0});
    EXPECT_LT(std::acos(std::min(star.x, 1.0)), 2e-5);
}

TEST(SkyState, StandsInTheGoldenHourAtTheGamesFirstMinute) {
    auto const state = skyState({47.5411, 7.5836, 316.0}, utc(19531, 18.0 + 40.0 / 60.0));  // Basel, 2023-06-23
    EXPECT_NEAR(core::degrees(sky::elevation(state.sunDirectionWorld)), 6.0, 0.7);
    EXPECT_NEAR(core::degrees(sky::azimuth(state.sunDirectionWorld)), 298.0, 1.0);  // west-north-west
}

TEST(SkyState, DirectionAndItsAnglesAreInverses) {
    for (double azimuth : {0.1, 1.7, 3.3, 6.2})
        for (double elevation : {-1.2, 0.0, 0.4, 1.5}) {
            auto const direction = sky::directionWorld(azimuth, elevation);
            EXPECT_NEAR(sky::azimuth(direction), azimuth, 1e-12);
            EXPECT_NEAR(sky::elevation(direction), elevation, 1e-12);
        }
    EXPECT_NEAR(sky::directionWorld(core::radians(90.0), 0.0).x, 1.0, 1e-12);
    EXPECT_NEAR(sky::directionWorld(0.0, 0.0).z, -1.0, 1e-12);
}
}  // namespace
