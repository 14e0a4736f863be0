#include "game/app/replay_reel.h"

#include <algorithm>

#include "engine/core/check.h"
#include "engine/core/error.h"

namespace luftpost::app {
namespace {
constexpr long long kMostMoments = 6000;                          // of 4.4 KB
constexpr long long kLeastApart = core::kTicksPerSecond / 4;  // ticks, flown within a frame

bool isNoted(FlightEvent event) {
    return event == FlightEvent::released || event == FlightEvent::delivered || event == FlightEvent::lost || event == FlightEvent::crashed ||
           event == FlightEvent::touchdown;
}
}  // namespace

ReplayReel::ReplayReel(SessionOptions const& flight, long long ticks)
    : session_{flight}, ticks_{ticks}, apart_{std::max(kLeastApart, ticks / kMostMoments)} {
    keep();
    thread_ = std::jthread{[this](std::stop_token const& stop) { fly(stop); }};
}

ReplayReel::~ReplayReel() = default;

void ReplayReel::fly(std::stop_token const& stop) {
    try {
        while (!stop.stop_requested() && session_.simulation().tick() < ticks_) {
            session_.tick();
            note(session_.takeEvents());
            if (session_.simulation().tick() % apart_ == 0) keep();
            known_ = session_.simulation().tick();
        }
    } catch (core::Error const& error) {
        std::lock_guard const lock{mutex_};
        complaint_ = error.what();
    }
}

void ReplayReel::note(std::vector<FlightEventAt> const& events) {
    for (FlightEventAt const& event : events) {
        if (!isNoted(event.event)) continue;
        std::lock_guard const lock{mutex_};
        marks_.push_back({session_.simulation().tick(), event.event, event.text});
    }
}

void ReplayReel::keep() {
    Session::Moment moment = session_.moment();
    std::lock_guard const lock{mutex_};
    moments_.push_back(std::move(moment));
}

Session::Moment ReplayReel::before(long long tick) const {
    std::lock_guard const lock{mutex_};
    auto const after = std::upper_bound(moments_.begin(), moments_.end(), tick, [](long long t, Session::Moment const& moment) { return t < moment.simulation.tick; });
    CHECK(after != moments_.begin(), "no moment at or before tick {}", tick);
    return *std::prev(after);
}

std::vector<ReplayReel::Mark> ReplayReel::marks() const {
    std::lock_guard const lock{mutex_};
    return marks_;
}

std::string ReplayReel::complaint() const {
    std::lock_guard const lock{mutex_};
    return complaint_;
}
}  // namespace luftpost::app
