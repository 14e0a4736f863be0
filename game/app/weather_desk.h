// The weather's side of the config menu: what it offers, the strip of the recording in use, the player's hand. Main thread.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "game/app/real_hours.h"
#include "game/app/session.h"
#include "game/ui/weather_page.h"

namespace luftpost::app {
class WeatherDesk {
public:
    static constexpr double kHandPause = 0.25;  // s between two inputs of a hand that drags: a replay stays small
    static constexpr int kStripColumns = 96;

    /// What is bundled, and `given`, the source of the command line. A broken file of hours offers nothing and is said by `takeComplaint`.
    explicit WeatherDesk(std::string const& given);

    /// What the menu shows now.
    ui::MenuWeather menu(Session const& session);
    /// Does what the player asked for, but for the photograph and the live source. The hour to fly, if it was that. A line where it cannot be.
    std::optional<RealHour> obey(ui::WeatherAnswer const& answer, Session& session);
    /// Once a frame; `frozen`: no tick passes, so that a change must come at once.
    void advance(double wallSeconds, bool frozen, Session& session);
    std::optional<std::string> takeComplaint() { return std::exchange(complaint_, std::nullopt); }

private:
    void useSource(std::string const& source, Session& session);
    ui::HandWeather present(Session const& session) const;
    ui::WeatherStrip const* stripFor(Session const& session);

    std::vector<ui::MenuWeather::Source> sources_;
    std::vector<RealHour> hours_;
    std::optional<ui::HandWeather> hand_;  // as the player left it; none until touched
    bool handWaits_ = false;               // for its input
    double sinceHand_ = kHandPause;        // s
    ui::WeatherStrip strip_;
    std::string stripOf_;                  // the checksum of its recording
    std::optional<std::string> complaint_;
};
}  // namespace luftpost::app
