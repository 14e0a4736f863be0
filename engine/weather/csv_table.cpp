#include "engine/weather/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "engine/core/error.h"
#include "engine/weather/json_body.h"

namespace luftpost::weather {
namespace {
constexpr std::size_t kMostRows = 100'000, kMostColumns = 200;

/// The line at the front of `rest`, which loses it; ends of lines of any kind.
std::string_view takeLine(std::string_view& rest) {
    std::size_t const end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest = end == rest.npos ? std::string_view{} : rest.substr(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    for (std::size_t start = 0; start <= line.size() && cells.size() <= kMostColumns;) {
        std::size_t const end = std::min(line.find(separator, start), line.size());
        cells.push_back(line.substr(start, end - start));
        start = end + 1;
    }
    return cells;
}
}  // namespace

CsvTable::CsvTable(std::string_view bytes, char separator, std::size_t heading, std::string const& file) : file_{file} {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    for (std::size_t line = 0; !bytes.empty(); ++line) {
        std::string_view const text = takeLine(bytes);
        if (line < heading || text.empty()) continue;
        auto cells = cellsOf(text, separator);
        if (columns_.empty()) {
            if (cells.size() > kMostColumns)
                throw core::Error(file, fmt::format("line {}", line + 1), fmt::format("expected at most {} columns", kMostColumns));
            for (std::size_t i = 0; i < cells.size(); ++i) columns_.emplace(cells[i], i);
            continue;
        }
        if (cells.size() > columns_.size())
            throw core::Error(file, fmt::format("line {}", line + 1), fmt::format("expected {} cells, found {}", columns_.size(), cells.size()));
        if (rows_.size() == kMostRows) throw core::Error(file, fmt::format("line {}", line + 1), fmt::format("expected at most {} rows", kMostRows));
        rows_.push_back({line + 1, std::move(cells)});
    }
}

std::string_view CsvTable::text(std::size_t row, std::string_view column) const {
    auto const found = columns_.find(column);
    auto const& cells = rows_[row].cells;
    return found == columns_.end() || found->second >= cells.size() ? std::string_view{} : cells[found->second];
}

std::optional<double> CsvTable::number(std::size_t row, std::string_view column, Range range) const {
    std::string_view const cell = text(row, column);
    if (cell.empty() || cell == "-") return std::nullopt;
    double value = 0.0;
    auto const [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size() || !(value >= range.low && value <= range.high))
        throw core::Error(file_, place(row, column),
                          fmt::format("expected a number from {} to {}, found \"{}\"", range.low, range.high, oneLine(cell, 40)));
    return value;
}

std::string CsvTable::place(std::size_t row, std::string_view column) const { return fmt::format("line {}, column {}", rows_[row].line, column); }

std::string_view firstLine(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    return takeLine(bytes);
}
}  // namespace luftpost::weather
