// luftpost weather SOURCE: what was understood, and what was filled in.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <memory>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/genera.h"
#include "engine/weather/report_json.h"
#include "engine/weather/source.h"
#include "game/app/commands.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
namespace {
using Json = nlohmann::ordered_json;
using weather::Field;
using weather::FieldReport;
using weather::SiteReport;

struct WeatherTexts {
    std::string source;
    bool json = false;
};

/// The reports to show: all of them, or one a site at the time asked for.
std::vector<std::vector<FieldReport>> shownReports(Field const& field, std::optional<core::UtcSeconds> time) {
    if (!time) return field.reports();
    std::vector<std::vector<FieldReport>> shown;
    weather::FieldInstant const now = field.instant(*time);
    for (std::size_t i = 0; i < field.sites(); ++i) shown.push_back({field.reportAt(i, now)});
    return shown;
}

/// The same in the order of the file.
std::vector<SiteReport> listedReports(Field const& field, std::optional<core::UtcSeconds> time) {
    if (!time) return field.listedReports();
    std::vector<SiteReport> listed;
    weather::FieldInstant const now = field.instant(*time);
    for (std::size_t i = 0; i < field.sites(); ++i) listed.push_back({i, field.reportAt(i, now)});
    return listed;
}

Json sourceJson(Field const& field, std::optional<core::UtcSeconds> time) {
    weather::Origin const& origin = field.origin();
    bool const preset = origin.mode == weather::SourceMode::Preset, live = isLive(origin.mode);
    core::UtcSeconds const asked = time.value_or(live ? weather::contextOfNow().latest : field.end());
    double const age = live ? std::max(asked - origin.fetched, 0.0) : field.age(asked);
    Json json{{"provider", origin.provider}, {"mode", weather::modeWord(origin.mode)}};
    json["time"] = preset ? Json() : Json(core::formatUtc(live ? origin.fetched : std::max(field.start(), asked - age)));
    json["age_s"] = preset ? Json() : Json(age);
    json["sha256"] = origin.sha256.empty() ? Json() : Json(origin.sha256);
    return json;
}

void printJson(Field const& field, std::optional<core::UtcSeconds> time) {
    Json json{{"source", sourceJson(field, time)}, {"sites", Json::array()}};
    for (SiteReport const& shown : listedReports(field, time))
        json["sites"].push_back(reportJson(field.recording().sites[shown.site], shown.report.said, shown.report.filled));
    fmt::print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
}

/// What the field uses of one number, a star behind what nobody said.
std::string number(std::optional<double> said, FieldReport const& report, std::string const& place, int digits, double factor = 1.0) {
    if (said) return fmt::format("{:.{}f}", *said * factor, digits);
    auto const filled = report.filled.find(place);
    if (filled == report.filled.end()) return "-";
    return fmt::format("{:.{}f}*", std::get<double>(filled->second) * factor, digits);
}

std::string layerText(FieldReport const& report, std::size_t i) {
    weather::ReportedLayer const layer = report.said.layers && i < report.said.layers->size() ? (*report.said.layers)[i] : weather::ReportedLayer{};
    std::string const place = fmt::format("layers[{}].", i);
    auto const filled = report.filled.find(place + "genus");
    std::string const genus = layer.genus                    ? std::string{weather::genusName(*layer.genus)}
                              : filled != report.filled.end() ? std::get<std::string>(filled->second) + "*"
                                                              : "?";
    return fmt::format("{} {}/8 {}-{} m", genus, number(layer.cover, report, place + "cover", 1, 8.0), number(layer.base_m, report, place + "base_m", 0),
                       number(layer.top_m, report, place + "top_m", 0));
}

std::string cloudText(FieldReport const& report) {
    std::string text;
    for (std::size_t i = 0;; ++i) {
        bool const said = report.said.layers && i < report.said.layers->size();
        if (!said && !report.filled.contains(fmt::format("layers[{}].genus", i))) break;
        text += (i > 0 ? ", " : "") + layerText(report, i);
    }
    if (!text.empty()) return text;
    return report.said.layers ? "no cloud" : "nothing said: no cloud*";
}

std::string fallText(FieldReport const& report) {
    auto const kind = report.filled.find("precipitation.kind");
    std::string const name = kind != report.filled.end()     ? std::get<std::string>(kind->second) + "*"
                             : report.said.precipitationKind ? std::string{weather::precipitationName(*report.said.precipitationKind)}
                                                             : "-";
    auto const thunder = report.filled.find("thunder");
    bool const thunders = report.said.thunder.value_or(thunder != report.filled.end() && std::get<bool>(thunder->second));
    return fmt::format("{} {}{}", name, number(report.said.rate_mm_h, report, "precipitation.rate_mm_h", 1), thunders ? " thunder" : "");
}

void printRow(FieldReport const& report) {
    weather::Report const& r = report.said;
    fmt::print("{}  {:>5} {:>5} {:>5}  {:>6}  {:>6} {:>6}  {:>7}  {:<14}  {}\n", core::formatUtc(r.time), number(r.from_deg, report, "wind.from_deg", 0),
               number(r.speed_mps, report, "wind.speed_mps", 1), number(r.gust_mps, report, "wind.gust_mps", 1),
               (r.visibilityIsMinimum ? ">" : "") + number(r.visibilityIsMinimum ? std::nullopt : r.visibility_m, report, "visibility_m", 1, 0.001),
               number(r.temperature_c, report, "temperature_c", 1), number(r.dew_point_c, report, "dew_point_c", 1),
               number(r.pressure_hpa, report, "pressure_hpa", 1), fallText(report), cloudText(report));
}

constexpr std::size_t kMostRows = 80;  // of one site; more are thinned to even steps

void printSite(Field const& field, std::size_t i, std::vector<FieldReport> const& reports) {
    weather::Site const& site = field.recording().sites[i];
    auto const degrees = [](std::optional<double> value) { return value ? fmt::format("{:.3f}", *value) : std::string{"unknown"}; };
    fmt::print("\n{}: latitude {}, longitude {}, {}\n", site.name, degrees(site.lat_deg), degrees(site.lon_deg),
               site.elevation_m ? fmt::format("{:.0f} m above sea level", *site.elevation_m) : std::string{"elevation unknown, 0 m used"});
    std::size_t const step = (reports.size() + kMostRows - 1) / kMostRows;
    fmt::print("{} report{}{}\n", reports.size(), reports.size() == 1 ? "" : "s", step > 1 ? fmt::format(", one in {} shown", step) : "");
    fmt::print("{:<20}  {:>5} {:>5} {:>5}  {:>6}  {:>6} {:>6}  {:>7}  {:<14}  {}\n", "time (UTC)", "from", "m/s", "gust", "vis km", "temp C", "dew C", "hPa",
               "mm/h", "clouds, above sea level");
    for (std::size_t k = 0; k < reports.size(); k += step) printRow(reports[k]);
}

void printFilled(std::vector<std::vector<FieldReport>> const& shown) {
    std::map<std::string, std::size_t> counts;
    std::size_t total = 0;
    for (auto const& site : shown)
        for (FieldReport const& report : site) {
            ++total;
            for (auto const& [place, value] : report.filled) ++counts[place];
        }
    if (counts.empty()) {
        fmt::print("\nNothing was filled in.\n");
        return;
    }
    fmt::print("\nFilled in (* above), in how many of {} report{}:\n", total, total == 1 ? "" : "s");
    for (auto const& [place, count] : counts) fmt::print("  {:<26} {}\n", place, count);
}

void printText(Field const& field, std::optional<core::UtcSeconds> time) {
    weather::Origin const& origin = field.origin();
    bool const preset = origin.mode == weather::SourceMode::Preset;
    fmt::print("{}\nsource   {}, {}\nlicence  {}\n", origin.name, origin.provider, weather::modeWord(origin.mode), origin.licence);
    if (!preset) fmt::print("period   {} to {}\nsha256   {}\n", core::formatUtc(field.start()), core::formatUtc(field.end()), origin.sha256);
    for (std::string const& key : field.recording().unknownKeys) fmt::print("ignored  {} (unknown key)\n", key);
    for (std::string const& note : field.recording().notes) fmt::print("unread   {}\n", note);
    if (time && !field.covers(*time))
        fmt::print("held     {} is outside the recording: its nearest end is shown\n", core::formatUtc(*time));
    auto const shown = shownReports(field, time);
    for (std::size_t i = 0; i < shown.size(); ++i) printSite(field, i, shown[i]);
    printFilled(shown);
}

/// What --json has no place for goes to standard error.
void printNotes(Field const& field, std::optional<core::UtcSeconds> time) {
    for (std::string const& key : field.recording().unknownKeys) fmt::print(stderr, "{}: ignored the unknown key {}\n", field.recording().file, key);
    for (std::string const& note : field.recording().notes) fmt::print(stderr, "{}: {}\n", field.recording().file, note);
    if (time && !field.covers(*time))
        fmt::print(stderr, "--time {} is outside the recording: its nearest end is held\n", core::formatUtc(*time));
}

int runWeather(WeatherTexts const& texts, CommonOptions const& common) {
    if (!common.weather.empty())
        throw core::Error{"--weather", "", fmt::format("expected not together with the source {}", texts.source)};
    Field const field = loadField(texts.source, placeWish(common), common);
    if (texts.json) {
        printNotes(field, common.time);
        printJson(field, common.time);
    } else {
        printText(field, common.time);
    }
    return 0;
}
}  // namespace

void addWeatherCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    auto const texts = std::make_shared<WeatherTexts>();
    CLI::App* const command = app.add_subcommand("weather", "what was understood of a source of weather, and what was filled in");
    command->add_option("source", texts->source, "FILE, recorded:FILE, live or preset:NAME")->required();
    command->add_flag("--json", texts->json, "for programs");
    command->callback([texts, &common, &chosen] { chosen = [texts, &common] { return runWeather(*texts, common); }; });
}
}  // namespace luftpost::app
