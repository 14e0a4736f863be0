// Flights of the game for tests of what acts in them: what they begin with, on their way, and back from their replay.
#pragma once
#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/frames.h"
#include "game/app/hangar.h"
#include "game/app/session.h"
#include "tests/support/scratch.h"

namespace luftpost::tests {
inline constexpr double kStartAltitude = 900.0;  // m above sea level

/// In the air over the hills east of Bern at noon of 1 May 2024; `source` as in --weather.
inline app::FlightPlan planOver(std::string const& source) {
    app::FlightPlan plan;
    plan.weather.source = source;
    plan.place = {47.0, 8.0, 430.0};
    plan.simulation.time = 1714564800.0;
    plan.simulation.start.altitude = kStartAltitude;
    return plan;
}

inline app::SessionOptions flying(app::FlightPlan const& plan, std::vector<app::StampedInput> script = {}) {
    app::SessionOptions options;
    options.plan = plan;
    options.script = std::move(script);
    return options;
}

inline void fly(app::Session& session, double seconds) {
    for (int i = 0; i < seconds * core::kTicksPerSecond; ++i) session.tick();
}

/// The replay that a file with this text holds.
inline app::Replay readBack(std::string const& text) {
    std::filesystem::path const file = scratch() / "flight.replay";
    core::writeFileAtomically(file, text);
    return app::readReplay(file, app::loadHangar());
}

/// What is said of `text` once `from` in it is `to`; "read" where nothing is.
inline std::string refusal(std::string text, std::string_view from, std::string_view to) {
    auto const at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    if (at == text.npos) return {};
    text.replace(at, from.size(), to);
    try {
        readBack(text);
    } catch (core::Error const& error) {
        return error.what();
    }
    return "read";
}

/// Where the flight's replay ends.
inline std::string hashOfReplay(app::Session const& session) {
    app::Replay const replay = readBack(app::replayText(session.replay()));
    app::Session again{flying(replay.plan, replay.inputs)};
    while (again.simulation().tick() < replay.ticks) again.tick();
    return again.simulation().stateHash();
}
}  // namespace luftpost::tests
