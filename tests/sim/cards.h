// Flies a test card of the bot over flat land at sea level in the standard atmosphere: the stick is taken 20 times a
// second, as the game's input layer does.
#pragma once
#include <map>
#include <string>

#include "game/bot/cards.h"
#include "tests/sim/test_flight.h"

namespace luftpost::flight {
struct FlownCard {
    std::map<std::string, double> figures;
    bool finished = false, crashed = false;
    double at(std::string const& key) const {
        auto const found = figures.find(key);
        return found == figures.end() ? std::nan("") : found->second;
    }
};

/// `low` is where the air work begins that has to be low, m.
inline FlownCard flownCard(std::string const& name, TestFlight& flight, double low = 30.0) {
    bot::Card card{name, flight.aircraft.airframe(), bot::CardGround{.clear = low}};
    bot::CardStart const& start = card.start();
    if (start.runway)
        flight.aircraft.startOnRunway(start.eastNorth.x, start.eastNorth.y, start.heading, flight.air,
                                      flight.ground, 0.0);
    else
        flight.aircraft.startInAir(
            core::worldFromEastNorth(start.eastNorth.x, start.eastNorth.y, start.altitude), start.heading,
            start.tas, flight.air, flight.ground, 0.0);
    if (flight.startsWithIce > 0.0) {
        AircraftState iced = flight.state();
        iced.ice = flight.startsWithIce;
        flight.aircraft.restore(iced);
    }
    flight.fly(3600.0, [&](double) {
        card.look(flight.state());
        if (flight.state().tick % bot::kTicksPerDecision == 0) flight.stick = card.hands();
        return !card.finished() && !flight.state().crashed();
    });
    return {{card.figures()->begin(), card.figures()->end()}, card.finished(), flight.state().crashed()};
}
inline FlownCard flownCard(std::string const& name, double windFromRight_kt = 0.0) {
    TestFlight flight;
    flight.wind = {-fromKnots(windFromRight_kt), 0.0, 0.0};
    return flownCard(name, flight);
}
}  // namespace luftpost::flight
