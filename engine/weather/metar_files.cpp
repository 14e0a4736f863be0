#include "engine/weather/metar_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/time.h"
#include "engine/weather/json_body.h"
#include "engine/weather/metar_gather.h"
#include "engine/weather/metar_scan.h"

namespace luftpost::weather {
namespace {
using Json = nlohmann::json;
constexpr std::size_t kLookedAt = 65536;  // bytes that tell the shape

/// The next line without its end, and where it begins.
struct Line {
    std::string_view text;
    std::size_t offset = 0, number = 0;
};

class Lines {
public:
    explicit Lines(std::string_view bytes) : bytes_{bytes} {}
    bool next(Line& line) {
        if (at_ >= bytes_.size()) return false;
        std::size_t const end = std::min(bytes_.find('\n', at_), bytes_.size());
        line = {bytes_.substr(at_, end - at_), at_, ++number_};
        if (line.text.ends_with('\r')) line.text.remove_suffix(1);
        at_ = end + 1;
        return true;
    }

private:
    std::string_view bytes_;
    std::size_t at_ = 0, number_ = 0;
};

std::string_view trimmed(std::string_view text) {
    auto const from = text.find_first_not_of(" \t\r\n");
    if (from == text.npos) return {};
    return text.substr(from, text.find_last_not_of(" \t\r\n") + 1 - from);
}

/// "2024/03/01 00:50" or "2024-03-01 00:52" at the front of the text, which loses it.
std::optional<core::UtcSeconds> takeDate(std::string_view& text) {
    MetarScan scan{text};
    auto const year = scan.exactly(4);
    auto const mark = year ? scan.takeOneOf({"/", "-"}) : std::nullopt;
    auto const month = mark ? scan.exactly(2) : std::nullopt;
    auto const day = month && scan.take(*mark == 0 ? "/" : "-") ? scan.exactly(2) : std::nullopt;
    auto const hour = day && scan.takeOneOf({" ", "T"}) ? scan.exactly(2) : std::nullopt;
    auto const minute = hour && scan.take(":") ? scan.exactly(2) : std::nullopt;
    if (!minute) return std::nullopt;
    auto const time = core::parseUtc(fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}Z", *year, *month, *day, *hour, *minute));
    if (time) text = scan.rest();
    return time;
}

/// A bulletin's heading ("SASW31 LSSW 010050"), or a line of type words alone: no report begins there.
bool isHeading(std::string_view line) {
    if (line == "METAR" || line == "SPECI") return true;
    if (line.size() < 18 || line.size() > 22 || line[6] != ' ' || line[11] != ' ') return false;
    auto const all = [line](std::size_t from, std::size_t count, char low, char high) {
        std::string_view const part = line.substr(from, count);
        return std::all_of(part.begin(), part.end(), [=](char c) { return c >= low && c <= high; });
    };
    return all(0, 4, 'A', 'Z') && all(4, 2, '0', '9') && all(7, 4, 'A', 'Z') && all(12, 6, '0', '9') && (line.size() == 18 || line[18] == ' ');
}

/// Cuts raw text into reports.
class TextReader {
public:
    TextReader(std::string_view bytes, MetarGathering& gathering)
        : bytes_{bytes}, gathering_{gathering}, equalSigns_{bytes.find("=\n") != bytes.npos || bytes.find("=\r") != bytes.npos || trimmed(bytes).ends_with('=')} {}

    void read() {
        Lines lines{bytes_};
        for (Line line; lines.next(line);) take(line.text, line.offset, line.number);
        close();
    }

private:
    void take(std::string_view text, std::size_t offset, std::size_t number) {
        std::string_view const inner = trimmed(text);
        if (inner.empty()) return close();
        if (inner.starts_with('#')) return;
        std::string_view rest = inner;
        if (auto const date = takeDate(rest)) {
            close();
            around_ = date;
            if (trimmed(rest).empty()) return;
        }
        if (isHeading(trimmed(rest))) return close();
        auto const lead = static_cast<std::size_t>(rest.data() - text.data());
        cut(rest, offset + lead, number, lead + 1);
    }

    /// A line's worth of text that belongs to one report or, with "=" inside, to several.
    void cut(std::string_view text, std::size_t offset, std::size_t number, std::size_t column) {
        while (!trimmed(text).empty()) {
            auto const lead = text.find_first_not_of(" \t\r");
            std::size_t const end = std::min(text.find('=', lead), text.size());
            bool const indented = offset + lead > 0 && column + lead > 1 && (bytes_[offset + lead - 1] == ' ' || bytes_[offset + lead - 1] == '\t');
            std::string_view const part = text.substr(lead, end - lead);
            bool const goesOn = open_ && !looksLikeMetar(part) && (indented || equalSigns_);
            if (!goesOn) {
                close();
                begin_ = offset + lead;
                place_ = {{}, number, column + lead};
                open_ = true;
            }
            end_ = offset + end;
            if (end == text.size()) return;
            close();
            text.remove_prefix(end + 1);
            offset += end + 1;
            column += end + 1;
        }
    }

    void close() {
        if (open_ && end_ > begin_) gathering_.add(trimmed(bytes_.substr(begin_, end_ - begin_)), place_, {around_, std::nullopt});
        open_ = false;
    }

    std::string_view bytes_;
    MetarGathering& gathering_;
    bool equalSigns_;
    std::optional<core::UtcSeconds> around_;
    MetarPlace place_;
    std::size_t begin_ = 0, end_ = 0;
    bool open_ = false;
};

std::vector<std::string_view> cellsOf(std::string_view line, char mark) {
    std::vector<std::string_view> cells;
    for (std::size_t from = 0; from <= line.size() && cells.size() < 64;) {
        bool const quoted = from < line.size() && line[from] == '"';
        std::size_t const close = quoted ? line.find('"', from + 1) : line.npos;
        std::size_t const end = std::min(line.find(mark, close == line.npos ? from : close), line.size());
        std::string_view cell = line.substr(from, end - from);
        if (close != line.npos && cell.size() >= 2) cell = line.substr(from + 1, close - from - 1);
        cells.push_back(cell);
        from = end + 1;
    }
    return cells;
}

/// The header of a table of reports: what stands between its cells, and which cells they are.
struct TableHeader {
    char mark = '\t';
    std::size_t metar = 0;
    std::optional<std::size_t> valid;
};

std::optional<TableHeader> headerOf(std::string_view line) {
    for (char const mark : {'\t', ','}) {
        auto const cells = cellsOf(line, mark);
        auto const find = [&cells](std::string_view name) -> std::optional<std::size_t> {
            auto const found = std::find_if(cells.begin(), cells.end(), [name](std::string_view cell) { return trimmed(cell) == name; });
            return found == cells.end() ? std::nullopt : std::optional{static_cast<std::size_t>(found - cells.begin())};
        };
        auto const metar = find("metar");
        if (metar && cells.size() > 1) return TableHeader{mark, *metar, find("valid")};
    }
    return std::nullopt;
}

bool isComment(std::string_view line) { return trimmed(line).empty() || trimmed(line).starts_with('#'); }

/// The number that an entry has under a key, if it is one within the bounds.
std::optional<double> numberOf(Json const& entry, char const* key, double least, double most) {
    auto const found = entry.find(key);
    if (found == entry.end() || !found->is_number()) return std::nullopt;
    double const value = found->get<double>();
    return value >= least && value <= most ? std::optional{value} : std::nullopt;
}

MetarHints hintsOf(Json const& entry) {
    MetarHints hints;
    hints.around = numberOf(entry, "obsTime", 0.0, 4e9);
    auto const lat = numberOf(entry, "lat", -90.0, 90.0), lon = numberOf(entry, "lon", -180.0, 180.0);
    if (lat && lon) hints.station = Station{*lat, *lon, numberOf(entry, "elev", -500.0, 9000.0), {}};
    return hints;
}
}  // namespace

bool looksLikeMetarText(std::string_view bytes) {
    Lines lines{bytes.substr(0, kLookedAt)};
    for (Line line; lines.next(line);) {
        std::string_view text = trimmed(line.text);
        takeDate(text);
        if (looksLikeMetar(text)) return true;
    }
    return false;
}

Recording parseMetarText(std::string_view bytes, std::string const& file, SourceContext const& context) {
    MetarGathering gathering{file, context};
    TextReader{bytes, gathering}.read();
    return gathering.finish(bytes, "METAR");
}

bool looksLikeMetarTable(std::string_view bytes) {
    Lines lines{bytes.substr(0, kLookedAt)};
    for (Line line; lines.next(line);)
        if (!isComment(line.text)) return headerOf(line.text).has_value();
    return false;
}

Recording parseMetarTable(std::string_view bytes, std::string const& file, SourceContext const& context) {
    MetarGathering gathering{file, context};
    std::optional<TableHeader> header;
    Lines lines{bytes};
    for (Line line; lines.next(line);) {
        if (isComment(line.text)) continue;
        if (!header) {
            header = headerOf(line.text);
            continue;
        }
        auto const cells = cellsOf(line.text, header->mark);
        if (header->metar >= cells.size()) {
            gathering.note({{}, line.number, 1}, "has no cell for the report");
            continue;
        }
        MetarHints hints;
        if (header->valid && *header->valid < cells.size()) {
            std::string_view valid = trimmed(cells[*header->valid]);
            hints.around = takeDate(valid);
        }
        std::string_view const cell = trimmed(cells[header->metar]);
        if (cell.empty()) gathering.note({{}, line.number, 1}, "has no report");
        else gathering.add(cell, {{}, line.number, static_cast<std::size_t>(cell.data() - line.text.data()) + 1}, hints);
    }
    return gathering.finish(bytes, "METAR, Iowa Environmental Mesonet");
}

bool looksLikeMetarJson(std::string_view bytes) {
    auto const first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos || (bytes[first] != '[' && bytes[first] != '{')) return false;
    return bytes.substr(0, kLookedAt).find("\"rawOb\"") != bytes.npos;
}

Recording parseMetarJson(std::string_view bytes, std::string const& file, SourceContext const& context) {
    Json const parsed = parseJson(bytes, file, "METAR as JSON of aviationweather.gov");
    Json const list = parsed.is_array() ? parsed : Json::array({parsed});
    MetarGathering gathering{file, context};
    for (std::size_t i = 0; i < list.size(); ++i) {
        Json const& entry = list[i];
        auto const raw = entry.is_object() ? entry.find("rawOb") : entry.end();
        if (!entry.is_object() || raw == entry.end() || !raw->is_string()) {
            gathering.note({fmt::format("[{}]", i), 1, 1}, "has no text \"rawOb\"");
            continue;
        }
        gathering.add(raw->get_ref<std::string const&>(), {fmt::format("[{}].rawOb", i), 1, 1}, hintsOf(entry));
    }
    return gathering.finish(bytes, "METAR, aviationweather.gov (NOAA)");
}
}  // namespace luftpost::weather
