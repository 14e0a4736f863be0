#include "game/app/live_weather.h"

#include <cmath>

#include "engine/core/error.h"
#include "engine/core/frames.h"
#include "engine/weather/source.h"

namespace luftpost::app {
namespace {
constexpr double kFirstSeconds = 20.0;  // from the weather that was waited in to the live one
}  // namespace

FeedPlace placeOf(Simulation const& simulation) {
    core::Place const origin = simulation.world().place();
    glm::dvec3 const& at = simulation.aircraft().state().positionWorld;
    double const metre = core::degrees(1.0 / core::kEarthRadius);
    double const longitude = origin.lon_deg + at.x * metre / std::max(std::cos(core::radians(origin.lat_deg)), 1e-6);
    return {std::clamp(origin.lat_deg - at.z * metre, -90.0, 90.0), longitude - 360.0 * std::floor((longitude + 180.0) / 360.0)};
}

WeatherInput liveInput(WeatherNews const& news, core::UtcSeconds given, bool stale) {
    return {.source = kLiveSource,
            .recording = news.recording,
            .mode = stale ? weather::SourceMode::Stale : weather::SourceMode::Live,
            .fetched = given};
}

core::UtcSeconds feedTime(WeatherFeed const& feed, Simulation const& simulation) {
    return feed.pace() == FeedPace::beside ? weather::contextOfNow().latest : simulation.utc();
}

void planAgain(FlightPlan& plan, WeatherFeed const& feed, Simulation const& simulation) {
    auto const news = feed.last();
    if (!news) return;
    core::UtcSeconds const now = feedTime(feed, simulation);
    FeedStatus const status = feed.status(now);
    plan.weather = liveInput(*news, status.given.value_or(now), status.stale);
    plan.weatherSha256 = weather::sha256Hex(news->recording);
    plan.simulation.time = now;
}

std::optional<std::string> followFeed(Session& session, WeatherFeed& feed) {
    core::UtcSeconds const now = feedTime(feed, session.simulation());
    auto const news = feed.poll(now, placeOf(session.simulation()));
    if (!news) return std::nullopt;
    FeedStatus const status = feed.status(now);
    WeatherInput input = liveInput(*news, status.given.value_or(now), status.stale);
    bool const first = session.world().source() != kLiveSource;
    input.seconds = first ? kFirstSeconds : kFeedSeconds;
    if (feed.pace() == FeedPace::beside) {
        session.offerWeather(std::move(input));
        return std::nullopt;
    }
    input.from = session.simulation().utc();
    try {
        session.input(input);
    } catch (core::Error const& error) {
        return error.what();
    }
    return std::nullopt;
}
}  // namespace luftpost::app
