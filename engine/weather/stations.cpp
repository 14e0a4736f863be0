#include "engine/weather/stations.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "engine/core/error.h"

namespace luftpost::weather {
namespace {
constexpr std::size_t kCells = 5;
using Cells = std::array<std::string_view, kCells>;

std::optional<double> number(std::string_view text, double most) {
    double value = 0.0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(std::abs(value) <= most)) return std::nullopt;
    return value;
}

std::optional<Cells> cellsOf(std::string_view line) {
    Cells cells;
    for (std::size_t i = 0; i < kCells; ++i) {
        std::size_t const tab = i + 1 < kCells ? line.find('\t') : line.size();
        if (tab == line.npos) return std::nullopt;
        cells[i] = line.substr(0, tab);
        line.remove_prefix(std::min(tab + 1, line.size()));
    }
    return cells;
}

std::optional<Station> stationOf(Cells const& cells) {
    auto const lat = number(cells[1], 90.0), lon = number(cells[2], 180.0), elevation = number(cells[3], 9000.0);
    if (cells[0].size() != 4 || !lat || !lon || (!elevation && !cells[3].empty())) return std::nullopt;
    return Station{*lat, *lon, elevation, std::string{cells[4]}};
}
}  // namespace

Stations Stations::parse(std::string_view text, std::string const& file) {
    Stations table;
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::size_t const end = text.find('\n');
        std::string_view const line = text.substr(0, end);
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
        if (line.empty() || line.starts_with('#')) continue;
        auto const cells = cellsOf(line);
        auto station = cells ? stationOf(*cells) : std::nullopt;
        if (!station) throw core::Error(file, fmt::format("line {}", number), "expected ICAO, latitude, longitude, elevation_m and name between tabs");
        table.stations_.insert_or_assign(std::string{(*cells)[0]}, std::move(*station));
    }
    return table;
}

Station const* Stations::find(std::string const& icao) const {
    auto const found = stations_.find(icao);
    return found == stations_.end() ? nullptr : &found->second;
}
}  // namespace luftpost::weather
