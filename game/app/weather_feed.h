// Live weather for a flight: asked for again and again, kept for the next start, told how old it is.
#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "game/app/feed_schedule.h"
#include "game/app/weather_provider.h"
#include "game/app/weather_settings.h"

namespace luftpost::app {
/// beside: on a thread of its own, by the wall clock, so that no frame waits. inLine: the caller waits for each answer, by the clock
/// that the caller brings; without a window a flight so has its weather at the same tick however fast it runs.
enum class FeedPace { beside, inLine };

/// Where the feed stands.
struct FeedStatus {
    std::optional<core::UtcSeconds> given;  // the time that the weather in hand is of; none: nothing has come yet
    bool stale = false;                     // older than two intervals
    std::string line;                       // for the HUD: the attribution, or what is waited for, or why the last request failed
    std::string reason;                     // of the last failure; empty: the last request went well
};

/// Kept answers lie here, one file a provider; empty: none is kept.
std::filesystem::path feedCacheFolder(WeatherSettings const& settings, bool window);

class WeatherFeed {
public:
    /// Asks nobody before the first poll. What the cache keeps of this provider is taken if it still has a forecast for the time.
    WeatherFeed(WeatherSettings settings, FeedPace pace, std::filesystem::path cacheFolder);
    /// A request under way is given up, not waited for.
    ~WeatherFeed();
    WeatherFeed(WeatherFeed const&) = delete;
    WeatherFeed& operator=(WeatherFeed const&) = delete;

    /// Once a frame, one thread: where the aircraft is now, and what has come since, once.
    std::optional<WeatherNews> poll(core::UtcSeconds now, FeedPlace const& place);
    FeedStatus status(core::UtcSeconds now) const;
    /// What came last, taken or not.
    std::optional<WeatherNews> last() const;
    WeatherSettings const& settings() const { return settings_; }
    FeedPace pace() const { return pace_; }

private:
    void work();
    void ask(double clock, core::UtcSeconds now, FeedPlace const& place);
    void note(Fetched fetched, double clock, core::UtcSeconds now, FeedPlace const& place);
    void start(core::UtcSeconds now, FeedPlace const& place);

    WeatherSettings const settings_;
    FeedPace const pace_;
    std::filesystem::path const cache_;  // the file; empty: none
    std::atomic<bool> stop_ = false;
    Validators validators_;              // of whoever asks: one thread

    mutable std::mutex mutex_;           // over the rest
    std::condition_variable_any wake_;
    FeedSchedule schedule_;
    std::optional<FeedPlace> place_;     // none before the first poll
    std::optional<WeatherNews> last_, fresh_;  // fresh_: not yet taken
    std::optional<core::UtcSeconds> given_;
    std::string reason_;
    std::jthread thread_;                // beside
};
}  // namespace luftpost::app
