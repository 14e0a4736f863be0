// What a feed brings, as weather of a flight.
#pragma once
#include <optional>
#include <string>

#include "game/app/inputs.h"
#include "game/app/session.h"
#include "game/app/weather_feed.h"

namespace luftpost::app {
/// Where the aircraft is on the Earth.
FeedPlace placeOf(Simulation const& simulation);

/// The news as weather; `stale`: what it is shown as. It acts at once.
WeatherInput liveInput(WeatherNews const& news, core::UtcSeconds given, bool stale);

/// The time that the feed goes by: the wall clock beside the frames, else the flight's own.
core::UtcSeconds feedTime(WeatherFeed const& feed, Simulation const& simulation);

/// A flight that begins anew begins in the live weather of now, if there is any.
void planAgain(FlightPlan& plan, WeatherFeed const& feed, Simulation const& simulation);

/// Once a frame, before its ticks: what has come enters the flight, or is offered to it where the feed works beside the frames. A line
/// where the news carries no weather.
std::optional<std::string> followFeed(Session& session, WeatherFeed& feed);
}  // namespace luftpost::app
