#include "engine/flight/airframe.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/core/error.h"
#include "engine/flight/air_loads.h"
#include "tests/sim/test_flight.h"

namespace luftpost::flight {
namespace {
std::string mailPlane() {
    std::ifstream file{std::string{LUFTPOST_SOURCE_DIR} + "/assets/airframes/mail_plane.json"};
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}
/// The airframe with one piece of its text replaced.
std::string changed(std::string const& from, std::string const& to) {
    std::string text = mailPlane();
    auto const at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}
std::string complaint(std::string const& text) {
    try {
        parseAirframe(text, "plane.json");
    } catch (core::Error const& error) {
        return error.what();
    }
    return "accepted";
}
}  // namespace

TEST(Airframe, TheMailPlaneHasTheMassesAndInertiasOfTheReference) {
    TestFlight flight;
    MassProperties const masses = massProperties(flight.aircraft.airframe(), flight.state());
    EXPECT_NEAR(masses.mass, 680.0 + 80.0 + 240.0 + 100.0, 1e-9);
    EXPECT_NEAR(glm::length(masses.centre), 0.0, 0.01);
    EXPECT_NEAR(masses.inertia[0][0], 1285.0, 20.0);
    EXPECT_NEAR(masses.inertia[2][2], 1825.0, 20.0);
    EXPECT_NEAR(masses.inertia[1][1], 2667.0, 20.0);
    double area = 0.0;
    for (StripData const& strip : flight.aircraft.airframe().strips)
        if (strip.place == StripPlace::wing) area += strip.area;
    EXPECT_NEAR(area, 16.17, 0.02);
}

TEST(Airframe, FreightChangesMassCentreAndInertiaAndNothingElse) {
    TestFlight full{240.0, 100.0}, empty{0.0, 100.0};
    MassProperties const a = massProperties(full.aircraft.airframe(), full.state());
    MassProperties const b = massProperties(empty.aircraft.airframe(), empty.state());
    EXPECT_NEAR(a.mass - b.mass, 240.0, 1e-9);
    EXPECT_LT(a.centre.x, b.centre.x);
    full.inAir(500.0, 50.0);
    AircraftState const before = full.state();
    full.aircraft.setPayload(0.0);
    EXPECT_EQ(full.state().positionWorld, before.positionWorld);
    EXPECT_EQ(full.state().velocityWorld, before.velocityWorld);
    EXPECT_EQ(full.state().ratesBody, before.ratesBody);
}

TEST(Airframe, AMistakeIsAnsweredWithFileKeyAndExpectation) {
    EXPECT_EQ(complaint(mailPlane()), "accepted");
    EXPECT_EQ(complaint(changed("\"diameter\": 1.905", "\"diameter\": -2")),
              "plane.json: propeller.diameter: expected a number 0.3..6, found -2");
    EXPECT_EQ(complaint(changed("\"place\": \"fin\"", "\"place\": \"keel\"")),
              "plane.json: strips[5].place: expected one of wing, tail, fin, fuselage");
    EXPECT_EQ(complaint(changed("\"chord\": 1.494", "\"cord\": 1.494")),
              "plane.json: wing.chord: expected a number 0.1..20, found nothing");
    EXPECT_EQ(complaint(changed("\"flapSeconds\": 5,", "\"flapSeconds\": 5, \"flapSecond\": 5,")),
              "plane.json: controls.flapSecond: expected no such key (a slip of the pen?)");
    EXPECT_EQ(complaint(changed("\"position\": [1.95, 0.05, 0]", "\"position\": [1.95, 0.05]")),
              "plane.json: propeller.position: expected three numbers [forward, up, right] in m");
    EXPECT_EQ(complaint(changed("\"advance\": [0, 0.2,", "\"advance\": [0, -0.2,")),
              "plane.json: propeller.advance: expected a number 0..5, found -0.2");
    EXPECT_EQ(complaint(changed("\"advance\": [0, 0.2,", "\"advance\": [0, 0.7,")),
              "plane.json: propeller.advance: expected rising numbers");
    EXPECT_EQ(complaint(changed("\"mirrored\": true", "\"mirrored\": 1")),
              "plane.json: strips[0].mirrored: expected true or false");
    EXPECT_EQ(complaint("{\"name\": 3}"), "plane.json: name: expected a text");
    EXPECT_EQ(complaint("{\"name\": "), "plane.json: byte 10: expected JSON");
    EXPECT_EQ(complaint("[]"), "plane.json: expected an object");
    EXPECT_THROW(loadAirframe("/nowhere/plane.json"), core::Error);
}
}  // namespace luftpost::flight
