// Autopilot and airframe act as stamped inputs: by key and by setting, and a replay is the same flight.
#include <gtest/gtest.h>

#include <cmath>
#include "tests/support/session.h"

namespace luftpost::app {
namespace {
using tests::fly, tests::flying, tests::hashOfReplay;

FlightPlan calmPlan() { return tests::planOver("preset:calm"); }
ui::InputSample withKeys(std::initializer_list<ui::FlightKey> keys) {
    ui::InputSample sample;
    for (ui::FlightKey key : keys) sample.hold(key);
    return sample;
}
void pressAutopilot(Session& session) {
    session.input(withKeys({ui::FlightKey::autopilot}));
    fly(session, 0.1);
    session.input(ui::InputSample{});
}
}  // namespace

TEST(AutopilotInput, IsSwitchedByItsKeyAndClimbsToTheAltitudeThatIsSet) {
    Session session{flying(calmPlan())};
    pressAutopilot(session);
    EXPECT_EQ(session.simulation().autopilotText(), "AUTOPILOT  heading 0  altitude 2953 ft  speed 93 kt");
    session.input(SettingInput{"aircraft.autopilotAltitude_ft", 3281.0});
    session.input(SettingInput{"aircraft.autopilotCourse", std::string{"heading"}});
    session.input(SettingInput{"aircraft.autopilotHeading_deg", 90.0});
    fly(session, 90.0);
    EXPECT_NEAR(session.simulation().aircraft().state().positionWorld.y, 1000.0, 3.0);
    EXPECT_NEAR(core::degrees(session.simulation().aircraft().state().readings.heading), 90.0, 2.0);
    EXPECT_EQ(hashOfReplay(session), session.simulation().stateHash());
    pressAutopilot(session);
    EXPECT_EQ(session.simulation().autopilotText(), "");
}

TEST(AutopilotInput, GivesTheStickToWhoMovesIt) {
    Session session{flying(calmPlan())};
    pressAutopilot(session);
    fly(session, 5.0);
    session.input(withKeys({ui::FlightKey::rollRight}));
    fly(session, 0.5);
    EXPECT_EQ(session.simulation().autopilotText(), "");
    EXPECT_GT(session.simulation().aircraft().state().readings.roll, 0.05);
}

TEST(AutopilotInput, ItsKnobsAreTheTrimWheelsAndTheLever) {
    Session session{flying(calmPlan())};
    pressAutopilot(session);
    double const speed = session.simulation().aircraft().state().readings.cas;
    session.input(withKeys({ui::FlightKey::trimNoseUp, ui::FlightKey::trimYawRight}));
    fly(session, 6.0);
    session.input(withKeys({ui::FlightKey::thrustDown}));
    fly(session, 0.5);
    session.input(ui::InputSample{});
    fly(session, 60.0);
    flight::AircraftState const& now = session.simulation().aircraft().state();
    EXPECT_NEAR(now.positionWorld.y, tests::kStartAltitude + 6.0 * 40.0 * core::kMetresPerFoot, 3.0);
    EXPECT_NEAR(core::degrees(now.readings.heading), 30.0, 2.0);
    EXPECT_NEAR(now.readings.cas, speed - 0.25 * (129.0 - 1.35 * 51.0) * core::kMetresPerSecondPerKnot, 1.0);
    EXPECT_EQ(session.simulation().stick().controls().elevatorTrim, 0.0) << "the wheels themselves stay";
    EXPECT_EQ(hashOfReplay(session), session.simulation().stateHash());
    session.input(SettingInput{"aircraft.autopilotAltitude_ft", 3281.0});
    fly(session, 60.0);
    EXPECT_NEAR(now.positionWorld.y, 1000.0, 3.0) << "what is set in the menu holds";
}

TEST(AutopilotInput, FliesToTheDropZoneInEveryAssistAndAirframe) {
    for (AirframeChoice airframe : {AirframeChoice::mailPlane, AirframeChoice::freightPlane})
        for (flight::AssistLevel assist : {flight::AssistLevel::sim, flight::AssistLevel::easy}) {
            FlightPlan plan = calmPlan();
            plan.simulation.settings.pilot = {airframe, assist};
            plan.simulation.settings.autopilot.course = flight::AutopilotCourse::target;
            Session session{flying(plan)};
            pressAutopilot(session);
            double nearest = 1.0e9;
            for (int i = 0; i < 240 && nearest > 60.0; ++i) {
                fly(session, 0.5);
                delivery::DropZone const& zone = session.simulation().delivery().target();
                glm::dvec3 const& at = session.simulation().aircraft().state().positionWorld;
                nearest = std::min(nearest, std::hypot(at.x - zone.east, -at.z - zone.north));
            }
            EXPECT_LT(nearest, 60.0) << static_cast<int>(airframe) << " " << static_cast<int>(assist);
        }
}

TEST(AirframeInput, ActsFromTheNextRespawnAndTheReplayHasIt) {
    Session session{flying(calmPlan())};
    session.input(SettingInput{"aircraft.airframe", std::string{"freight_plane"}});
    fly(session, 1.0);
    EXPECT_EQ(session.simulation().aircraft().airframe().name, "Mail plane");
    session.input(withKeys({ui::FlightKey::respawn}));
    fly(session, 1.0);
    EXPECT_EQ(session.simulation().aircraft().airframe().name, "Freight plane");
    fly(session, 20.0);
    EXPECT_EQ(session.simulation().crashes(), 0);
    EXPECT_EQ(hashOfReplay(session), session.simulation().stateHash());
}
}  // namespace luftpost::app
