// JSON that came from elsewhere: read with its size, depth and count bounded, and taken apart into columns of numbers. Every
// function says no by core::Error, in one line that names the file and the place in it.
#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/weather/ranges.h"
#include "engine/weather/units.h"

namespace luftpost::weather {
/// The JSON of the bytes; `expected` is what they should be ("a body of Open-Meteo"). At most 32 levels deep and four million
/// values, so that no body takes more than a few hundred megabytes.
nlohmann::json parseJson(std::string_view bytes, std::string const& file, std::string const& expected);

/// A text of a provider on one line: control characters blanks, what is not UTF-8 question marks, no longer than `most` bytes.
std::string oneLine(std::string_view text, std::size_t most = 200);

/// A number of an object; throws when it is absent, no number, or out of the range.
double requiredNumber(nlohmann::json const& object, std::string_view key, Range range, std::string const& file, std::string const& place);
/// The same, but nothing when it is absent or null.
std::optional<double> optionalNumber(nlohmann::json const& object, std::string_view key, Range range, std::string const& file,
                                     std::string const& place);

/// One quantity over time as a provider gives it: an array, its unit, and where it stands.
struct Column {
    nlohmann::json const* values = nullptr;  // none: the provider does not say this
    std::string place;                       // "hourly.temperature_2m"
    Unit unit;
    Range range{0.0, 0.0};  // of the value in our unit

    explicit operator bool() const { return values != nullptr; }
    /// In our unit; nothing where it is null or the column is absent.
    std::optional<double> at(std::size_t i, std::string const& file) const;
};

/// True when any value of the array is not null.
bool knowsAnything(nlohmann::json const& values);

/// Sees to it that it is an array of `count` elements.
void checkArray(nlohmann::json const& values, std::size_t count, std::string const& file, std::string const& place);
}  // namespace luftpost::weather
