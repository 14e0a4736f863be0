// A replay that is watched: where it is, how fast it runs, and the way to any other moment of it.
#pragma once
#include "game/app/replay_reel.h"
#include "game/ui/devices.h"
#include "game/ui/replay_bar.h"

namespace luftpost::app {
class ReplayView {
public:
    /// Throws core::Error as Session does.
    ReplayView(SessionOptions const& flight, long long ticks) : reel_{flight, ticks} {}

    bool playing() const { return playing_; }
    /// Seconds of flight to one of the player's.
    double speed() const { return speed_; }
    ui::ReplayBar bar(Simulation const& shown) const;

    /// Plays or stops; at the end it begins again.
    void toggle(Session& shown);
    void setSpeed(double speed) { speed_ = speed; }
    /// The keys that fly the aircraft: drop plays and stops, roll goes ten seconds back and on, thrust is the speed. True when it went somewhere.
    bool obey(ui::InputSample const& keys, Session& shown);
    /// Sets `shown` to this second of flight, or to the last that is known. At most ReplayReel::ticksApart are flown for it.
    void seek(double seconds, Session& shown);
    /// Once a frame, after its ticks: stops at the end.
    void follow(Simulation const& shown);

private:
    ReplayReel reel_;
    bool playing_ = true;
    double speed_ = 1.0;
    ui::InputSample before_;
};
}  // namespace luftpost::app
