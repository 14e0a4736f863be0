// Ice adds weight and spoils the strips: the stall comes earlier, the climb is less.
#include <gtest/gtest.h>

#include "tests/sim/cards.h"

namespace luftpost::flight {
namespace {
/// A flight in clear, cold air with so much ice already on the strips, kg.
FlownCard icedCard(std::string const& name, double ice) {
    TestFlight flight;
    flight.startsWithIce = ice;
    core::AirFunction const clear = flight.air;
    flight.air = [clear](glm::dvec3 const& p, core::UtcSeconds t) {
        core::AirSample sample = clear(p, t);
        sample.temperature = 268.15;  // nothing melts
        sample.density = sample.pressure / (287.05287 * sample.temperature);
        return sample;
    };
    return flownCard(name, flight);
}
}  // namespace

TEST(Ice, RaisesTheStallAndLowersTheClimb) {
    double const stall = icedCard("stall", 0.0).at("stall_clean_kcas"), iced = icedCard("stall", 30.0).at("stall_clean_kcas");
    double const climb = icedCard("climb", 0.0).at("climb_fpm"), icedClimb = icedCard("climb", 30.0).at("climb_fpm");
    fmt::print("| 30 kg of ice: stall, KCAS | {:.1f}, clean {:.1f} |\n| 30 kg of ice: climb, ft/min | {:.0f}, clean {:.0f} |\n",
               iced, stall, icedClimb, climb);
    EXPECT_GT(iced, stall + 3.0);
    EXPECT_LT(iced, stall + 20.0);
    EXPECT_LT(icedClimb, climb - 200.0);
}
}  // namespace luftpost::flight
