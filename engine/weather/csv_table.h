// A table of separated values: lines, cells by the column's name, numbers with a place for the message.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/weather/ranges.h"

namespace luftpost::weather {
/// Views into the bytes, which must outlive it. No quotes: the files that are read this way have none in what is read.
class CsvTable {
public:
    /// Line `heading` (from 0) names the columns; empty lines are left out. Throws core::Error for a row of more cells than columns and
    /// for more than 100,000 rows.
    CsvTable(std::string_view bytes, char separator, std::size_t heading, std::string const& file);

    std::size_t rows() const { return rows_.size(); }
    bool has(std::string_view column) const { return columns_.contains(column); }
    /// Empty where the row is too short or the column is not there.
    std::string_view text(std::size_t row, std::string_view column) const;
    /// Nothing for an empty cell, "-" and a column that is not there. Throws core::Error for what is no number or out of the range.
    std::optional<double> number(std::size_t row, std::string_view column, Range range) const;
    /// "line 17, column tre200s0"
    std::string place(std::size_t row, std::string_view column) const;
    std::string const& file() const { return file_; }

private:
    struct Row {
        std::size_t line;
        std::vector<std::string_view> cells;
    };
    std::string const& file_;
    std::map<std::string_view, std::size_t, std::less<>> columns_;
    std::vector<Row> rows_;
};

/// The first line of the bytes, without its end.
std::string_view firstLine(std::string_view bytes);
}  // namespace luftpost::weather
