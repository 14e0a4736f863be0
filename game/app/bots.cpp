#include "game/app/bots.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/math.h"
#include "engine/core/time.h"
#include "engine/weather/source.h"
#include "game/app/runway_start.h"
#include "game/bot/courier.h"
#include "game/ui/hand_weather.h"

namespace luftpost::app {
namespace {
constexpr std::string_view kCard = "card:";
constexpr char const* kCardWeather = "preset:calm";
constexpr core::Place kCardPlace{47.541, 7.584, 0.0};  // of the presets, at sea level
constexpr double kWindFrom = core::radians(80.0);      // off the runway: a little from ahead, so that its end is certain

bool isTestCard(std::string_view bot) { return bot.starts_with(kCard); }
/// Flown by a test pilot, with the bare aircraft where nobody asks for another assist.
bool isCard(std::string_view bot) { return isTestCard(bot) || bot == bot::kCircuit; }
std::string_view cardName(std::string_view bot) { return isTestCard(bot) ? bot.substr(kCard.size()) : bot; }

/// The highest ground within `reach` of the airfield, m above sea level.
double highestWithin(terrain::Land const& land, double reach) {
    constexpr int kSteps = 30;  // to each side
    double highest = land.base();
    for (int i = -kSteps; i <= kSteps; ++i)
        for (int j = -kSteps; j <= kSteps; ++j)
            highest = std::max(highest, land.ground(reach * i / kSteps, reach * j / kSteps).height);
    return highest;
}

bool assigns(CommonOptions const& common, std::string_view key) {
    return std::any_of(common.assignments.begin(), common.assignments.end(),
                       [&](std::string const& text) { return text.substr(0, text.find('=')) == key; });
}

/// The standard atmosphere with a wind of `speed` across the runway, from its right.
std::string windAcross(double speed, double runwayHeading, core::Place const& place, core::UtcSeconds time) {
    ui::HandWeather hand;
    hand.from_deg = std::fmod(core::degrees(runwayHeading + kWindFrom), 360.0);
    hand.speed_mps = hand.gust_mps = speed / core::sin(kWindFrom);
    hand.temperature_c = 15.0 - 0.0065 * place.altitude_m;
    hand.dewPoint_c = hand.temperature_c - 10.0;
    return weather::recordingText(ui::handRecording(hand, place, time));
}
}  // namespace

bot::CardGround cardGround(terrain::Land const& land, weather::Field const& field, core::UtcSeconds time) {
    RunwayStart const start = runwayStart(land, field, time);
    weather::Weather const air = field.at(0.0, 0.0, time);
    return {.thresholdEastNorth = start.thresholdEastNorth,
            .heading = start.heading,
            .altitude = land.base(),
            .clear = highestWithin(land, 6000.0) + 60.0,
            .clearFar = highestWithin(land, 40000.0) + 150.0,
            .gust = std::max(air.gust - glm::length(air.windSurface), 0.0)};
}

std::unique_ptr<bot::Pilot> makePilot(std::string const& name, World const& world,
                                      flight::Airframe const& airframe, flight::AssistLevel assist, core::UtcSeconds time) {
    if (name == "courier") return std::make_unique<bot::Courier>(world.ground(), airframe.stallSpeed);
    return std::make_unique<bot::Card>(cardName(name), airframe, cardGround(world.land(), world.field(), time), assist);
}

void checkBot(PlayTexts const& texts, CommonOptions const& common) {
    std::string const& bot = texts.bot;
    if (bot.empty() || bot == "courier") return;
    if (!isCard(bot))
        throw core::Error{"--bot", "", fmt::format("expected courier, circuit or card:NAME, found {}", bot)};
    auto const names = bot::cardNames();
    if (isTestCard(bot) && std::find(names.begin(), names.end(), cardName(bot)) == names.end())
        throw core::Error{"--bot", "",
                          fmt::format("expected card: and one of {}, found {}", fmt::join(names, ", "), bot)};
    if (!texts.start.empty())
        throw core::Error{"--start", "", fmt::format("expected not with --bot {}, which starts where it needs to", bot)};
    bool const otherAssist = (!texts.assist.empty() && texts.assist != "sim") ||
                             (assigns(common, "aircraft.assist") &&
                              common.settings.flight.pilot.assist != flight::AssistLevel::sim);
    if (isTestCard(bot) && otherAssist)
        throw core::Error{"--assist", "", fmt::format("expected sim with --bot {}, which measures the bare aircraft", bot)};
}

WeatherInput prepareForBot(PlayTexts const& texts, CommonOptions& common) {
    std::string const& name = texts.bot;
    if (!isCard(name)) return {};
    bool const chosen = !texts.assist.empty() || assigns(common, "aircraft.assist");
    if (!chosen) common.settings.flight.pilot.assist = flight::AssistLevel::sim;
    if (!isTestCard(name) || !common.weather.empty()) return {};
    common.weather = kCardWeather;
    if (!common.place) common.place = PlaceOption{kCardPlace.lat_deg, kCardPlace.lon_deg, kCardPlace.altitude_m};
    if (name != "card:crosswind") return {};
    core::Place const place{common.place->lat_deg, common.place->lon_deg, common.place->altitude_m.value_or(0.0)};
    core::UtcSeconds const time = common.time.value_or(*core::parseUtc(weather::kDefaultTime));
    terrain::Land const land{common.seed.value_or(1), place.altitude_m};
    double const speed = core::kMetresPerSecondPerKnot * bot::Card::kCrosswind_kt;
    return {.source = kHandSource,
            .recording = windAcross(speed, land.runway().heading, place, time),
            .mode = weather::SourceMode::Preset};
}

void planStartForBot(std::string const& name, weather::Field const& field, flight::Airframe const& airframe,
                     FlightPlan& plan) {
    if (!isCard(name)) return;
    SimulationOptions& simulation = plan.simulation;
    terrain::Land const land{simulation.seed, plan.place.altitude_m};
    bot::Card const card{cardName(name), airframe, cardGround(land, field, simulation.time)};
    bot::CardStart const& start = card.start();
    simulation.start = {start.runway, start.altitude, start.tas, start.heading, start.eastNorth};
}
}  // namespace luftpost::app
