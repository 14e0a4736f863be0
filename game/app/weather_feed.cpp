#include "game/app/weather_feed.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <random>
#include <utility>

#include "engine/core/time.h"
#include "engine/platform/paths.h"
#include "engine/weather/source.h"
#include "game/app/feed_cache.h"

namespace luftpost::app {
namespace {
constexpr double kKeptNear = 50'000.0;  // m: weather kept of a place further off is none for here
constexpr double kAhead = 3600.0;       // s: the clock of a flight without a window may have run ahead of the wall

double steadySeconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::filesystem::path cacheFile(std::filesystem::path const& folder, WeatherSettings const& settings) {
    if (folder.empty()) return {};
    return folder / fmt::format("weather_{}.json", kProviderWords[static_cast<std::size_t>(settings.provider)]);
}

/// Two flights without a window are the same flight; two players are two.
unsigned seedOf(FeedPace pace) { return pace == FeedPace::inLine ? 1u : std::random_device{}(); }
}  // namespace

std::filesystem::path feedCacheFolder(WeatherSettings const& settings, bool window) {
    bool const kept = settings.cache == CacheUse::always || (settings.cache == CacheUse::window && window);
    return kept ? platform::cacheFolder() : std::filesystem::path{};
}

WeatherFeed::WeatherFeed(WeatherSettings settings, FeedPace pace, std::filesystem::path cacheFolder)
    : settings_{std::move(settings)},
      pace_{pace},
      cache_{cacheFile(cacheFolder, settings_)},
      schedule_{intervalOf(settings_), seedOf(pace)} {}

WeatherFeed::~WeatherFeed() {
    stop_ = true;
    if (thread_.joinable()) thread_.request_stop();
}

std::optional<WeatherNews> WeatherFeed::poll(core::UtcSeconds now, FeedPlace const& place) {
    std::unique_lock lock{mutex_};
    if (!place_) start(now, place);
    place_ = place;
    if (pace_ == FeedPace::inLine && schedule_.due(now, place)) {
        lock.unlock();
        ask(now, now, place);
        lock.lock();
    }
    return std::exchange(fresh_, std::nullopt);
}

/// What was kept of the last time, then the thread.
void WeatherFeed::start(core::UtcSeconds now, FeedPlace const& place) {
    if (auto const kept = cache_.empty() ? std::nullopt : readKept(cache_); kept && kept->asked <= now + kAhead) {
        bool const tells = kept->news.lastReport >= now && distance(kept->news.place, place) < kKeptNear;
        spdlog::info("live weather: kept of {}{}", core::formatUtc(kept->asked), tells ? "" : ", of no use here and now");
        if (tells) {
            last_ = fresh_ = kept->news;
            given_ = kept->news.givenAt(kept->asked);
        }
    }
    if (pace_ == FeedPace::beside) thread_ = std::jthread{[this] { work(); }};
}

/// One request at a time, each when it is due.
void WeatherFeed::work() {
    std::unique_lock lock{mutex_};
    std::stop_token const stop = thread_.get_stop_token();
    while (!stop.stop_requested()) {
        double const clock = steadySeconds();
        if (schedule_.due(clock, *place_)) {
            FeedPlace const place = *place_;
            lock.unlock();
            ask(clock, weather::contextOfNow().latest, place);
            lock.lock();
        } else {
            wake_.wait_for(lock, stop, std::chrono::milliseconds{500}, [] { return false; });
        }
    }
}

void WeatherFeed::ask(double clock, core::UtcSeconds now, FeedPlace const& place) {
    Fetched fetched = fetchWeather(settings_, place, now, validators_, stop_);
    if (stop_) return;
    std::optional<WeatherNews> const news = fetched.news;
    note(std::move(fetched), clock, now, place);
    if (news && !cache_.empty()) writeKept(cache_, {*news, now});
}

void WeatherFeed::note(Fetched fetched, double clock, core::UtcSeconds now, FeedPlace const& place) {
    std::lock_guard const lock{mutex_};
    double const done = pace_ == FeedPace::beside ? steadySeconds() : clock;
    if (!fetched.error.empty()) {
        schedule_.failed(done, place, fetched.retryAfter_s, fetched.refused);
        reason_ = fmt::format("{}; again in {:.0f} s", fetched.error, schedule_.next() - done);
        spdlog::warn("live weather: {}", reason_);
        return;
    }
    schedule_.succeeded(done, place);
    reason_.clear();
    bool const news = fetched.news && !(last_ && last_->recording == fetched.news->recording);
    if (fetched.news) last_ = std::move(fetched.news);
    if (last_) given_ = last_->givenAt(now);
    if (news) fresh_ = last_;
    spdlog::info("live weather: {} {}", factsOf(settings_.provider).name, news ? "brought a new forecast" : "has nothing new");
}

std::optional<WeatherNews> WeatherFeed::last() const {
    std::lock_guard const lock{mutex_};
    return last_;
}

FeedStatus WeatherFeed::status(core::UtcSeconds now) const {
    std::lock_guard const lock{mutex_};
    ProviderFacts const& facts = factsOf(settings_.provider);
    FeedStatus status{given_, given_ && isStale(*given_, now, settings_), {}, reason_};
    if (!given_) status.line = fmt::format("live: waiting for {}", facts.name);
    else status.line = facts.attribution;
    if (!reason_.empty()) status.line = (given_ ? "" : "live: ") + reason_;
    return status;
}
}  // namespace luftpost::app
