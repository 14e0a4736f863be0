#include "engine/weather/meteoswiss.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/csv_table.h"
#include "engine/weather/json_body.h"
#include "engine/weather/report_parts.h"

namespace luftpost::weather {
namespace {
constexpr double kTenMinutes = 600.0;
constexpr Range kPercent{0.0, 120.0}, kKilometresAnHour{0.0, 540.0}, kMillimetres{0.0, 300.0}, kCentimetres{0.0, 5000.0},
    kStationPressure{300.0, 1100.0};

/// MeteoSwiss' list of stations (ogd-smn_meta_stations.csv): coordinates and height of the station.
constexpr std::array kStations{
    SwissStation{"BAS", "06601", "Basel / Binningen", 47.5411, 7.5836, 316.0},
    SwissStation{"BER", "06631", "Bern / Zollikofen", 46.9908, 7.4640, 553.0},
    SwissStation{"GVE", "06700", "Genève / Cointrin", 46.2475, 6.1275, 411.0},
    SwissStation{"PAY", "06610", "Payerne", 46.8117, 6.9425, 490.0},
    SwissStation{"SMA", "06660", "Zürich / Fluntern", 47.3782, 8.5659, 556.0},
};

/// The first of the names that is a column; empty when none is.
std::string_view columnAmong(CsvTable const& table, std::initializer_list<std::string_view> names) {
    for (std::string_view const name : names)
        if (table.has(name)) return name;
    return {};
}

bool anyIn(CsvTable const& table, std::vector<std::size_t> const& rows, std::string_view column) {
    return std::any_of(rows.begin(), rows.end(), [&](std::size_t row) { return !table.text(row, column).empty() && table.text(row, column) != "-"; });
}

/// The first of the names whose column the rows fill.
std::string_view filledAmong(CsvTable const& table, std::vector<std::size_t> const& rows, std::initializer_list<std::string_view> names) {
    for (std::string_view const name : names)
        if (table.has(name) && anyIn(table, rows, name)) return name;
    return {};
}

/// One station's rows, and which of several columns of the same quantity it fills.
struct Station {
    CsvTable const& table;
    std::string_view timeColumn;
    std::vector<std::size_t> const& rows;
    std::optional<double> elevation;
    std::string_view speed = filledAmong(table, rows, {"fkl010z0", "fu3010z0", "fve010z0"});
    std::string_view gust = filledAmong(table, rows, {"fkl010z3", "fu3010z3", "fkl010z1", "fu3010z1"});
    std::string_view pressure = filledAmong(table, rows, {"pp0qffs0", "pp0qnhs0"});
};

/// A wind in m/s from a column in m/s or, by its name, km/h.
std::optional<double> speedAt(Station const& station, std::size_t row, std::string_view column) {
    if (!column.starts_with("fu3")) return station.table.number(row, column, kSpeed);
    auto const speed = station.table.number(row, column, kKilometresAnHour);
    return speed ? std::optional{*speed / 3.6} : std::nullopt;
}

void addPressure(Station const& station, std::size_t row, Report& report) {
    CsvTable const& table = station.table;
    if (!station.pressure.empty()) {
        report.pressure_hpa = table.number(row, station.pressure, kPressure);
        return;
    }
    auto const own = table.number(row, "prestas0", kStationPressure);
    if (own && station.elevation) fillSeaPressure(report, *own, *station.elevation, table.file(), table.place(row, "prestas0"));
}

Report reportOf(Station const& station, std::size_t row, core::UtcSeconds time) {
    CsvTable const& table = station.table;
    Report report;
    report.time = time;
    setWind(speedAt(station, row, station.speed), table.number(row, "dkl010z0", kDegrees), report.speed_mps, report.from_deg);
    report.gust_mps = speedAt(station, row, station.gust);
    report.temperature_c = table.number(row, "tre200s0", kTemperature);
    report.dew_point_c = table.number(row, "tde200s0", kDewPoint);
    if (auto const humidity = table.number(row, "ure200s0", kPercent); humidity && !report.dew_point_c)
        report.dew_point_c = dewPoint_c(report.temperature_c, *humidity / 100.0);
    addPressure(station, row, report);
    if (auto const water = table.number(row, "rre150z0", kMillimetres)) {
        report.rate_mm_h = *water * 3600.0 / kTenMinutes;
        if (*water == 0.0) report.precipitationKind = Precipitation::None;  // else: a gauge does not see what falls
    }
    report.radiation_w_m2 = table.number(row, "gre000z0", kRadiation);
    report.longwave_w_m2 = table.number(row, "oli000z0", kLongwave);
    if (auto const snow = table.number(row, "htoauts0", kCentimetres)) report.snowDepth_m = *snow / 100.0;
    if (report.rate_mm_h || report.gust_mps || report.radiation_w_m2 || report.longwave_w_m2) report.interval_s = kTenMinutes;
    return report;
}

/// `rowOf` gets the row of each report.
Site siteOf(Station station, std::string_view abbreviation, std::vector<std::size_t>& rowOf) {
    Site site;
    auto const known = swissStation(abbreviation);
    site.name = known ? known->name : oneLine(abbreviation, 60);
    if (known) site.lat_deg = known->lat_deg, site.lon_deg = known->lon_deg, site.elevation_m = known->elevation_m;
    station.elevation = site.elevation_m;
    std::map<core::UtcSeconds, std::size_t> byTime;
    for (std::size_t const row : station.rows) {
        auto const time = swissTime(station.table.text(row, station.timeColumn));
        std::string const place = station.table.place(row, station.timeColumn);
        if (!time) throw core::Error(station.table.file(), place, "expected a time such as \"21.06.2023 00:10\" or \"20230621001000\"");
        if (!byTime.emplace(*time, row).second)
            throw core::Error(station.table.file(), place, fmt::format("expected {} once for {}", core::formatUtc(*time), site.name));
    }
    for (auto const& [time, row] : byTime) {
        Report report = reportOf(station, row, time);
        if (!saysSomething(report)) continue;
        site.reports.push_back(std::move(report));
        rowOf.push_back(row);
    }
    return site;
}

bool isTenMinutes(std::string_view heading) {
    bool const station =
        heading.find("nat_abbr") != heading.npos || heading.find("station_abbr") != heading.npos || heading.starts_with("Station/Location;");
    bool parameter = false;
    for (std::string_view const name : {"tre200s0", "dkl010z0", "fkl010z0", "rre150z0", "gre000z0", "prestas0", "pp0qffs0", "fu3010z0"})
        parameter = parameter || heading.find(name) != heading.npos;
    return station && parameter && heading.find(';') != heading.npos;
}
bool isObserver(std::string_view heading) { return heading.starts_with("termin_utc,") && heading.find("okta") != heading.npos; }
bool isSounding(std::string_view bytes) {
    std::string_view const head = bytes.substr(0, 1000);
    return head.find(";zzzztttt;") != head.npos && head.find("zreppzs0") != head.npos;
}
}  // namespace

std::optional<SwissStation> swissStation(std::string_view key) {
    for (SwissStation const& station : kStations)
        if (station.abbreviation == key || station.wmo == key) return station;
    return std::nullopt;
}

std::optional<core::UtcSeconds> swissTime(std::string_view text) {
    auto const part = [text](std::size_t from, std::size_t count) { return text.substr(from, count); };
    if (text.size() == 16 && text[2] == '.' && text[5] == '.' && text[10] == ' ')
        return core::parseUtc(fmt::format("{}-{}-{}T{}Z", part(6, 4), part(3, 2), part(0, 2), part(11, 5)));
    if (text.size() != 12 && text.size() != 14) return std::nullopt;
    std::string const seconds = text.size() == 14 ? fmt::format(":{}", part(12, 2)) : std::string{};
    return core::parseUtc(fmt::format("{}-{}-{}T{}:{}{}Z", part(0, 4), part(4, 2), part(6, 2), part(8, 2), part(10, 2), seconds));
}

Recording parseTenMinutes(std::string_view bytes, std::string const& file) {
    CsvTable const table{bytes, ';', 0, file};
    std::string_view const stationColumn = columnAmong(table, {"nat_abbr", "station_abbr", "Station/Location"});
    std::string_view const timeColumn = columnAmong(table, {"termin", "reference_timestamp", "Date"});
    if (stationColumn.empty() || timeColumn.empty())
        throw core::Error(file, "line 1", "expected columns of a station and a time (termin or reference_timestamp)");
    std::vector<std::string_view> order;
    std::map<std::string_view, std::vector<std::size_t>> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        std::string_view const name = table.text(row, stationColumn);
        if (name.empty()) throw core::Error(file, table.place(row, stationColumn), "expected a station");
        auto& own = rows[name];
        if (own.empty()) order.push_back(name);
        own.push_back(row);
        if (order.size() > kMostSites)
            throw core::Error(file, table.place(row, stationColumn), fmt::format("expected at most {} stations", kMostSites));
    }
    Recording recording{file, {}, "MeteoSwiss (automatic stations)", "Source: MeteoSwiss (open data)", sha256Hex(bytes), {}, {}};
    std::map<std::size_t, ListedReport> listed;
    for (std::string_view const name : order) {
        std::vector<std::size_t> rowOf;
        Site site = siteOf({.table = table, .timeColumn = timeColumn, .rows = rows[name], .elevation = {}}, name, rowOf);
        for (std::size_t i = 0; i < rowOf.size(); ++i) listed[rowOf[i]] = {recording.sites.size(), i, false};
        if (!site.reports.empty()) recording.sites.push_back(std::move(site));
    }
    for (auto const& [row, report] : listed) recording.order.push_back(report);
    checkCounts(recording.sites, file);
    if (recording.sites.empty()) throw core::Error(file, "", "expected at least one row with a value that is read here");
    Site const& first = recording.sites.front();
    recording.name = fmt::format("{}{}, {}", first.name, recording.sites.size() > 1 ? fmt::format(" and {} more", recording.sites.size() - 1) : "",
                                 dayName(first.reports.front().time));
    return recording;
}

bool looksLikeMeteoSwiss(std::string_view bytes) {
    std::string_view const heading = firstLine(bytes).substr(0, 4000);
    return isTenMinutes(heading) || isObserver(heading) || isSounding(bytes);
}

Recording parseMeteoSwiss(std::string_view bytes, std::string const& file) {
    std::string_view const heading = firstLine(bytes).substr(0, 4000);
    if (isObserver(heading)) return parseObserver(bytes, file);
    if (isSounding(bytes)) return parseSounding(bytes, file);
    if (isTenMinutes(heading)) return parseTenMinutes(bytes, file);
    throw core::Error(file, "line 1", "expected the heading of MeteoSwiss' ten-minute values, an observer's or a sounding");
}
}  // namespace luftpost::weather
