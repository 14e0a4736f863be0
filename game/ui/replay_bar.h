// The bar of a replay that is watched: play, speed, and the time line with what happened on it. Plain data in, the player's wishes out. Main thread,
// between ScreenFrame::begin and end.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace luftpost::ui {
inline constexpr std::array<double, 7> kReplaySpeeds{0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

enum class ReplayMarkKind { delivered, lost, crashed, other };
struct ReplayMark {
    double seconds = 0.0;
    ReplayMarkKind kind = ReplayMarkKind::other;
    std::string text;
};

/// Seconds of flight throughout.
struct ReplayBar {
    double seconds = 0.0, length = 0.0;
    double known = 0.0;              // so far one can go
    bool playing = true;
    double speed = 1.0;
    std::vector<ReplayMark> marks;
    std::string note;                // what went wrong
};
struct ReplayAnswer {
    bool toggle = false;             // play or stop
    std::optional<double> speed;
    std::optional<double> seconds;   // go there
};
ReplayAnswer drawReplayBar(ReplayBar const& bar);
}  // namespace luftpost::ui
