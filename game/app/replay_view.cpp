#include "game/app/replay_view.h"

#include <algorithm>
#include <cmath>

namespace luftpost::app {
namespace {
constexpr double kStep = 10.0;  // s that a key goes back or on

ui::ReplayMarkKind kindOf(FlightEvent event) {
    switch (event) {
        case FlightEvent::delivered: return ui::ReplayMarkKind::delivered;
        case FlightEvent::lost: return ui::ReplayMarkKind::lost;
        case FlightEvent::crashed: return ui::ReplayMarkKind::crashed;
        default: return ui::ReplayMarkKind::other;
    }
}

std::string textOf(ReplayReel::Mark const& mark) { return mark.text.empty() ? "Parcel released" : mark.text; }

/// The next speed up (+1) or down (-1).
double besides(double speed, int direction) {
    auto const& speeds = ui::kReplaySpeeds;
    auto const at = std::find(speeds.begin(), speeds.end(), speed) - speeds.begin();
    return speeds[static_cast<std::size_t>(std::clamp<long>(at + direction, 0, static_cast<long>(speeds.size()) - 1))];
}
}  // namespace

ui::ReplayBar ReplayView::bar(Simulation const& shown) const {
    ui::ReplayBar bar;
    bar.seconds = shown.seconds();
    bar.length = static_cast<double>(reel_.ticks()) * core::kTickSeconds;
    bar.known = static_cast<double>(reel_.known()) * core::kTickSeconds;
    bar.playing = playing_;
    bar.speed = speed_;
    for (ReplayReel::Mark const& mark : reel_.marks()) bar.marks.push_back({static_cast<double>(mark.tick) * core::kTickSeconds, kindOf(mark.event), textOf(mark)});
    bar.note = reel_.complaint();
    return bar;
}

void ReplayView::toggle(Session& shown) {
    playing_ = !playing_;
    if (playing_ && shown.simulation().tick() >= reel_.ticks()) seek(0.0, shown);
}

bool ReplayView::obey(ui::InputSample const& keys, Session& shown) {
    using ui::FlightKey;
    auto const went = [&](FlightKey key) { return keys.held(key) && !before_.held(key); };
    double const step = (went(FlightKey::rollRight) ? kStep : 0.0) - (went(FlightKey::rollLeft) ? kStep : 0.0);
    long long const tick = shown.simulation().tick();
    if (went(FlightKey::drop)) toggle(shown);
    if (went(FlightKey::thrustUp)) speed_ = besides(speed_, 1);
    if (went(FlightKey::thrustDown)) speed_ = besides(speed_, -1);
    if (step != 0.0) seek(shown.simulation().seconds() + step, shown);
    before_ = keys;
    return shown.simulation().tick() != tick;
}

void ReplayView::seek(double seconds, Session& shown) {
    long long const target = std::clamp(std::llround(seconds * core::kTicksPerSecond), 0LL, reel_.known());
    long long const now = shown.simulation().tick();
    if (target < now || target - now > reel_.ticksApart()) shown.goTo(reel_.before(target));
    while (shown.simulation().tick() < target) shown.tick();
    shown.takeEvents();  // of the way there nothing is said
}

void ReplayView::follow(Simulation const& shown) {
    if (shown.tick() >= reel_.ticks()) playing_ = false;
}
}  // namespace luftpost::app
