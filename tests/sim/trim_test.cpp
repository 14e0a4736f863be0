#include <gtest/gtest.h>

#include "tests/sim/test_flight.h"

namespace luftpost::flight {
TEST(Trim, LevelFlightNeedsThePublishedAnglesOfAttack) {
    struct Row { double kt, alpha_deg; };
    for (Row row : {Row{60, 9.9}, Row{76, 4.8}, Row{100, 1.35}, Row{120, -0.1}}) {
        TestFlight flight;
        flight.inAir(304.8, fromKnots(row.kt));
        double const alpha_deg = core::degrees(flight.now().alpha);
        fmt::print("trim at {} kt: alpha {:.2f} deg ({:.2f})\n", row.kt, alpha_deg, row.alpha_deg);
        EXPECT_NEAR(alpha_deg, row.alpha_deg, 2.5) << row.kt;
        EXPECT_NEAR(flight.now().loadFactor, 1.0, 0.02) << row.kt;
        EXPECT_NEAR(flight.now().mass, 1100.0, 1e-9);
    }
}

TEST(Trim, AStartInTheAirStaysLevelHandsOff) {
    TestFlight flight;
    flight.wind = {10.0, 0.0, -5.0};
    flight.inAir(1000.0, 52.0);
    flight.fly(30.0);
    EXPECT_NEAR(flight.state().positionWorld.y, 1000.0, 3.0);
    EXPECT_NEAR(flight.now().tas, 52.0, 0.2);
    EXPECT_NEAR(flight.now().roll, 0.0, 0.02);
}
}  // namespace luftpost::flight
