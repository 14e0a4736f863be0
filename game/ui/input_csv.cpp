#include "game/ui/input_csv.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/frames.h"

namespace luftpost::ui {
namespace {
constexpr std::string_view kHeader = "t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop";
constexpr std::array<std::string_view, 8> kColumns{"t_s",    "throttle", "elevator", "aileron",
                                                   "rudder", "flaps",    "brakes",   "drop"};
constexpr double kLongest = 1.0e6;  // s

struct Row {
    std::string_view name;
    int line = 0;

    [[noreturn]] void refuse(std::string_view column, std::string_view expected,
                             std::string_view found) const {
        throw core::Error{fmt::format("{}:{}", name, line), std::string{column},
                          fmt::format("expected {}, found {}", expected, found.empty() ? "nothing" : found)};
    }
    double number(std::size_t column, std::string_view cell, double min, double max) const {
        double value = 0.0;
        auto const [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc{} || end != cell.data() + cell.size() || !(value >= min && value <= max))
            refuse(kColumns[column], fmt::format("a number {}..{}", min, max), cell);
        return value;
    }
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.back() == ' ' || text.back() == '\r' || text.back() == '\t'))
        text.remove_suffix(1);
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    return text;
}

std::array<std::string_view, 8> cellsOf(std::string_view text, Row const& row) {
    std::array<std::string_view, 8> cells;
    std::size_t count = 0;
    for (std::size_t begin = 0; begin <= text.size(); ++count) {
        std::size_t const comma = std::min(text.find(',', begin), text.size());
        if (count < cells.size()) cells[count] = trimmed(text.substr(begin, comma - begin));
        begin = comma + 1;
    }
    if (count != cells.size()) row.refuse("", "8 columns", fmt::format("{}", count));
    return cells;
}

/// Applies the row's cells; the empty ones leave what is there.
void apply(Row const& row, std::array<std::string_view, 8> const& cells, InputSample& sample) {
    DirectStick& stick = *sample.direct;
    auto const set = [&](std::size_t column, auto& value, double min) {
        if (!cells[column].empty()) value = row.number(column, cells[column], min, 1.0);
    };
    set(1, stick.throttle, 0.0);
    set(2, stick.elevator, -1.0);
    set(3, stick.aileron, -1.0);
    set(4, stick.rudder, -1.0);
    set(5, stick.flaps, 0.0);
    set(6, stick.brakes, 0.0);
    if (!cells[7].empty()) sample.hold(FlightKey::drop, row.number(7, cells[7], 0.0, 1.0) >= 0.5);
}
}  // namespace

long long tickAtOrAfter(double t) {
    // A decimal time such as 0.1 names the tick it means: what is over a whole tick by rounding alone is that
    // tick.
    double const ticks = t * core::kTicksPerSecond;
    double const nearest = std::round(ticks);
    return static_cast<long long>(std::abs(ticks - nearest) < 1.0e-6 ? nearest : std::ceil(ticks));
}

std::vector<StampedSample> parseInputCsv(std::string_view text, std::string_view name) {
    std::vector<StampedSample> samples;
    InputSample sample;
    sample.direct.emplace();
    Row row{name, 0};
    double before = 0.0;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t const end = std::min(text.find('\n', begin), text.size());
        std::string_view const line = trimmed(text.substr(begin, end - begin));
        begin = end + 1;
        ++row.line;
        if (row.line == 1 && line != kHeader) row.refuse("header", kHeader, line);
        if (row.line == 1 || line.empty()) continue;
        auto const cells = cellsOf(line, row);
        double const t = row.number(0, cells[0], 0.0, kLongest);
        if (t < before) row.refuse("t_s", fmt::format("a time not before {}", before), cells[0]);
        before = t;
        apply(row, cells, sample);
        samples.push_back({tickAtOrAfter(t), sample});
    }
    if (row.line == 0) Row{name, 1}.refuse("header", kHeader, "");
    return samples;
}

std::vector<StampedSample> readInputCsv(std::filesystem::path const& file) {
    return parseInputCsv(core::readFile(file), file.string());
}
}  // namespace luftpost::ui
