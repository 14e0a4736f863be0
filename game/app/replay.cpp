#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "game/app/flight_plan.h"

namespace luftpost::app {
namespace {
using Json = nlohmann::ordered_json;
constexpr char const* kFormat = "luftpost-replay-1";

Json settingsJson(FlightSettings settings) {
    core::SettingList list;
    appendFlightSettings(list, settings);
    Json json = Json::object();
    for (auto const& [key, value] : core::changedSettings(list))
        json[key] = std::visit([](auto const& v) { return Json(v); }, value);
    return json;
}

Json planJson(FlightPlan const& plan) {
    SimulationOptions const& s = plan.simulation;
    return {{"weather", plan.weather},
            {"weather_sha256", plan.weatherSha256},
            {"place", {plan.place.lat_deg, plan.place.lon_deg, plan.place.altitude_m}},
            {"seed", s.seed},
            {"utc", s.time},
            {"start",
             {{"runway", s.start.runway},
              {"altitude", s.start.altitude},
              {"tas", s.start.tas},
              {"heading", s.start.heading}}},
            {"payload_kg", s.payload},
            {"fuel_kg", s.fuel},
            {"settings", settingsJson(s.settings)}};
}

Json sampleJson(ui::InputSample const& sample) {
    Json json{{"keys", sample.keys}};
    ui::PadAxes const& pad = sample.pad;
    if (pad != ui::PadAxes{}) json["pad"] = {pad.roll, pad.pitch, pad.yaw, pad.thrust, pad.brakes};
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
    if (auto const* weather = std::get_if<WeatherInput>(&input.what)) json["weather"] = weather->source;
    if (auto const* clock = std::get_if<ClockInput>(&input.what)) json["utc"] = clock->utc;
    if (auto const* setting = std::get_if<SettingInput>(&input.what)) {
        json["setting"] = setting->key;
        json["value"] = std::visit([](auto const& v) { return Json(v); }, setting->value);
    }
    return json;
}

core::SettingValue valueFrom(Json const& json) {
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_number()) return json.get<double>();
    return json.get<std::string>();
}

ui::InputSample sampleFrom(Json const& json) {
    ui::InputSample sample;
    sample.keys = json.at("keys").get<unsigned>();
    if (json.contains("pad")) {
        auto const axes = json["pad"].get<std::array<float, 5>>();
        sample.pad = {axes[0], axes[1], axes[2], axes[3], axes[4]};
    }
    if (json.contains("stick")) {
        Json const& stick = json["stick"];
        sample.direct = ui::DirectStick{{}, stick.at(1), stick.at(2), stick.at(3), stick.at(4), stick.at(5)};
        if (!stick.at(0).is_null()) sample.direct->throttle = stick.at(0).get<double>();
    }
    return sample;
}

FlightInput inputFrom(Json const& json) {
    if (json.contains("setting")) return SettingInput{json["setting"], valueFrom(json.at("value"))};
    if (json.contains("weather")) return WeatherInput{json["weather"]};
    if (json.contains("utc")) return ClockInput{json["utc"]};
    return sampleFrom(json);
}

FlightPlan planFrom(Json const& json, std::string const& file) {
    FlightPlan plan;
    plan.weather = json.at("weather");
    plan.weatherSha256 = json.at("weather_sha256");
    auto const place = json.at("place").get<std::array<double, 3>>();
    plan.place = {place[0], place[1], place[2]};
    SimulationOptions& s = plan.simulation;
    s.seed = json.at("seed");
    s.time = json.at("utc");
    Json const& start = json.at("start");
    s.start = {start.at("runway"), start.at("altitude"), start.at("tas"), start.at("heading")};
    s.payload = json.at("payload_kg");
    s.fuel = json.at("fuel_kg");
    core::SettingList list;
    appendFlightSettings(list, s.settings);
    for (auto const& [key, value] : json.at("settings").items()) {
        core::Setting* const setting = core::findSetting(list, key);
        if (!setting) throw core::Error{file, "plan.settings." + key, "expected a setting of the flight"};
        core::assignSetting(*setting, file, valueFrom(value));
    }
    return plan;
}

/// Keys that the simulation does not know would end the program later: refuse them here.
void checkInput(StampedInput const& input, long long before, std::string const& file, std::size_t index) {
    std::string const place = fmt::format("inputs[{}]", index);
    if (input.tick < before)
        throw core::Error{file, place, fmt::format("expected a tick not before {}", before)};
    auto const* change = std::get_if<SettingInput>(&input.what);
    if (!change) return;
    FlightSettings settings;
    core::SettingList list;
    appendFlightSettings(list, settings);
    core::Setting* const setting = core::findSetting(list, change->key);
    if (!setting) throw core::Error{file, place + "." + change->key, "expected a setting of the flight"};
    core::assignSetting(*setting, file, change->value);
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

Replay readReplay(std::filesystem::path const& file) {
    std::string const name = file.string();
    std::string const bytes = core::readFile(file);
    try {
        Json const json = Json::parse(bytes);
        if (!json.is_object() || json.value("format", "") != kFormat)
            throw core::Error{name, "format", fmt::format("expected {}", kFormat)};
        Replay replay{planFrom(json.at("plan"), name), json.at("ticks"), {}};
        long long before = 0;
        for (Json const& input : json.at("inputs")) {
            StampedInput const stamped{input.at("tick"), inputFrom(input)};
            checkInput(stamped, before, name, replay.inputs.size());
            before = stamped.tick;
            replay.inputs.push_back(stamped);
        }
        return replay;
    } catch (nlohmann::json::exception const& error) {
        throw core::Error{name, "", fmt::format("expected a {} file: {}", kFormat, error.what())};
    }
}
}  // namespace luftpost::app
