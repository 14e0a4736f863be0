#include "engine/weather/json_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"

namespace luftpost::weather {
namespace {
using Json = nlohmann::json;
constexpr int kMostDeep = 32;
constexpr std::size_t kMostValues = 4'000'000;

/// "line 3, column 14" of a byte of the text.
std::string lineAndColumn(std::string_view bytes, std::size_t byte) {
    std::string_view const before = bytes.substr(0, std::min(byte, bytes.size()));
    auto const line = 1 + std::count(before.begin(), before.end(), '\n');
    auto const newline = before.rfind('\n');
    return fmt::format("line {}, column {}", line, before.size() - (newline == before.npos ? 0 : newline + 1));
}

/// Of the UTF-8 character at the front of a text that is not empty, in bytes; 0 where there is none (other encodings, surrogates).
std::size_t characterLength(std::string_view text) {
    auto const byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return 1;
    std::size_t const length = byte(0) >= 0xC2 && byte(0) < 0xE0   ? 2
                               : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                               : byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4
                                                                   : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0u) != 0x80) return 0;
    bool const tooLong = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xF0 && byte(1) < 0x90);
    bool const beyond = (byte(0) == 0xED && byte(1) >= 0xA0) || (byte(0) == 0xF4 && byte(1) >= 0x90);
    return tooLong || beyond ? 0 : length;
}

std::string found(Json const& json) {
    if (json.is_structured()) return json.is_object() ? "an object" : "an array";
    return oneLine(json.dump(-1, ' ', true, Json::error_handler_t::replace), 40);
}

double checkedNumber(Json const& json, Unit unit, Range range, std::string const& file, std::string const& place) {
    if (!json.is_number()) throw core::Error(file, place, "expected a number, found " + found(json));
    double const given = json.get<double>(), value = given * unit.factor + unit.offset;
    if (!(value >= range.low && value <= range.high))
        throw core::Error(file, place, fmt::format("expected a number from {} to {}, found {}", (range.low - unit.offset) / unit.factor,
                                                   (range.high - unit.offset) / unit.factor, given));
    return value;
}
}  // namespace

Json parseJson(std::string_view bytes, std::string const& file, std::string const& expected) {
    auto const first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos) throw core::Error(file, "", fmt::format("expected {}, found an empty file", expected));
    if (bytes[first] != '{' && bytes[first] != '[')
        throw core::Error(file, lineAndColumn(bytes, first + 1), fmt::format("expected {}, as JSON", expected));
    std::size_t values = 0;
    auto const bounded = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > kMostDeep) throw core::Error(file, "", fmt::format("expected JSON at most {} levels deep", kMostDeep));
        if (++values > kMostValues) throw core::Error(file, "", fmt::format("expected JSON of at most {} values", kMostValues));
        return true;
    };
    try {
        return Json::parse(bytes, bounded);
    } catch (Json::parse_error const& error) {
        throw core::Error(file, lineAndColumn(bytes, error.byte), "expected well-formed JSON to the end of the file");
    } catch (Json::exception const&) {
        throw core::Error(file, "", "expected JSON whose numbers are within the range of a double");
    }
}

std::string oneLine(std::string_view text, std::size_t most) {
    std::string line;
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t const length = characterLength(text.substr(at));
        if (line.size() + std::max<std::size_t>(length, 1) > most) return line + "...";
        if (length > 1) line += text.substr(at, length);
        else line += length == 0 ? '?' : text[at] < ' ' || text[at] == 127 ? ' ' : text[at];
        at += std::max<std::size_t>(length, 1);
    }
    return line;
}

double requiredNumber(Json const& object, std::string_view key, Range range, std::string const& file, std::string const& place) {
    auto const value = optionalNumber(object, key, range, file, place);
    if (!value) throw core::Error(file, place, fmt::format("expected the key \"{}\"", key));
    return *value;
}

std::optional<double> optionalNumber(Json const& object, std::string_view key, Range range, std::string const& file, std::string const& place) {
    auto const member = object.find(key);
    if (member == object.end() || member->is_null()) return std::nullopt;
    return checkedNumber(*member, {}, range, file, place.empty() ? std::string{key} : fmt::format("{}.{}", place, key));
}

std::optional<double> Column::at(std::size_t i, std::string const& file) const {
    if (!values || (*values)[i].is_null()) return std::nullopt;
    Json const& value = (*values)[i];
    if (value.is_number()) {
        double const ours = value.get<double>() * unit.factor + unit.offset;
        if (ours >= range.low && ours <= range.high) return ours;
    }
    return checkedNumber(value, unit, range, file, fmt::format("{}[{}]", place, i));
}

bool knowsAnything(Json const& values) {
    return std::any_of(values.begin(), values.end(), [](Json const& value) { return !value.is_null(); });
}

void checkArray(Json const& values, std::size_t count, std::string const& file, std::string const& place) {
    if (!values.is_array()) throw core::Error(file, place, "expected an array, found " + found(values));
    if (values.size() != count)
        throw core::Error(file, place, fmt::format("expected {} values, as many as times, found {}", count, values.size()));
}
}  // namespace luftpost::weather
