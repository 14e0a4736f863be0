// The navigation bar and the marker of the drop zone: where things stand on the screen.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/frames.h"
#include "game/ui/hud_geometry.h"

namespace {
using namespace luftpost;
using namespace luftpost::ui;

constexpr double kRadius = 150.0;
NavBarLayout const kLayout;

NavBar barFor(glm::dvec2 targetEastNorth, glm::dvec3 velocityWorld = {0.0, 0.0, -50.0}) {
    return navBar({0.0, 800.0, 0.0}, velocityWorld, core::worldFromEastNorth(targetEastNorth.x, targetEastNorth.y, 300.0),
                  kRadius, std::nullopt, kLayout);
}

TEST(NavBar, ShowsTheTargetInsideTheCircleExactlyWithinTheAcceptedRadius) {
    for (double bearing = 0.0; bearing < 6.3; bearing += 0.3) {
        glm::dvec2 const way{std::sin(bearing), std::cos(bearing)};
        EXPECT_LT(glm::length(barFor(0.98 * kRadius * way).dot_px), kLayout.circle_px);
        EXPECT_TRUE(barFor(0.98 * kRadius * way).within);
        EXPECT_GT(glm::length(barFor(1.02 * kRadius * way).dot_px), kLayout.circle_px);
        EXPECT_FALSE(barFor(1.02 * kRadius * way).within);
    }
}

TEST(NavBar, HasNorthUpAndEastRight) {
    NavBar const north = barFor({0.0, 400.0}), east = barFor({400.0, 0.0});
    EXPECT_LT(north.dot_px.y, 0.0f);
    EXPECT_NEAR(north.dot_px.x, 0.0f, 1e-3f);
    EXPECT_GT(east.dot_px.x, 0.0f);
    EXPECT_NEAR(east.dot_px.y, 0.0f, 1e-3f);
}

TEST(NavBar, NeverLetsTheDotLeaveTheBarAndKeepsItsDirection) {
    for (double distance : {200.0, 900.0, 6000.0, 4.0e5})
        for (double bearing = 0.05; bearing < 6.3; bearing += 0.21) {
            glm::vec2 const dot = barFor(distance * glm::dvec2{std::sin(bearing), std::cos(bearing)}).dot_px;
            EXPECT_LE(std::abs(dot.x) + kLayout.dot_px, kLayout.half_px.x + 1e-3f);
            EXPECT_LE(std::abs(dot.y) + kLayout.dot_px, kLayout.half_px.y + 1e-3f);
            EXPECT_NEAR(std::remainder(std::atan2(dot.x, -dot.y) - static_cast<float>(bearing), 2.0f * 3.14159265f), 0.0f, 1e-4f);
        }
}

TEST(NavBar, DrawsTheTargetNeverNearerWhenItIsFarther) {
    float reach = 0.0f;
    for (double distance = 1.0; distance < 2.0e4; distance *= 1.1) {
        float const next = navBarReach(distance, kRadius, kLayout);
        EXPECT_GT(next, reach);
        reach = next;
    }
    EXPECT_NEAR(navBarReach(kRadius, kRadius, kLayout), kLayout.circle_px, 1e-4f);
    EXPECT_LT(navBarReach(6000.0, kRadius, kLayout), kLayout.half_px.x);  // the farthest job is still to scale
}

TEST(NavBar, PointsTheArrowAlongTheVelocityOverTheGround) {
    glm::vec2 const arrow = barFor({0.0, 900.0}, {30.0, -20.0, 40.0}).arrow_px;  // east and south
    EXPECT_NEAR(arrow.x / arrow.y, 30.0f / 40.0f, 1e-4f);
    EXPECT_GT(arrow.y, 0.0f);
    EXPECT_LE(glm::length(arrow), kLayout.circle_px + 1e-4f);
    EXPECT_EQ(barFor({0.0, 900.0}, {0.0, -9.0, 0.0}).arrow_px, glm::vec2{0.0f});  // straight down: no way over the ground
}

TEST(NavBar, TellsTheTimeToGoOnlyWhenClosing) {
    NavBar const toward = barFor({0.0, 1000.0});
    ASSERT_TRUE(toward.secondsToGo);
    EXPECT_NEAR(*toward.secondsToGo, 20.0, 1e-9);
    EXPECT_NEAR(toward.distance, 1000.0, 1e-9);
    EXPECT_FALSE(barFor({0.0, -1000.0}).secondsToGo);
    EXPECT_FALSE(barFor({1000.0, 0.0}).secondsToGo);
}

CameraPose lookingNorth() {
    CameraPose camera;
    camera.positionWorld = {0.0, 500.0, 0.0};
    camera.horizontalFov = 1.2;
    return camera;
}

TEST(Marker, StandsOnAPlaceThatIsSeen) {
    glm::vec2 const size{1280.0f, 720.0f};
    auto const ahead = seenAt(lookingNorth(), size, {0.0, 500.0, -1000.0});
    ASSERT_TRUE(ahead);
    EXPECT_NEAR(ahead->x, 640.0f, 0.01f);
    EXPECT_NEAR(ahead->y, 360.0f, 0.2f);  // the Earth drops by 8 cm over a kilometre
    double const edge = std::tan(0.6) * 1000.0;
    EXPECT_NEAR(seenAt(lookingNorth(), size, {edge, 500.0, -1000.0})->x, 1280.0f, 0.01f);
    EXPECT_FALSE(seenAt(lookingNorth(), size, {0.0, 500.0, 1000.0}));
    EXPECT_EQ(edgeMarker(lookingNorth(), size, {60.0f, 60.0f}, {0.0, 400.0, -1000.0}).outward, glm::vec2{0.0f});
}

TEST(Marker, PointsFromTheEdgeTowardAPlaceThatIsNot) {
    glm::vec2 const size{1280.0f, 720.0f}, margin{60.0f, 150.0f};
    for (glm::dvec3 const place : {glm::dvec3{5000.0, 0.0, -10.0}, glm::dvec3{300.0, 0.0, 4000.0}}) {
        EdgeMarker const right = edgeMarker(lookingNorth(), size, margin, place);
        EXPECT_GT(right.outward.x, 0.0f);
        EXPECT_GE(right.outward.y, 0.0f);  // never up into the sky
        EXPECT_LE(right.at_px.x, size.x - margin.x + 0.01f);
        EXPECT_LE(right.at_px.y, size.y - margin.y + 0.01f);
    }
    EXPECT_LT(edgeMarker(lookingNorth(), size, margin, {-5000.0, 0.0, -10.0}).outward.x, 0.0f);
}
}  // namespace
