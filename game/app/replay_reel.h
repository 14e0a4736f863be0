// A replay flown ahead of the viewer, so that every moment of it can be gone to at once: a thread of its own flies the whole flight and keeps its state
// again and again. Main thread, but for that one.
#pragma once
#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "game/app/session.h"

namespace luftpost::app {
class ReplayReel {
public:
    /// Something of note on the way.
    struct Mark {
        long long tick = 0;
        FlightEvent event = FlightEvent::released;
        std::string text;
    };

    /// Throws core::Error as Session does.
    ReplayReel(SessionOptions const& flight, long long ticks);
    ~ReplayReel();
    ReplayReel(ReplayReel const&) = delete;
    ReplayReel& operator=(ReplayReel const&) = delete;

    long long ticks() const { return ticks_; }
    /// So far it is flown.
    long long known() const { return known_; }
    /// The latest kept moment at or before the tick.
    Session::Moment before(long long tick) const;
    /// Ticks of flight from one kept moment to the next: so many are left to fly to any tick.
    long long ticksApart() const { return apart_; }
    std::vector<Mark> marks() const;
    /// Why it ended early; empty: it did not.
    std::string complaint() const;

private:
    void fly(std::stop_token const& stop);
    void note(std::vector<FlightEventAt> const& events);
    void keep();

    Session session_;
    long long ticks_;
    long long apart_;
    std::atomic<long long> known_{0};
    mutable std::mutex mutex_;  // over the rest
    std::vector<Session::Moment> moments_;
    std::vector<Mark> marks_;
    std::string complaint_;
    std::jthread thread_;       // the last member: it ends before anything else goes
};
}  // namespace luftpost::app
