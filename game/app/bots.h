// The bots of --bot: who they are, and what a flight of theirs is made from where the player says nothing else.
#pragma once
#include <memory>
#include <string>

#include "game/app/flight_plan.h"
#include "game/app/play_options.h"
#include "game/bot/cards.h"

namespace luftpost::app {
/// The airfield as a flight at `time` begins there: the end from which one goes into the wind.
bot::CardGround cardGround(terrain::Land const& land, weather::Field const& field, core::UtcSeconds time);

/// `name` passed checkBot.
std::unique_ptr<bot::Pilot> makePilot(std::string const& name, World const& world,
                                      flight::Airframe const& airframe, flight::AssistLevel assist, core::UtcSeconds time);

/// Throws core::Error for a bot that is none, or options that contradict it.
void checkBot(PlayTexts const& texts, CommonOptions const& common);
/// What a card needs and nobody asked for otherwise: assist sim, the standard atmosphere at sea level. Gives the weather of
/// the card that needs wind across the runway, else an empty one.
WeatherInput prepareForBot(PlayTexts const& texts, CommonOptions& common);
/// Where the bot begins.
void planStartForBot(std::string const& name, weather::Field const& field, flight::Airframe const& airframe,
                     FlightPlan& plan);
}  // namespace luftpost::app
