// When the next request for weather is due. Plain arithmetic on a clock that the caller chooses, in seconds.
#pragma once
#include <algorithm>
#include <optional>

#include "game/app/weather_provider.h"
#include "engine/core/random.h"

namespace luftpost::app {
/// After an answer the interval; after a failure longer and longer, up to the interval and never less than the server asks for; at
/// once after a long way. Each time with some chance in it, so that many players do not ask in one moment.
class FeedSchedule {
public:
    static constexpr double kFirstWait = 30.0;       // s, after the first failure
    static constexpr double kLongestWish = 21600.0;  // s: a server that wants more is asked again all the same
    static constexpr double kFar = 20'000.0;         // m from the place that was asked for

    FeedSchedule(double interval, unsigned seed) : interval_{interval}, random_{seed} {}

    bool due(double now, FeedPlace const& place) const {
        if (!last_ || now < *last_) return true;  // not yet asked, or the clock was set back
        bool const far = failures_ == 0 && distance(place, asked_) > kFar && now >= *last_ + shortest();
        return far || now >= next_;
    }
    void succeeded(double now, FeedPlace const& place) {
        failures_ = 0;
        wait(now, place, interval_ * (1.0 + random_.uniform(0.0, 0.05)));
    }
    /// `refused`: the server will not think otherwise soon.
    void failed(double now, FeedPlace const& place, std::optional<double> retryAfter, bool refused) {
        double const longest = std::max(interval_, shortest());
        double seconds = refused ? longest : shortest();
        for (int i = 0; i < failures_ && seconds < longest; ++i) seconds *= 2.0;
        seconds = std::min(seconds, longest) * random_.uniform(0.75, 1.25);
        ++failures_;
        wait(now, place, std::max(seconds, std::min(retryAfter.value_or(0.0), kLongestWish)));
    }
    int failures() const { return failures_; }
    double next() const { return next_; }

private:
    double shortest() const { return std::min(kFirstWait, interval_); }
    void wait(double now, FeedPlace const& place, double seconds) {
        last_ = now;
        asked_ = place;
        next_ = now + seconds;
    }

    double interval_;
    core::Random random_;
    std::optional<double> last_;
    FeedPlace asked_;
    double next_ = 0.0;
    int failures_ = 0;
};
}  // namespace luftpost::app
