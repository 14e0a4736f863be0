#include "game/app/weather_desk.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/platform/paths.h"
#include "engine/weather/presets.h"
#include "engine/weather/source.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
namespace {
constexpr std::size_t kWidestLabel = 58;  // characters: longer is cut

/// "21 Jun 06:00 to 23 Jun 23:50 UTC, 2023"
std::string periodText(weather::Recording const& recording) {
    double from = recording.sites.front().reports.front().time, to = from;
    for (weather::Site const& site : recording.sites)
        from = std::min(from, site.reports.front().time), to = std::max(to, site.reports.back().time);
    std::string const a = core::formatUtc(from), b = core::formatUtc(to);
    return fmt::format("{} {} to {} {} UTC", a.substr(0, 10), a.substr(11, 5), b.substr(0, 10) == a.substr(0, 10) ? "" : b.substr(0, 10), b.substr(11, 5));
}

/// A recording, in any format, as the menu offers it; none where it does not load.
std::optional<ui::MenuWeather::Source> recordedSource(std::filesystem::path const& file, std::string const& why) {
    try {
        weather::Recording const recording =
            weather::readWeather("recorded:" + file.string(), std::nullopt, sourceContext(weather::contextOfNow().latest));
        std::string const period = periodText(recording);
        return ui::MenuWeather::Source{"recorded:" + file.string(), recording.name.substr(0, kWidestLabel), why.empty() ? period : period + ". " + why, false};
    } catch (core::Error const&) {
        return std::nullopt;
    }
}

std::string whenText(RealHour const& hour) {
    std::string const time = core::formatUtc(hour.time);
    return fmt::format("{}, {} {} UTC", hour.placeName, time.substr(0, 10), time.substr(11, 5));
}
}  // namespace

WeatherDesk::WeatherDesk(std::string const& given) {
    sources_.push_back({kLiveSource, "Live: the weather of now", "From a provider, over the network: page Live", false});
    try {
        HoursFile const file = readHours(platform::dataFile(std::string{kHoursFile}));
        for (BundledRecording const& bundled : file.recordings)
            if (auto source = recordedSource(bundled.file, bundled.why)) sources_.push_back(std::move(*source));
        hours_ = file.hours;
    } catch (core::Error const& error) {
        complaint_ = error.what();
    }
    for (weather::PresetName const& preset : weather::presetNames())
        sources_.push_back({fmt::format("preset:{}", preset.name), std::string{preset.name}, std::string{preset.description}, true});
    bool const known = std::any_of(sources_.begin(), sources_.end(), [&](auto const& source) { return source.source == given; });
    if (known || !given.starts_with("recorded:")) return;
    if (auto source = recordedSource(given.substr(given.find(':') + 1), "From the command line")) sources_.insert(sources_.begin() + 1, std::move(*source));
}

ui::HandWeather WeatherDesk::present(Session const& session) const {
    Simulation const& simulation = session.simulation();
    glm::dvec3 const& at = simulation.aircraft().state().positionWorld;
    return ui::handFrom(session.world().field().at(at.x, -at.z, simulation.utc()));
}

ui::WeatherStrip const* WeatherDesk::stripFor(Session const& session) {
    weather::Field const& field = session.world().field();
    if (field.origin().mode == weather::SourceMode::Preset || !(field.end() > field.start())) return nullptr;
    if (stripOf_ != field.origin().sha256) {
        strip_ = ui::weatherStrip(field, glm::dvec2{0.0}, kStripColumns);
        stripOf_ = field.origin().sha256;
    }
    return &strip_;
}

ui::MenuWeather WeatherDesk::menu(Session const& session) {
    weather::Field const& field = session.world().field();
    Simulation const& simulation = session.simulation();
    ui::MenuWeather menu;
    menu.sources = sources_;
    for (RealHour const& hour : hours_) menu.hours.push_back({hour.name, whenText(hour), hour.why});
    menu.current = session.world().source();
    menu.utc = simulation.utc();
    menu.strip = stripFor(session);
    menu.start = menu.end = field.start();
    if (menu.strip) menu.end = field.end();
    menu.rate = simulation.clockRate();
    menu.byHand = menu.current == kHandSource;
    menu.hand = hand_ ? *hand_ : present(session);
    menu.elevation = session.world().place().altitude_m;
    return menu;
}

void WeatherDesk::useSource(std::string const& source, Session& session) {
    try {
        session.world().loadWeather(source);
        session.input(WeatherInput{.source = source});
        session.world().forgetUnused();
    } catch (core::Error const& error) {
        complaint_ = error.what();
    }
}

std::optional<RealHour> WeatherDesk::obey(ui::WeatherAnswer const& answer, Session& session) {
    if (answer.source && *answer.source != kLiveSource) useSource(*answer.source, session), handWaits_ = false;
    if (answer.utc) session.input(ClockInput{*answer.utc});
    if (answer.rate) session.input(ClockRateInput{*answer.rate});
    if (answer.startFromHere) hand_ = present(session), handWaits_ = true;
    if (answer.hand) hand_ = answer.hand, handWaits_ = true;
    if (answer.hour && *answer.hour < hours_.size()) return hours_[*answer.hour];
    return std::nullopt;
}

void WeatherDesk::advance(double wallSeconds, bool frozen, Session& session) {
    sinceHand_ += wallSeconds;
    if (!handWaits_ || sinceHand_ < kHandPause) return;
    handWaits_ = false;
    sinceHand_ = 0.0;
    Simulation const& simulation = session.simulation();
    weather::Recording const recording = ui::handRecording(*hand_, session.world().place(), simulation.utc());
    double const rate = frozen ? 0.0 : simulation.clockRate();  // the change takes as long for the player at any speed of time
    session.offerWeather({.source = kHandSource, .recording = weather::recordingText(recording), .mode = weather::SourceMode::Preset, .seconds = kHandSeconds * rate});
}
}  // namespace luftpost::app
