#include "game/app/feed_cache.h"

#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/weather/recording.h"

namespace luftpost::app {
namespace {
using Json = nlohmann::json;
namespace fs = std::filesystem;
constexpr char const* kFormat = "luftpost-weather-cache-1";
constexpr std::uintmax_t kMostBytes = 16u << 20;

double numberOf(Json const& json, char const* key, double min, double max) {
    auto const found = json.find(key);
    if (found == json.end() || !found->is_number() || !(found->get<double>() >= min && found->get<double>() <= max))
        throw core::Error("", key, fmt::format("expected a number {}..{}", min, max));
    return found->get<double>();
}

std::string textOf(Json const& json, char const* key) {
    auto const found = json.find(key);
    if (found == json.end() || !found->is_string()) throw core::Error("", key, "expected a text");
    return found->get<std::string>();
}

KeptNews parsed(fs::path const& file) {
    if (fs::file_size(file) > kMostBytes) throw core::Error("", "", "expected a smaller file");
    Json const json = Json::parse(core::readFile(file), nullptr, false);
    if (!json.is_object() || json.value("format", Json{}) != kFormat) throw core::Error("", "format", fmt::format("expected {}", kFormat));
    KeptNews kept;
    kept.news.recording = textOf(json, "recording");
    kept.news.place = {numberOf(json, "lat", -90.0, 90.0), numberOf(json, "lon", -180.0, 180.0)};
    kept.asked = numberOf(json, "asked_utc", 0.0, 1.0e11);
    if (weather::sha256Hex(kept.news.recording) != textOf(json, "sha256")) throw core::Error("", "sha256", "expected the checksum of its recording");
    weather::Recording const recording = weather::parseRecording(kept.news.recording, file.string());
    kept.news.lastReport = lastReport(recording);
    return kept;
}
}  // namespace

std::optional<KeptNews> readKept(fs::path const& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::nullopt;
    try {
        return parsed(file);
    } catch (std::exception const& error) {
        std::string_view what = error.what();
        if (what.starts_with(": ")) what.remove_prefix(2);  // the file is named in front
        spdlog::warn("{}: {}; the kept weather is dropped", file.string(), what);
        fs::remove(file, ignored);
        return std::nullopt;
    }
}

void writeKept(fs::path const& file, KeptNews const& kept) {
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    Json const json{{"format", kFormat},          {"asked_utc", kept.asked},
                    {"lat", kept.news.place.lat_deg}, {"lon", kept.news.place.lon_deg},
                    {"sha256", weather::sha256Hex(kept.news.recording)}, {"recording", kept.news.recording}};
    try {
        core::writeFileAtomically(file, json.dump() + "\n");
    } catch (std::exception const& error) {
        spdlog::warn("the weather is not kept: {}", error.what());
    }
}
}  // namespace luftpost::app
