// The cameras keep above the ground, keep the aircraft in sight and depend on simulated time alone.
#include "game/ui/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace luftpost::ui;

double hills(double east, double north) { return 300.0 + 120.0 * std::sin(east / 90.0) * std::cos(north / 70.0); }

/// A level turn low over the hills.
CameraSubject turning(double t) {
    CameraSubject subject;
    double const rate = 0.3, speed = 50.0, radius = speed / rate;
    subject.positionWorld = {radius * std::sin(rate * t), 440.0, -radius * std::cos(rate * t)};
    subject.velocityWorld = {speed * std::cos(rate * t), 0.0, speed * std::sin(rate * t)};
    double const heading = std::atan2(subject.velocityWorld.x, -subject.velocityWorld.z);
    subject.worldFromBody = glm::angleAxis(1.5707963267948966 - heading, glm::dvec3{0.0, 1.0, 0.0}) * glm::angleAxis(0.8, glm::dvec3{1.0, 0.0, 0.0});
    return subject;
}

Cameras flown(CameraMode mode, double framesPerSecond, double seconds) {
    Cameras cameras;
    cameras.reset(turning(0.0), hills);
    cameras.select(mode);
    auto const frames = static_cast<int>(seconds * framesPerSecond);
    for (int i = 1; i <= frames; ++i) cameras.advance(turning(i / framesPerSecond), {}, hills, 1.0 / framesPerSecond, 1.0 / framesPerSecond);
    return cameras;
}

TEST(Cameras, AreNeverUnderTheGround) {
    for (CameraMode mode : {CameraMode::chase, CameraMode::tower, CameraMode::free, CameraMode::parcel}) {
        Cameras cameras;
        cameras.reset(turning(0.0), hills);
        cameras.watchParcel({40.0, 300.0, -30.0});
        cameras.select(mode);
        for (int i = 1; i < 900; ++i) {
            CameraInput input;
            input.move = {0.3, -1.0, -1.0};  // the free one dives
            input.fast = true;
            input.look = {0.01, -0.02};
            cameras.advance(turning(i / 60.0), input, hills, 1.0 / 60.0, 1.0 / 60.0);
            glm::dvec3 const eye = cameras.pose().positionWorld;
            ASSERT_GE(eye.y, hills(eye.x, -eye.z) + kCameraClearance - 1e-9) << "mode " << static_cast<int>(mode) << ", frame " << i;
            ASSERT_NEAR(glm::length(cameras.pose().worldFromCamera), 1.0, 1e-9);
        }
    }
}

TEST(Cameras, ChaseFromBehindWithTheAircraftInSight) {
    Cameras const cameras = flown(CameraMode::chase, 60.0, 20.0);
    CameraSubject const subject = turning(20.0);
    glm::dvec3 const to = subject.positionWorld - cameras.pose().positionWorld;
    EXPECT_GT(glm::dot(to, subject.velocityWorld), 0.0);
    EXPECT_GT(glm::length(to), 9.0);
    EXPECT_LT(glm::length(to), 30.0);
    glm::dvec3 const seen = glm::conjugate(cameras.pose().worldFromCamera) * to;
    EXPECT_LT(std::atan2(std::hypot(seen.x, seen.y), -seen.z), 0.35);  // within 20 degrees of the middle
}

TEST(Cameras, ShowTheSameAtAnyFrameRate) {
    CameraPose const slow = flown(CameraMode::chase, 30.0, 12.0).pose(), fast = flown(CameraMode::chase, 144.0, 12.0).pose();
    EXPECT_LT(glm::length(slow.positionWorld - fast.positionWorld), 0.35);  // the lag's step error in a 17 degrees a second turn
    EXPECT_GT(std::abs(glm::dot(slow.worldFromCamera, fast.worldFromCamera)), 0.9998);
}

TEST(Cameras, StandStillWhilePausedExceptTheFreeOne) {
    Cameras cameras = flown(CameraMode::chase, 60.0, 5.0);
    glm::dvec3 const before = cameras.pose().positionWorld;
    cameras.advance(turning(5.0), {}, hills, 0.0, 1.0 / 60.0);
    EXPECT_LT(glm::length(cameras.pose().positionWorld - before), 1e-9);
    cameras.select(CameraMode::free);
    CameraInput input;
    input.move = {0.0, 1.0, 0.0};
    for (int i = 0; i < 30; ++i) cameras.advance(turning(5.0), input, hills, 0.0, 1.0 / 60.0);
    EXPECT_GT(cameras.pose().positionWorld.y, before.y + 5.0);
}

TEST(Cameras, PutThePilotsEyeIntoTheCockpitLookingAhead) {
    Cameras const cameras = flown(CameraMode::cockpit, 60.0, 2.0);
    CameraSubject const subject = turning(2.0);
    glm::dvec3 const eye = glm::conjugate(subject.worldFromBody) * (cameras.pose().positionWorld - subject.positionWorld);
    EXPECT_LT(glm::length(eye - kPilotEyeBody), 0.05);
    glm::dvec3 const ahead = cameras.pose().worldFromCamera * glm::dvec3{0.0, 0.0, -1.0};
    EXPECT_GT(glm::dot(ahead, subject.worldFromBody * glm::dvec3{1.0, 0.0, 0.0}), 0.98);  // ten degrees down, where the panel is
    glm::dvec3 const up = cameras.pose().worldFromCamera * glm::dvec3{0.0, 1.0, 0.0};
    EXPECT_GT(glm::dot(up, subject.worldFromBody * glm::dvec3{0.0, 1.0, 0.0}), 0.98);  // banks with the aircraft
    EXPECT_TRUE(cameras.inside());
}

TEST(Cameras, GoRoundAllOfThem) {
    Cameras cameras;
    for (CameraMode mode : {CameraMode::cockpit, CameraMode::wing, CameraMode::hatch, CameraMode::tower, CameraMode::free, CameraMode::chase}) {
        cameras.next();
        EXPECT_EQ(cameras.mode(), mode);
    }
    cameras.select(CameraMode::free);
    cameras.next(true);
    EXPECT_EQ(cameras.mode(), CameraMode::parcel) << "while a parcel falls";
    cameras.next(true);
    EXPECT_EQ(cameras.mode(), CameraMode::chase);
}

/// Degrees between the camera's axis and the way to the aircraft.
double offAxis_deg(Cameras const& cameras, CameraSubject const& subject) {
    glm::dvec3 const seen = glm::conjugate(cameras.pose().worldFromCamera) * (subject.positionWorld - cameras.pose().positionWorld);
    return std::atan2(std::hypot(seen.x, seen.y), -seen.z) * 57.29577951308232;
}

TEST(Cameras, WatchFromTheTowerAndFarFromItFromBesideTheWay) {
    for (glm::dvec3 const tower : {glm::dvec3{100.0, 350.0, 50.0}, glm::dvec3{60000.0, 350.0, 0.0}}) {
        Cameras cameras;
        cameras.setTower(tower);
        cameras.reset(turning(0.0), hills);
        cameras.select(CameraMode::tower);
        for (int i = 1; i < 900; ++i) {
            cameras.advance(turning(i / 60.0), {}, hills, 1.0 / 60.0, 1.0 / 60.0);
            ASSERT_LT(offAxis_deg(cameras, turning(i / 60.0)), 1.0) << i;
            ASSERT_LT(glm::distance(cameras.pose().positionWorld, turning(i / 60.0).positionWorld), 500.0) << i;
        }
    }
}

TEST(Cameras, RideOnTheAircraftAtTheWingAndTheHatch) {
    for (CameraMode mode : {CameraMode::wing, CameraMode::hatch}) {
        Cameras cameras = flown(mode, 60.0, 2.0);
        CameraSubject const subject = turning(2.0);
        glm::dvec3 const eye = glm::conjugate(subject.worldFromBody) * (cameras.pose().positionWorld - subject.positionWorld);
        EXPECT_LT(glm::length(eye), 7.0);
        EXPECT_FALSE(cameras.inside());
        CameraInput look;
        look.look = {0.5, 0.0};
        glm::dquat const before = cameras.pose().worldFromCamera;
        cameras.advance(subject, look, hills, 0.0, 0.0);
        EXPECT_NEAR(2.0 * std::acos(std::abs(glm::dot(before, cameras.pose().worldFromCamera))), 0.5, 1.0e-6) << "looks around";
    }
}

TEST(Cameras, ComeNearerByTheWheelByALensWhereTheyCannotMove) {
    CameraInput nearer;
    nearer.zoom = 5.0;
    for (CameraMode mode : {CameraMode::cockpit, CameraMode::wing, CameraMode::hatch}) {
        Cameras cameras = flown(mode, 60.0, 2.0);
        double const before = cameras.pose().horizontalFov;
        cameras.advance(turning(2.0), nearer, hills, 0.0, 0.0);
        EXPECT_NEAR(cameras.pose().horizontalFov, before * std::exp(-0.6), 1.0e-9);
    }
    Cameras chase = flown(CameraMode::chase, 60.0, 2.0);
    double const far = glm::distance(chase.pose().positionWorld, turning(2.0).positionWorld);
    for (int i = 0; i < 60; ++i) chase.advance(turning(2.0 + i / 60.0), i == 0 ? nearer : CameraInput{}, hills, 1.0 / 60.0, 1.0 / 60.0);
    EXPECT_LT(glm::distance(chase.pose().positionWorld, turning(2.0 + 59.0 / 60.0).positionWorld), 0.8 * far);
}

TEST(Cameras, ChaseFartherAndWiderAtSpeedAndNearerInAPull) {
    auto const after = [](double speed, double load) {
        CameraSubject subject;
        subject.positionWorld = {0.0, 900.0, 0.0};
        subject.velocityWorld = {speed, 0.0, 0.0};
        subject.loadFactor = load;
        Cameras cameras;
        cameras.reset(subject, hills);
        for (int i = 0; i < 600; ++i) cameras.advance(subject, {}, hills, 1.0 / 60.0, 1.0 / 60.0);
        return std::pair{glm::distance(cameras.pose().positionWorld, subject.positionWorld), cameras.pose().horizontalFov};
    };
    EXPECT_GT(after(70.0, 1.0).first, after(35.0, 1.0).first + 1.0);
    EXPECT_GT(after(70.0, 1.0).second, after(35.0, 1.0).second);
    EXPECT_LT(after(55.0, 3.0).first, after(55.0, 1.0).first - 0.5);
}
}  // namespace
