#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/weather/source.h"
#include "game/app/flight_plan.h"

namespace luftpost::app {
namespace {
using Json = nlohmann::ordered_json;
constexpr char const* kFormat = "luftpost-replay-1";
constexpr long long kMostTicks = 240'000'000;                            // of a million seconds
constexpr double kFirstUtc = -62167219200.0, kLastUtc = 253402300799.0;  // the years 0 to 9999
constexpr double kHighestStart = 25000.0, kFastestStart = 150.0;         // m, m/s
constexpr double kFarthestStart = 1.0e5;                                 // m from the origin
constexpr double kLongestChange = 86400.0;                               // s, from one weather to the next
constexpr double kMostTurns = 13.0;                                      // rad either way, as --start has it

Json settingsJson(FlightSettings settings) {
    core::SettingList list;
    appendFlightSettings(list, settings);
    Json json = Json::object();
    for (auto const& [key, value] : core::changedSettings(list))
        json[key] = std::visit([](auto const& v) { return Json(v); }, value);
    return json;
}

/// A loaded source by its name; weather that came on the way with all its reports, as the text that its checksum is of.
Json weatherJson(WeatherInput const& weather) {
    if (weather.recording.empty()) return weather.source;
    return {{"source", weather.source},   {"mode", weather::modeWord(weather.mode)}, {"fetched_utc", weather.fetched},
            {"from_utc", weather.from},   {"seconds", weather.seconds},              {"recording", weather.recording}};
}

Json planJson(FlightPlan const& plan) {
    SimulationOptions const& s = plan.simulation;
    return {{"weather", weatherJson(plan.weather)},
            {"weather_sha256", plan.weatherSha256},
            {"weather_latest_utc", plan.weatherLatest},
            {"place", {plan.place.lat_deg, plan.place.lon_deg, plan.place.altitude_m}},
            {"seed", s.seed},
            {"utc", s.time},
            {"start",
             {{"runway", s.start.runway},
              {"altitude", s.start.altitude},
              {"tas", s.start.tas},
              {"heading", s.start.heading},
              {"east_north", {s.start.eastNorth.x, s.start.eastNorth.y}}}},
            {"payload_kg", s.payload},
            {"fuel_kg", s.fuel},
            {"settings", settingsJson(s.settings)}};
}

Json sampleJson(ui::InputSample const& sample) {
    Json json{{"keys", sample.keys}};
    ui::PadAxes const& pad = sample.pad;
    if (pad.roll != 0.0f || pad.pitch != 0.0f || pad.yaw != 0.0f || pad.thrust != 0.0f || pad.brakes != 0.0f)
        json["pad"] = {pad.roll, pad.pitch, pad.yaw, pad.thrust, pad.brakes};
    if (pad.lever) json["lever"] = *pad.lever;
    if (pad.flaps) json["flaps"] = *pad.flaps;
    if (sample.mouse) json["mouse"] = {sample.mouse->roll, sample.mouse->pitch};
    if (!sample.direct) return json;
    ui::DirectStick const& stick = *sample.direct;
    json["stick"] = {stick.throttle ? Json(*stick.throttle) : Json(nullptr),
                     stick.elevator,
                     stick.aileron,
                     stick.rudder,
                     stick.flaps,
                     stick.brakes};
    return json;
}

Json inputJson(StampedInput const& input) {
    Json json{{"tick", input.tick}};
    if (auto const* sample = std::get_if<ui::InputSample>(&input.what)) json.update(sampleJson(*sample));
    if (auto const* weather = std::get_if<WeatherInput>(&input.what)) json["weather"] = weatherJson(*weather);
    if (auto const* clock = std::get_if<ClockInput>(&input.what)) json["utc"] = clock->utc;
    if (auto const* clock = std::get_if<ClockRateInput>(&input.what)) json["clock_rate"] = clock->rate;
    if (auto const* setting = std::get_if<SettingInput>(&input.what)) {
        json["setting"] = setting->key;
        json["value"] = std::visit([](auto const& v) { return Json(v); }, setting->value);
    }
    return json;
}

/// A part of the file, and where it is: "inputs[3].stick".
struct Part {
    Json const& json;
    std::string const& file;
    std::string place;

    Part operator[](char const* key) const {
        if (!json.is_object() || !json.contains(key)) refuse(fmt::format("an object with \"{}\"", key));
        return {json.at(key), file, place.empty() ? key : place + "." + key};
    }
    Part at(std::size_t index) const { return {json.at(index), file, fmt::format("{}[{}]", place, index)}; }
    bool has(char const* key) const { return json.is_object() && json.contains(key); }
    /// A list of so many things.
    Part list(std::size_t size) const {
        if (!json.is_array() || json.size() != size) refuse(fmt::format("a list of {}", size));
        return *this;
    }
    double number(double min, double max) const {
        if (!json.is_number() || !(json.get<double>() >= min && json.get<double>() <= max))
            refuse(fmt::format("a number {}..{}", min, max));
        return json.get<double>();
    }
    long long whole(long long min, long long max) const {
        bool const fits = json.is_number_unsigned()
                              ? json.get<unsigned long long>() <= static_cast<unsigned long long>(max)
                              : json.is_number_integer() && json.get<long long>() <= max;
        if (!fits || json.get<long long>() < min) refuse(fmt::format("a whole number {}..{}", min, max));
        return json.get<long long>();
    }
    std::string text() const {
        if (!json.is_string()) refuse("a text");
        return json.get<std::string>();
    }
    bool flag() const {
        if (!json.is_boolean()) refuse("true or false");
        return json.get<bool>();
    }
    [[noreturn]] void refuse(std::string const& expected) const {
        std::string found = json.dump();
        if (found.size() > 40) found = found.substr(0, 40) + "...";
        throw core::Error{file, place, fmt::format("expected {}, found {}", expected, found)};
    }
};

core::SettingValue valueFrom(Part const& part) {
    if (part.json.is_boolean()) return part.flag();
    if (part.json.is_number()) return part.json.get<double>();
    return part.text();
}

/// A setting that the simulation knows, with a value that it takes.
SettingInput settingFrom(std::string const& key, Part const& value) {
    FlightSettings settings;
    core::SettingList list;
    appendFlightSettings(list, settings);
    core::Setting* const setting = core::findSetting(list, key);
    if (!setting)
        throw core::Error{value.file, value.place,
                          fmt::format("expected a setting of the flight, found {}", key)};
    SettingInput const change{key, valueFrom(value)};
    core::assignSetting(*setting, fmt::format("{}: {}", value.file, value.place), change.value);
    return change;
}

ui::InputSample sampleFrom(Part const& part) {
    ui::InputSample sample;
    sample.keys =
        static_cast<unsigned>(part["keys"].whole(0, (1 << static_cast<unsigned>(ui::FlightKey::count)) - 1));
    if (part.has("pad")) {
        Part const axes = part["pad"].list(5);
        auto const axis = [&](std::size_t i) { return static_cast<float>(axes.at(i).number(-2.0, 2.0)); };
        sample.pad = {axis(0), axis(1), axis(2), axis(3), axis(4), {}, {}};
    }
    auto const lever = [&](char const* key) { return static_cast<float>(part[key].number(0.0, 1.0)); };
    if (part.has("lever")) sample.pad.lever = lever("lever");
    if (part.has("flaps")) sample.pad.flaps = lever("flaps");
    if (part.has("mouse")) {
        Part const mouse = part["mouse"].list(2);
        auto const axis = [&](std::size_t i) { return static_cast<float>(mouse.at(i).number(-1.0, 1.0)); };
        sample.mouse = ui::MouseStick{axis(0), axis(1)};
    }
    if (part.has("stick")) {
        Part const stick = part["stick"].list(6);
        auto const axis = [&](std::size_t i, double min) { return stick.at(i).number(min, 1.0); };
        sample.direct =
            ui::DirectStick{{}, axis(1, -1.0), axis(2, -1.0), axis(3, -1.0), axis(4, 0.0), axis(5, 0.0)};
        if (!stick.at(0).json.is_null()) sample.direct->throttle = axis(0, 0.0);
    }
    return sample;
}

weather::SourceMode modeFrom(Part const& part) {
    auto const word = std::find(weather::kSourceModeWords.begin(), weather::kSourceModeWords.end(), part.text());
    if (word == weather::kSourceModeWords.end()) part.refuse(fmt::format("one of {}", fmt::join(weather::kSourceModeWords, ", ")));
    return static_cast<weather::SourceMode>(word - weather::kSourceModeWords.begin());
}

WeatherInput weatherFrom(Part const& part) {
    if (!part.json.is_object()) return {.source = part.text()};
    WeatherInput weather{.source = part["source"].text(),
                         .recording = part["recording"].text(),
                         .mode = modeFrom(part["mode"]),
                         .fetched = part["fetched_utc"].number(kFirstUtc, kLastUtc),
                         .from = part["from_utc"].number(kFirstUtc, kLastUtc),
                         .seconds = part["seconds"].number(0.0, kLongestChange)};
    Part const text = part["recording"];
    weather::parseRecording(weather.recording, fmt::format("{}: {}", text.file, text.place));  // says what is wrong in it
    return weather;
}

FlightInput inputFrom(Part const& part) {
    if (part.has("setting")) return settingFrom(part["setting"].text(), part["value"]);
    if (part.has("weather")) return weatherFrom(part["weather"]);
    if (part.has("clock_rate")) return ClockRateInput{part["clock_rate"].number(0.0, kFastestClock)};
    if (part.has("utc")) return ClockInput{part["utc"].number(kFirstUtc, kLastUtc)};
    return sampleFrom(part);
}

FlightPlan planFrom(Part const& part, Hangar const& hangar) {
    FlightPlan plan;
    plan.weather = weatherFrom(part["weather"]);
    plan.weatherSha256 = part["weather_sha256"].text();
    plan.weatherLatest = part["weather_latest_utc"].number(kFirstUtc, kLastUtc);
    Part const place = part["place"].list(3);
    plan.place = {place.at(0).number(-90.0, 90.0), place.at(1).number(-180.0, 180.0),
                  place.at(2).number(-500.0, 20000.0)};
    SimulationOptions& s = plan.simulation;
    s.seed = static_cast<unsigned>(part["seed"].whole(0, 4294967295));
    s.time = part["utc"].number(kFirstUtc, kLastUtc);
    Part const start = part["start"];
    s.start.runway = start["runway"].flag();
    s.start.altitude = start["altitude"].number(-kHighestStart, kHighestStart);
    s.start.tas = start["tas"].number(0.0, kFastestStart);
    s.start.heading = start["heading"].number(-kMostTurns, kMostTurns);
    if (start.has("east_north")) {  // not in files of before
        Part const origin = start["east_north"].list(2);
        auto const metres = [&](std::size_t i) { return origin.at(i).number(-kFarthestStart, kFarthestStart); };
        s.start.eastNorth = {metres(0), metres(1)};
    }
    core::SettingList list;
    appendFlightSettings(list, s.settings);
    Part const settings = part["settings"];
    for (auto const& [key, value] : settings.json.items()) {
        SettingInput const change = settingFrom(key, settings[key.c_str()]);
        core::findSetting(list, key)->set(change.value);
    }
    flight::Airframe const& airframe = chosen(hangar, s.settings.pilot.airframe);
    s.payload = part["payload_kg"].number(0.0, airframe.payloadMax);
    s.fuel = part["fuel_kg"].number(0.0, airframe.fuelMax);
    return plan;
}
}  // namespace

std::string replayText(Replay const& replay) {
    Json json{{"format", kFormat}, {"plan", planJson(replay.plan)}, {"ticks", replay.ticks}};
    std::string text = json.dump();
    text.back() = ',';
    text += "\n\"inputs\":[";
    char const* separator = "\n";
    for (StampedInput const& input : replay.inputs) {
        text += separator + inputJson(input).dump();
        separator = ",\n";
    }
    return text + "\n]}\n";
}

Replay readReplay(std::filesystem::path const& file, Hangar const& hangar) {
    std::string const name = file.string();
    std::string const bytes = core::readFile(file);
    Json const json = Json::parse(bytes, nullptr, false);
    if (!json.is_object() || json.value("format", Json{}) != kFormat)
        throw core::Error{name, "format", fmt::format("expected a {} file", kFormat)};
    Part const whole{json, name, ""};
    Replay replay{planFrom(whole["plan"], hangar), whole["ticks"].whole(0, kMostTicks), {}};
    Part const inputs = whole["inputs"];
    inputs.list(inputs.json.size());
    long long before = 0;
    for (std::size_t i = 0; i < inputs.json.size(); ++i) {
        before = inputs.at(i)["tick"].whole(before, kMostTicks);
        replay.inputs.push_back({before, inputFrom(inputs.at(i))});
    }
    return replay;
}
}  // namespace luftpost::app
