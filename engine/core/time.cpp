#include "engine/core/time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace luftpost::core {
namespace {
/// Days from 1970-01-01 of a date of the Gregorian calendar, and back: H. Hinnant, "chrono-compatible low-level date
/// algorithms" (the year starts on 1 March, so that the leap day is its last).
long long daysFromDate(long long year, int month, int day) {
    year -= month <= 2;
    long long const era = (year >= 0 ? year : year - 399) / 400;
    long long const yearOfEra = year - era * 400;
    long long const dayOfYear = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
    return era * 146097 + yearOfEra * 365 + yearOfEra / 4 - yearOfEra / 100 + dayOfYear - 719468;
}

struct Date {
    long long year;
    int month, day;
};

Date dateFromDays(long long days) {
    days += 719468;
    long long const era = (days >= 0 ? days : days - 146096) / 146097;
    long long const dayOfEra = days - era * 146097;
    long long const yearOfEra = (dayOfEra - dayOfEra / 1460 + dayOfEra / 36524 - dayOfEra / 146096) / 365;
    long long const dayOfYear = dayOfEra - (365 * yearOfEra + yearOfEra / 4 - yearOfEra / 100);
    long long const shifted = (5 * dayOfYear + 2) / 153;
    int const month = static_cast<int>(shifted < 10 ? shifted + 3 : shifted - 9);
    return {yearOfEra + era * 400 + (month <= 2), month, static_cast<int>(dayOfYear - (153 * shifted + 2) / 5 + 1)};
}

/// The `count` digits at the front of `text`, which loses them; nothing if there are fewer.
std::optional<int> takeDigits(std::string_view& text, std::size_t count) {
    if (text.size() < count) return std::nullopt;
    int value = 0;
    for (char const c : text.substr(0, count)) {
        if (c < '0' || c > '9') return std::nullopt;
        value = value * 10 + (c - '0');
    }
    text.remove_prefix(count);
    return value;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

/// ":SS" or ":SS.fff", both optional.
std::optional<double> takeSeconds(std::string_view& text) {
    if (!take(text, ':')) return 0.0;
    auto const whole = takeDigits(text, 2);
    if (!whole || *whole > 59) return std::nullopt;
    double seconds = *whole;
    if (!take(text, '.')) return seconds;
    double place = 0.1;
    std::size_t digits = 0;
    for (; !text.empty() && text.front() >= '0' && text.front() <= '9' && digits < 9; ++digits, place *= 0.1) {
        seconds += place * (text.front() - '0');
        text.remove_prefix(1);
    }
    if (digits == 0) return std::nullopt;
    return seconds;
}
}  // namespace

std::optional<UtcSeconds> parseUtc(std::string_view text) {
    auto const year = takeDigits(text, 4);
    if (!year || !take(text, '-')) return std::nullopt;
    auto const month = takeDigits(text, 2);
    if (!month || !take(text, '-')) return std::nullopt;
    auto const day = takeDigits(text, 2);
    if (!day || !take(text, 'T')) return std::nullopt;
    auto const hour = takeDigits(text, 2);
    if (!hour || *hour > 23 || !take(text, ':')) return std::nullopt;
    auto const minute = takeDigits(text, 2);
    if (!minute || *minute > 59) return std::nullopt;
    auto const second = takeSeconds(text);
    if (!second || !take(text, 'Z') || !text.empty()) return std::nullopt;
    if (*month < 1 || *month > 12 || *day < 1) return std::nullopt;
    long long const days = daysFromDate(*year, *month, *day);
    if (dateFromDays(days).month != *month || dateFromDays(days).day != *day) return std::nullopt;
    return static_cast<double>(days * 86400 + *hour * 3600 + *minute * 60) + *second;
}

std::string formatUtc(UtcSeconds time) {
    double const first = static_cast<double>(daysFromDate(0, 1, 1)) * 86400.0;
    double const last = static_cast<double>(daysFromDate(10000, 1, 1)) * 86400.0 - 1.0;
    auto const whole = static_cast<long long>(std::floor(std::clamp(time, first, last) + 0.5));
    long long days = whole / 86400;
    long long rest = whole % 86400;
    if (rest < 0) {
        rest += 86400;
        --days;
    }
    auto const date = dateFromDays(days);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", date.year, date.month, date.day, rest / 3600,
                       rest / 60 % 60, rest % 60);
}
}  // namespace luftpost::core
