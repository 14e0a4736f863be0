// A setting is declared once: a Field of a table names the member, the key, the range and the help. The
// config menu, the settings file, --set, --help and docs/settings.md are loops over the joined list of those
// tables.
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace luftpost::core {
/// A number, a whole number, a switch, a text or one of some words (an enum, in the order of its values from
/// 0).
///   inline constexpr std::tuple cloudFields{
///       Field{&CloudSettings::cover, "clouds.cover", 0.0f, 1.0f, "Share of the ground under cloud"},
///       Field{&CloudSettings::shadows, "clouds.shadows", "Clouds darken the ground"},
///       Field{&CloudSettings::mode, "clouds.mode", kModeWords, "How ..."}};  // std::array<std::string_view,
///       N>
template <class S, class T>
struct Field {
    using Limit = std::conditional_t<std::is_arithmetic_v<T>, T, int>;
    T S::*member;
    std::string_view key;
    Limit min{}, max{};
    std::string_view help;
    std::span<std::string_view const> words{};

    constexpr Field(T S::*m, std::string_view k, T low, T high,
                    std::string_view h) requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)
        : member{m}, key{k}, min{low}, max{high}, help{h} {}
    constexpr Field(T S::*m, std::string_view k,
                    std::string_view h) requires(std::is_same_v<T, bool> || std::is_same_v<T, std::string>)
        : member{m}, key{k}, help{h} {}
    constexpr Field(T S::*m, std::string_view k, std::span<std::string_view const> w,
                    std::string_view h) requires std::is_enum_v<T>
        : member{m}, key{k}, help{h}, words{w} {}
};

/// A switch, a number (whole ones too), or a text (also the word of an enum).
using SettingValue = std::variant<bool, double, std::string>;

/// One setting of a live object, its type erased. Valid as long as the object; not for two threads at once.
struct Setting {
    std::string_view key, help;
    double min = 0.0, max = 0.0;              // numbers only
    bool whole = false;                       // numbers only: no fraction
    std::span<std::string_view const> words;  // enums only
    std::string_view expected{};              // texts that are not free: what may stand there ...
    std::function<bool(std::string const&)> accepts{};  // ... and whether this one may
    SettingValue initial;                     // the default, as the struct declares it
    std::function<SettingValue()> get;
    std::function<void(SettingValue const&)> set;  // takes what `get` gives; the value must be in range
};
using SettingList = std::vector<Setting>;

/// 0.3f becomes 0.3, not 0.30000001192: what a file or a report shows.
double shortestDouble(float value);

namespace detail {
template <class T>
SettingValue erase(T const& value, std::span<std::string_view const> words) {
    if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>)
        return SettingValue{value};
    else if constexpr (std::is_same_v<T, float>)
        return SettingValue{shortestDouble(value)};
    else if constexpr (std::is_enum_v<T>)
        return SettingValue{std::string{words[static_cast<std::size_t>(value)]}};
    else
        return SettingValue{static_cast<double>(value)};
}
template <class T>
void restore(T& target, SettingValue const& value, std::span<std::string_view const> words) {
    if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>)
        target = std::get<T>(value);
    else if constexpr (std::is_enum_v<T>) {
        for (std::size_t i = 0; i < words.size(); ++i)
            if (words[i] == std::get<std::string>(value)) target = static_cast<T>(i);
    } else
        target = static_cast<T>(std::get<double>(value));
}
}  // namespace detail

/// Appends the settings of `object`, one for each field of its table.
template <class S, class... Fields>
void appendSettings(SettingList& list, S& object, std::tuple<Fields...> const& fields) {
    auto const append = [&]<class T>(Field<S, T> const& field) {
        static S const kInitial{};
        T* const value = &(object.*field.member);
        auto const words = field.words;
        Setting setting{.key = field.key,
                        .help = field.help,
                        .words = words,
                        .initial = detail::erase(kInitial.*field.member, words),
                        .get = [value, words] { return detail::erase(*value, words); },
                        .set = [value, words](SettingValue const& v) { detail::restore(*value, v, words); }};
        if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
            setting.min = std::get<double>(detail::erase(field.min, words));
            setting.max = std::get<double>(detail::erase(field.max, words));
            setting.whole = std::is_integral_v<T>;
        }
        list.push_back(std::move(setting));
    };
    std::apply([&](auto const&... field) { (append(field), ...); }, fields);
}

/// The setting with this key, or null.
Setting* findSetting(SettingList& list, std::string_view key);
/// The known key that looks most like `key`. The list must not be empty.
std::string_view nearestKey(SettingList const& list, std::string_view key);
/// The text of `known` (not empty) that looks most like `text`.
std::string nearestText(std::span<std::string const> known, std::string_view text);
/// "0.45", "true", "word": what a file, the menu and the report show.
std::string settingText(SettingValue const& value);
/// What may stand there: "0..1", "a whole number 1..8", "true or false", "one of a, b".
std::string expectedValue(Setting const& setting);

/// Sets from "key=value". Throws Error{source, key, ...} for an unknown key (naming the nearest) or a bad
/// value.
void assignSetting(SettingList& list, std::string_view source, std::string_view keyEqualsValue);
/// Sets a value read from elsewhere; throws as above when it has the wrong type or is out of range.
void assignSetting(Setting& setting, std::string_view source, SettingValue const& value);

/// The settings that differ from their defaults, by key.
std::map<std::string, SettingValue> changedSettings(SettingList const& list);
void resetSettings(SettingList& list);

/// Reads a TOML file strictly, as `--settings` does. Throws Error naming file, line and expectation.
void readSettings(SettingList& list, std::filesystem::path const& file);

/// What a lenient reading met; the lines are for the log, the unknown keys are written back.
struct SettingsFileNotes {
    std::vector<std::string> lines;
    std::map<std::string, std::string> unknown;  // key -> value as TOML
};
/// Reads the player's own file: out of range is clamped, unknown keys are kept and named. A file that is not
/// TOML is renamed to FILE.bad and the settings stay as they are. A missing file is no error. Never throws
/// for its content.
SettingsFileNotes readPlayerSettings(SettingList& list, std::filesystem::path const& file);
/// Writes the changed settings and the unknown keys as TOML, atomically. Throws Error when the disk refuses.
void writeSettings(SettingList const& list, SettingsFileNotes const& notes,
                   std::filesystem::path const& file);
}  // namespace luftpost::core
