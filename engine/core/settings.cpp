#include "engine/core/settings.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/file.h"

namespace luftpost::core {
namespace {
namespace fs = std::filesystem;

/// How far the text is from the known word: four times the edit distance (Levenshtein) to the start of the
/// word that fits it best, and one for each letter that the word goes on after it, so that "densty" is near
/// "densityThreshold".
std::size_t strangeness(std::string_view known, std::string_view text) {
    std::vector<std::size_t> row(known.size() + 1);  // to each start of the known word
    for (std::size_t j = 0; j <= known.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= text.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= known.size(); ++j) {
            std::size_t const substituted = diagonal + (text[i - 1] == known[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    std::size_t least = 4 * row.back();
    for (std::size_t j = 0; j < known.size(); ++j) least = std::min(least, 4 * row[j] + known.size() - j);
    return least;
}

/// What is wrong with the value, or nothing.
std::optional<std::string> complaint(Setting const& setting, SettingValue const& value) {
    std::string const wrong =
        fmt::format("expected {}, found {}", expectedValue(setting), settingText(value));
    if (value.index() != setting.initial.index()) return wrong;
    if (auto const* number = std::get_if<double>(&value)) {
        if (!std::isfinite(*number) || *number < setting.min || *number > setting.max) return wrong;
        if (setting.whole && *number != std::floor(*number)) return wrong;
    }
    if (auto const* word = std::get_if<std::string>(&value); word && !setting.words.empty())
        if (std::find(setting.words.begin(), setting.words.end(), *word) == setting.words.end()) return wrong;
    if (setting.accepts && !setting.accepts(std::get<std::string>(value))) return wrong;
    return std::nullopt;
}

/// The text read as what the setting holds; as a text when it is not that.
SettingValue valueFromText(Setting const& setting, std::string_view text) {
    if (std::holds_alternative<bool>(setting.initial)) {
        if (text == "true" || text == "on" || text == "1") return true;
        if (text == "false" || text == "off" || text == "0") return false;
    }
    if (std::holds_alternative<double>(setting.initial)) {
        double number = 0.0;
        auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc{} && end == text.data() + text.size()) return number;
    }
    return std::string{text};
}

struct Entry {
    std::string key;
    std::optional<SettingValue> value;  // none: an array or a date
    std::string text;                   // as TOML
    unsigned line = 0;
};

void flatten(toml::table const& table, std::string const& prefix, std::vector<Entry>& entries) {
    for (auto const& [name, node] : table) {
        std::string const key = prefix + std::string{name.str()};
        if (auto const* inner = node.as_table()) {
            flatten(*inner, key + ".", entries);
            continue;
        }
        Entry entry{
            .key = key, .value = {}, .text = {}, .line = static_cast<unsigned>(node.source().begin.line)};
        if (auto const* flag = node.as_boolean()) entry.value = flag->get();
        if (auto const* text = node.as_string()) entry.value = text->get();
        if (node.is_number()) entry.value = *node.value<double>();
        std::ostringstream written;
        node.visit([&](auto const& concrete) { written << concrete; });
        entry.text = written.str();
        entries.push_back(std::move(entry));
    }
}

/// Throws toml::parse_error.
std::vector<Entry> parsed(fs::path const& file) {
    std::vector<Entry> entries;
    flatten(toml::parse(readFile(file), file.string()), "", entries);
    return entries;
}

Error unknownKey(SettingList const& list, std::string_view source, std::string_view key) {
    return Error{std::string{source}, std::string{key},
                 fmt::format("no such setting; the nearest known is {}", nearestKey(list, key))};
}

std::string tomlText(SettingValue const& value) {
    std::ostringstream out;
    std::visit([&](auto const& v) { out << toml::value{v}; }, value);
    return out.str();
}

/// Clamps a number into its range; nothing when the value cannot be used at all.
std::optional<SettingValue> clamped(Setting const& setting, SettingValue const& value) {
    auto const* number = std::get_if<double>(&value);
    if (!number || !std::holds_alternative<double>(setting.initial) || std::isnan(*number))
        return std::nullopt;
    double const inside = std::clamp(*number, setting.min, setting.max);
    return setting.whole ? std::round(inside) : inside;
}

void applyLeniently(SettingList& list, Entry const& entry, fs::path const& file, SettingsFileNotes& notes) {
    std::string const place = fmt::format("{}:{}: {}", file.string(), entry.line, entry.key);
    Setting* const setting = findSetting(list, entry.key);
    if (!setting) {
        notes.lines.push_back(fmt::format("{}: no such setting (kept); the nearest known is {}", place,
                                          nearestKey(list, entry.key)));
        notes.unknown[entry.key] = entry.text;
        return;
    }
    SettingValue const value = entry.value.value_or(SettingValue{entry.text});
    if (auto const wrong = complaint(*setting, value)) {
        SettingValue const used = clamped(*setting, value).value_or(setting->initial);
        notes.lines.push_back(fmt::format("{}: {}; {} is used", place, *wrong, settingText(used)));
        setting->set(used);
    } else {
        setting->set(value);
    }
}
}  // namespace

double shortestDouble(float value) { return std::strtod(fmt::format("{}", value).c_str(), nullptr); }

Setting* findSetting(SettingList& list, std::string_view key) {
    auto const found = std::find_if(list.begin(), list.end(), [&](Setting const& s) { return s.key == key; });
    return found == list.end() ? nullptr : &*found;
}

std::string_view nearestKey(SettingList const& list, std::string_view key) {
    CHECK(!list.empty(), "no settings to look in for {}", key);
    // A key typed without its prefix ("rollFactor") is nearest to the one that ends in it.
    auto const score = [&](Setting const& setting) {
        auto const dot = setting.key.find('.');
        std::string_view const tail =
            dot == std::string_view::npos ? setting.key : setting.key.substr(dot + 1);
        return std::min(strangeness(setting.key, key), strangeness(tail, key) + 4);
    };
    return std::min_element(list.begin(), list.end(),
                            [&](Setting const& a, Setting const& b) { return score(a) < score(b); })
        ->key;
}

std::string nearestText(std::span<std::string const> known, std::string_view text) {
    CHECK(!known.empty(), "nothing to look in for {}", text);
    return *std::min_element(known.begin(), known.end(), [&](std::string const& a, std::string const& b) {
        return strangeness(a, text) < strangeness(b, text);
    });
}

std::string settingText(SettingValue const& value) {
    if (auto const* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (auto const* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    return std::get<std::string>(value);
}

std::string expectedValue(Setting const& setting) {
    if (std::holds_alternative<bool>(setting.initial)) return "true or false";
    if (std::holds_alternative<double>(setting.initial))
        return fmt::format("{} {}..{}", setting.whole ? "a whole number" : "a number", setting.min,
                           setting.max);
    if (!setting.expected.empty()) return std::string{setting.expected};
    if (setting.words.empty()) return "a text";
    return fmt::format("one of {}", fmt::join(setting.words, ", "));
}

void assignSetting(Setting& setting, std::string_view source, SettingValue const& value) {
    if (auto const wrong = complaint(setting, value))
        throw Error{std::string{source}, std::string{setting.key}, *wrong};
    setting.set(value);
}

void assignSetting(SettingList& list, std::string_view source, std::string_view keyEqualsValue) {
    auto const equals = keyEqualsValue.find('=');
    if (equals == std::string_view::npos)
        throw Error{std::string{source}, std::string{keyEqualsValue}, "expected key=value"};
    std::string_view const key = keyEqualsValue.substr(0, equals);
    Setting* const setting = findSetting(list, key);
    if (!setting) throw unknownKey(list, source, key);
    assignSetting(*setting, source, valueFromText(*setting, keyEqualsValue.substr(equals + 1)));
}

std::map<std::string, SettingValue> changedSettings(SettingList const& list) {
    std::map<std::string, SettingValue> changed;
    for (Setting const& setting : list)
        if (SettingValue value = setting.get(); value != setting.initial)
            changed.emplace(setting.key, std::move(value));
    return changed;
}

void resetSettings(SettingList& list) {
    for (Setting& setting : list) setting.set(setting.initial);
}

void readSettings(SettingList& list, fs::path const& file) {
    try {
        for (Entry const& entry : parsed(file)) {
            std::string const source = fmt::format("{}:{}", file.string(), entry.line);
            Setting* const setting = findSetting(list, entry.key);
            if (!setting) throw unknownKey(list, source, entry.key);
            assignSetting(*setting, source, entry.value.value_or(SettingValue{entry.text}));
        }
    } catch (toml::parse_error const& error) {
        throw Error{fmt::format("{}:{}", file.string(), error.source().begin.line), "",
                    fmt::format("expected TOML: {}", error.description())};
    }
}

SettingsFileNotes readPlayerSettings(SettingList& list, fs::path const& file) {
    SettingsFileNotes notes;
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return notes;
    try {
        for (Entry const& entry : parsed(file)) applyLeniently(list, entry, file, notes);
    } catch (toml::parse_error const& error) {
        fs::rename(file, file.string() + ".bad", ignored);
        notes.lines.push_back(fmt::format("{}:{}: expected TOML: {}; set aside as {}.bad", file.string(),
                                          error.source().begin.line, error.description(), file.string()));
    } catch (Error const& error) {
        notes.lines.emplace_back(error.what());
    }
    return notes;
}

void writeSettings(SettingList const& list, SettingsFileNotes const& notes, fs::path const& file) {
    std::string text = "# Luftpost's settings: what differs from the defaults (docs/settings.md)\n";
    for (auto const& [key, value] : changedSettings(list))
        text += fmt::format("{} = {}\n", key, tomlText(value));
    for (auto const& [key, value] : notes.unknown) text += fmt::format("{} = {}\n", key, value);
    writeFileAtomically(file, text);
}
}  // namespace luftpost::core
