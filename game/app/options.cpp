#include "game/app/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <thread>

#include "engine/core/error.h"
#include "engine/core/time.h"

namespace luftpost::app {
namespace {
[[noreturn]] void refuse(std::string_view option, std::string_view expected, std::string_view text) {
    throw core::Error{std::string{option}, "",
                      fmt::format("expected {}, found {}", expected, text.empty() ? "nothing" : text)};
}

template <class T>
std::optional<T> parsed(std::string_view text) {
    T value{};
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}
}  // namespace

double numberOption(std::string_view option, std::string_view text, double min, double max) {
    auto const value = parsed<double>(text);
    if (!value || !(*value >= min && *value <= max))
        refuse(option, fmt::format("a number {}..{}", min, max), text);
    return *value;
}

long long wholeOption(std::string_view option, std::string_view text, long long min, long long max) {
    auto const value = parsed<long long>(text);
    if (!value || *value < min || *value > max)
        refuse(option, fmt::format("a whole number {}..{}", min, max), text);
    return *value;
}

std::vector<double> numbersOption(std::string_view option, std::string_view text, std::size_t minCount,
                                  std::size_t maxCount, std::string_view form) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        std::size_t const comma = std::min(text.find(',', begin), text.size());
        auto const value = parsed<double>(text.substr(begin, comma - begin));
        if (!value || !std::isfinite(*value)) refuse(option, form, text);
        numbers.push_back(*value);
        begin = comma + 1;
    }
    if (numbers.size() < minCount || numbers.size() > maxCount) refuse(option, form, text);
    return numbers;
}

glm::ivec2 sizeOption(std::string_view option, std::string_view text) {
    auto const cross = text.find('x');
    if (cross != std::string_view::npos) {
        auto const width = parsed<int>(text.substr(0, cross)), height = parsed<int>(text.substr(cross + 1));
        auto const valid = [](std::optional<int> side) { return side && *side >= 1 && *side <= 16384; };
        if (valid(width) && valid(height)) return {*width, *height};
    }
    refuse(option, "WIDTHxHEIGHT, each 1..16384", text);
}

core::UtcSeconds timeOption(std::string_view option, std::string_view text) {
    auto const time = core::parseUtc(text);
    if (!time) refuse(option, "a time like 2021-06-28T16:00Z", text);
    return *time;
}

PlaceOption placeOption(std::string_view option, std::string_view text) {
    auto const numbers = numbersOption(option, text, 2, 3, "LAT,LON or LAT,LON,ALT_M");
    if (std::abs(numbers[0]) > 90.0) refuse(option, "a latitude -90..90", text);
    if (std::abs(numbers[1]) > 180.0) refuse(option, "a longitude -180..180", text);
    PlaceOption place{numbers[0], numbers[1], {}};
    if (numbers.size() == 3) place.altitude_m = numbers[2];
    if (place.altitude_m && !(*place.altitude_m >= -500.0 && *place.altitude_m <= 20000.0))
        refuse(option, "an altitude -500..20000 m", text);
    return place;
}

int toolWorkers() { return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 32u)); }
}  // namespace luftpost::app
