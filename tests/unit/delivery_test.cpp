// Parcels fall and drift as published figures say, drop zones lie where they may, and a drop is judged at
// touchdown.
#include "game/delivery/delivery.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/error.h"
#include "engine/core/frames.h"
#include "game/delivery/career.h"

namespace {
using namespace luftpost;
using namespace luftpost::delivery;

core::AirSample windFromWest(double speed) {
    core::AirSample air;
    air.windWorld = {speed, 0.0, 0.0};
    return air;
}
core::GroundFunction const kFlat = [](double, double) { return core::GroundSample{}; };

/// A parcel under its open chute at its terminal speed, falling with the wind until it has come down
/// `height`.
double driftOf(ParcelData const& data, double height, double wind) {
    Parcel parcel{
        {0.0, height, 0.0}, {wind, -terminalSpeed(data.mass, data.chuteDragArea, 1.225), 0.0}, 100.0, 1.0};
    while (parcel.positionWorld.y > 0.0) stepParcel(parcel, data, windFromWest(wind), core::kTickSeconds);
    return parcel.positionWorld.x;
}

TEST(Parcel, FallsAtTheTerminalSpeedOfItsChute) {
    EXPECT_NEAR(terminalSpeed(25.0, 6.0, 1.225), 8.17, 0.02 * 8.17);
    EXPECT_NEAR(terminalSpeed(25.0, 3.0, 1.225), 11.6, 0.02 * 11.6);
    Parcel parcel{{0.0, 1000.0, 0.0}, {40.0, 0.0, 0.0}, 0.0, 0.0};
    for (int tick = 0; tick < 20 * core::kTicksPerSecond; ++tick)
        stepParcel(parcel, {}, windFromWest(0.0), core::kTickSeconds);
    EXPECT_NEAR(parcel.velocityWorld.y, -8.17, 0.02 * 8.17);
    EXPECT_NEAR(parcel.velocityWorld.x, 0.0, 0.02);
}

TEST(Parcel, DriftsWithTheWindAllTheWayDown) {
    EXPECT_NEAR(driftOf({}, 150.0, 8.0), 147.0, 0.02 * 147.0);
    ParcelData small;
    small.chuteDragArea = 3.0;
    EXPECT_NEAR(driftOf(small, 150.0, 8.0), 104.0, 0.02 * 104.0);
}

TEST(Parcel, LagsBehindAChangeOfWindByItsSpeedOverGravity) {
    // Slow down the last 5 % of the difference: an exponential of time constant v / (2 g) for the small rest.
    Parcel parcel{{0.0, 1000.0, 0.0}, {0.0, -8.17, 0.0}, 100.0, 1.0};
    for (int tick = 0; tick < core::kTicksPerSecond * 83 / 100; ++tick)
        stepParcel(parcel, {}, windFromWest(1.0), core::kTickSeconds);
    EXPECT_NEAR(parcel.velocityWorld.x, 1.0 - std::exp(-1.0), 0.03);
}

TEST(Parcel, OpensItsChuteAboutASecondAfterRelease) {
    Parcel parcel{{0.0, 500.0, 0.0}, {50.0, 0.0, 0.0}, 0.0, 0.0};
    for (int tick = 0; tick < core::kTicksPerSecond - 1; ++tick)
        stepParcel(parcel, {}, windFromWest(0.0), core::kTickSeconds);
    EXPECT_EQ(parcel.chute, 0.0);
    for (int tick = 0; tick < core::kTicksPerSecond; ++tick)
        stepParcel(parcel, {}, windFromWest(0.0), core::kTickSeconds);
    EXPECT_EQ(parcel.chute, 1.0);
}

TEST(Parcel, LandsWhereThePredictionSays) {
    Parcel parcel{{0.0, 160.0, 0.0}, {45.0, 1.0, -10.0}, 0.0, 0.0};
    Landing const predicted = predictedLanding(parcel, {}, windFromWest(5.0), 0.0);
    double seconds = 0.0;
    for (; parcel.positionWorld.y > 0.0; seconds += core::kTickSeconds)
        stepParcel(parcel, {}, windFromWest(5.0), core::kTickSeconds);
    EXPECT_NEAR(predicted.positionWorld.x, parcel.positionWorld.x, 2.0);
    EXPECT_NEAR(predicted.positionWorld.z, parcel.positionWorld.z, 2.0);
    EXPECT_NEAR(predicted.seconds, seconds, 0.3);
}

TEST(DropZone, IsWorthAHundredPointsInTheCentreAndNoneOutside) {
    EXPECT_EQ(pointsFor(0.0), 100.0);
    EXPECT_DOUBLE_EQ(pointsFor(75.0), 50.0);
    EXPECT_EQ(pointsFor(150.0), 0.0);
    EXPECT_EQ(pointsFor(1000.0), 0.0);
}

TEST(DropZone, LiesTwoKilometresAheadFirst) {
    core::Random random{7};
    DropZone const zone = firstDropZone(random, {100.0, 50.0}, {1.0, 0.0}, kFlat);
    EXPECT_DOUBLE_EQ(zone.east, 2100.0);
    EXPECT_DOUBLE_EQ(zone.north, 50.0);
    EXPECT_FALSE(zone.name.empty());
}

TEST(DropZone, LiesOnLandAndNeverOnASlope) {
    // Strips of lake, of steep hillside and of meadow.
    core::GroundFunction const strips = [](double east, double) {
        core::GroundSample ground;
        double const strip = std::fmod(std::abs(east), 900.0);
        if (strip < 300.0)
            ground.surface = core::Surface::water;
        else if (strip < 600.0)
            ground.normalWorld = {std::sin(core::radians(11.0)), std::cos(core::radians(11.0)), 0.0};
        return ground;
    };
    core::Random random{3};
    DropZone zone = firstDropZone(random, {0.0, 0.0}, {0.0, 1.0}, strips);
    for (int i = 0; i < 200; ++i) {
        EXPECT_TRUE(isGoodSite(strips(zone.east, zone.north)));
        DropZone const next = nextDropZone(random, zone, strips);
        double const distance = distanceFrom(zone, next.east, next.north);
        EXPECT_GE(distance, kNearestZone);
        EXPECT_LE(distance, kFarthestZone);
        zone = next;
    }
}

TEST(DropZone, IsTheSameForTheSameDice) {
    core::Random first{5}, second{5}, other{6};
    DropZone const last{"here", 0.0, 0.0, 0.0};
    DropZone const a = nextDropZone(first, last, kFlat), b = nextDropZone(second, last, kFlat);
    EXPECT_EQ(a.east, b.east);
    EXPECT_EQ(a.name, b.name);
    EXPECT_NE(a.east, nextDropZone(other, last, kFlat).east);
}

/// Releases one parcel at rest over a point and lets it land.
DeliveryEvent dropOver(Delivery& delivery, double east, double north) {
    EXPECT_EQ(delivery.release({east, 100.0, -north}, glm::dvec3{0.0}, 10.0), DeliveryEvent::released);
    core::AirFunction const calm = [](glm::dvec3 const&, core::UtcSeconds) { return core::AirSample{}; };
    for (double t = 10.0; t < 100.0; t += core::kTickSeconds) {
        DeliveryEvent const event = delivery.step(calm, kFlat, t, 0.0);
        if (event == DeliveryEvent::delivered || event == DeliveryEvent::lost) return event;
    }
    return DeliveryEvent::none;
}

TEST(Delivery, CountsAParcelInTheZoneAtTouchdownAndNamesTheNextZone) {
    Delivery delivery{1, {0.0, 0.0}, {0.0, 1.0}, kFlat};
    DropZone const first = delivery.target();
    EXPECT_EQ(dropOver(delivery, first.east + 30.0, first.north), DeliveryEvent::delivered);
    EXPECT_EQ(delivery.deliveries(), 1);
    EXPECT_NEAR(delivery.score(), 80.0, 1.0e-6);
    EXPECT_NE(delivery.target().east, first.east);
    EXPECT_TRUE(delivery.parcelAboard());
    ASSERT_EQ(delivery.drops().size(), 1u);
    EXPECT_NEAR(delivery.drops()[0].distance, 30.0, 1.0e-6);
    EXPECT_GT(*delivery.drops()[0].landingTime, 10.0 + 100.0 / 30.0);
}

TEST(Delivery, LosesAParcelOutsideTheZoneAndKeepsTheJob) {
    Delivery delivery{1, {0.0, 0.0}, {0.0, 1.0}, kFlat};
    DropZone const first = delivery.target();
    EXPECT_EQ(dropOver(delivery, first.east + 151.0, first.north), DeliveryEvent::lost);
    EXPECT_EQ(delivery.deliveries(), 0);
    EXPECT_EQ(delivery.score(), 0.0);
    EXPECT_EQ(delivery.target().east, first.east);
    EXPECT_TRUE(delivery.parcelAboard());
}

TEST(Delivery, HasOneParcelAtATime) {
    Delivery delivery{1, {0.0, 0.0}, {0.0, 1.0}, kFlat};
    EXPECT_EQ(delivery.release({0.0, 100.0, 0.0}, glm::dvec3{0.0}, 0.0), DeliveryEvent::released);
    EXPECT_EQ(delivery.release({0.0, 100.0, 0.0}, glm::dvec3{0.0}, 0.0), DeliveryEvent::none);
    EXPECT_EQ(delivery.drops().size(), 1u);
}

TEST(Career, RoundTripsAndRefusesWhatIsNotASave) {
    Career const career{42, 7, 3, 512.25, 3.5};
    EXPECT_EQ(parseCareer(careerText(career), "save.json"), career);
    for (char const* bad : {"", "[]", "{}", "{\"format\":\"luftpost-save-1\",\"score\":\"many\"}",
                            "{\"format\":\"luftpost-save-1\",\"deliveries\":-1}"})
        EXPECT_THROW(parseCareer(bad, "save.json"), core::Error) << bad;
}
}  // namespace
