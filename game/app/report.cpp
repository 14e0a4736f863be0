#include "game/app/report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/core/frames.h"

namespace luftpost::app {
namespace {
using Json = nlohmann::ordered_json;

Json dropJson(delivery::Drop const& drop) {
    Json json{{"t_s", drop.t},
              {"release",
               {{"east_m", drop.releaseWorld.x},
                {"north_m", -drop.releaseWorld.z},
                {"altitude_m", drop.releaseWorld.y}}},
              {"landing", nullptr},
              {"distance_m", nullptr},
              {"score", drop.score}};
    if (!drop.landingTime) return json;
    json["landing"] = {
        {"t_s", *drop.landingTime}, {"east_m", drop.landingWorld.x}, {"north_m", -drop.landingWorld.z}};
    json["distance_m"] = drop.distance;
    return json;
}

Json landingJson(Landing const& landing) {
    Json json{{"t_s", landing.t},
              {"east_m", landing.placeWorld.x},
              {"north_m", -landing.placeWorld.z},
              {"touchdown_mps", landing.touchdownSpeed},
              {"ias_mps", landing.speed},
              {"load_factor", landing.loadFactor},
              {"drift_mps", landing.drift},
              {"bank_deg", core::degrees(landing.bank)},
              {"pitch_deg", core::degrees(landing.pitch)},
              {"bounces", landing.bounces},
              {"touch_and_go", landing.touchAndGo},
              {"aim", nullptr}};
    if (landing.aim) json["aim"] = {{"beyond_m", landing.aim->beyond}, {"off_line_m", landing.aim->offLine}};
    return json;
}

Json timesJson(std::vector<double> const& times) {
    return {
        {"p50", percentile(times, 0.5)}, {"p99", percentile(times, 0.99)}, {"max", percentile(times, 1.0)}};
}

Json cardJson(CardReport const& card) {
    Json items = Json::object();
    for (auto const& [name, value] : card.figures) items[name] = value;
    return {{"name", card.bot.substr(card.bot.find(':') + 1)}, {"finished", card.finished}, {"items", items}};
}

Json valueJson(core::SettingValue const& value) {
    return std::visit([](auto const& v) { return Json(v); }, value);
}
}  // namespace

std::string cardText(CardReport const& card) {
    std::string text = fmt::format("{}: {}\n", card.bot, card.finished ? "finished" : "not finished in the time it had");
    for (auto const& [name, value] : card.figures) text += fmt::format("{} {:.5g}\n", name, value);
    return text;
}

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    auto const rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

double residentMemory_mb() {
    std::ifstream statm{"/proc/self/statm"};
    double total = 0.0, resident = 0.0;
    statm >> total >> resident;
    return statm ? resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1.0e6 : 0.0;
}

std::string reportText(FlightReport const& report) {
    Json json{{"seconds", report.seconds},
              {"deliveries", report.deliveries},
              {"score", report.score},
              {"crashes", report.crashes},
              {"drops", Json::array()},
              {"landings", Json::array()},
              {"state_hash", report.stateHashes},
              {"frames", report.frame_ms.size()},
              {"gl_errors", report.glErrors},
              {"chunks",
               {{"made", report.chunks.made},
                {"cached", report.chunks.cached},
                {"evicted", report.chunks.evicted},
                {"peak_bytes", report.chunks.peakBytes}}},
              {"frame_ms", timesJson(report.frame_ms)},
              {"memory", {{"rss_mb", report.rss_mb}, {"gpu_mb", report.gpu_mb}}},
              {"changed", Json::object()}};
    for (delivery::Drop const& drop : report.drops) json["drops"].push_back(dropJson(drop));
    for (Landing const& landing : report.landings) json["landings"].push_back(landingJson(landing));
    for (auto const& [key, value] : report.changed) json["changed"][key] = valueJson(value);
    if (report.card) json["card"] = cardJson(*report.card);
    return json.dump(2) + "\n";
}
}  // namespace luftpost::app
