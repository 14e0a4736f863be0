#include "engine/weather/source.h"

#include <fmt/format.h>

#include <array>
#include <chrono>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/weather/grib.h"
#include "engine/weather/metar_files.h"
#include "engine/weather/meteoblue.h"
#include "engine/weather/meteoswiss.h"
#include "engine/weather/open_meteo.h"
#include "engine/weather/presets.h"

namespace luftpost::weather {
namespace {
/// One format: whether bytes look like it (cheap, never throws), and its reader.
struct Format {
    std::string_view name;
    bool (*looksLike)(std::string_view bytes);
    Recording (*parse)(std::string_view bytes, std::string const& file, SourceContext const& context);
};

constexpr std::size_t kMostBytes = 64u << 20;  // no weather is larger

bool looksLikeJson(std::string_view bytes) {
    auto const first = bytes.find_first_not_of(" \t\r\n");
    return first != bytes.npos && (bytes[first] == '{' || bytes[first] == '[');
}

/// In this order; the last takes all JSON that no other claims, and says what is wrong with it.
constexpr std::array kFormats{
    Format{"GRIB 2", looksLikeGrib,
           [](std::string_view bytes, std::string const& file, SourceContext const& context) { return parseGrib(bytes, file, context.place); }},
    Format{"MeteoSwiss (10 minutes, observer or sounding, CSV)", looksLikeMeteoSwiss,
           [](std::string_view bytes, std::string const& file, SourceContext const&) { return parseMeteoSwiss(bytes, file); }},
    Format{"meteoblue (JSON)", looksLikeMeteoblue,
           [](std::string_view bytes, std::string const& file, SourceContext const&) { return parseMeteoblue(bytes, file); }},
    Format{"Open-Meteo (JSON)", looksLikeOpenMeteo,
           [](std::string_view bytes, std::string const& file, SourceContext const&) { return parseOpenMeteo(bytes, file); }},
    Format{"METAR as JSON of aviationweather.gov", looksLikeMetarJson, parseMetarJson},
    Format{"METAR in a table", looksLikeMetarTable, parseMetarTable},
    Format{"METAR as text", looksLikeMetarText, parseMetarText},
    Format{"a recording (luftpost-weather-1)", looksLikeJson,
           [](std::string_view bytes, std::string const& file, SourceContext const&) { return parseRecording(bytes, file); }},
};
}  // namespace

SourceContext contextOfNow() {
    return {.latest = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count()};
}

Recording parseSource(std::string_view bytes, std::string const& file, SourceContext const& context) {
    if (bytes.size() > kMostBytes)
        throw core::Error(file, "", fmt::format("expected at most {} MiB, found {}", kMostBytes >> 20, bytes.size() >> 20));
    for (Format const& format : kFormats)
        if (format.looksLike(bytes)) return format.parse(bytes, file, context);
    std::string names;
    for (Format const& format : kFormats) names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
    throw core::Error(file, "", fmt::format("expected weather in one of the formats: {}", names));
}

Recording readWeather(std::string const& source, std::optional<PlaceWish> const& place, SourceContext const& context) {
    if (source == "live")
        throw core::Error("live", "", "live weather is not available in this version; expected recorded:FILE or preset:NAME");
    if (source.starts_with("preset:")) {
        auto recording = presetRecording(std::string_view{source}.substr(7), place);
        if (recording) return std::move(*recording);
        std::string names;
        for (PresetName const& preset : presetNames()) names += fmt::format("{}{}", names.empty() ? "" : ", ", preset.name);
        throw core::Error(source, "", fmt::format("expected one of the presets {}", names));
    }
    std::string const file = source.starts_with("recorded:") ? source.substr(9) : source;
    if (file.empty()) throw core::Error(source, "", "expected recorded:FILE, a file, or preset:NAME");
    SourceContext wished = context;
    if (place) wished.place = place;
    return parseSource(core::readFile(file, kMostBytes), file, wished);
}

Field loadWeather(std::string const& source, std::optional<PlaceWish> const& place, SourceContext const& context) {
    Recording recording = readWeather(source, place, context);
    SourceMode const mode = source.starts_with("preset:") ? SourceMode::Preset : SourceMode::Recorded;
    Origin origin{mode, recording.name, recording.source, recording.licence, recording.sha256};
    return fieldFrom(std::move(recording), std::move(origin), place);
}
}  // namespace luftpost::weather
